// What makes triangles the surface of a body: require_closed() of closed_surface.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "lib/core/error.hpp"
#include "lib/geometry/box_tree.hpp"
#include "lib/geometry/closed_surface.hpp"
#include "lib/geometry/position_text.hpp"
#include "lib/geometry/triangles_meet.hpp"

namespace plumb {
namespace {

using Edge = std::pair<std::size_t, std::size_t>;

std::string place_of(const TriangleMesh& mesh, const Edge& edge) {
  return position_text<3>(mesh.points[edge.first]) + " to " + position_text<3>(mesh.points[edge.second]);
}

void refuse_empty_triangles(const TriangleMesh& mesh) {
  for (std::size_t t = 0; t < mesh.corner.size(); ++t) {
    const Corners x = corners_of(mesh, t);
    const Vec<3> a = x[1] - x[0], b = x[2] - x[0];
    // 1e-12: its normal is lost in the rounding of the corners
    if (a.cross(b).norm() > 1e-12 * a.norm() * b.norm() && x[1] != x[2]) continue;
    throw InputError(fmt::format("triangle {} at {} has no area", t + 1, position_text<3>(x[0])),
                     "it has no side that is outside", "take it out and close the surface without it");
  }
}

/// The two triangles at each edge.
std::map<Edge, std::array<std::size_t, 2>> pairs_at_edges(const TriangleMesh& mesh) {
  std::map<Edge, std::vector<std::size_t>> at;
  for (std::size_t t = 0; t < mesh.corner.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      at[std::minmax(mesh.corner[t][k], mesh.corner[t][(k + 1) % 3])].push_back(t);
  std::map<Edge, std::array<std::size_t, 2>> pairs;
  for (const auto& [edge, triangles] : at) {
    if (triangles.size() == 1)
      throw InputError("the surface is open at the edge from " + place_of(mesh, edge),
                       "one triangle is there: inside and outside are not apart",
                       "close it; corners that belong together must have the same coordinates");
    if (triangles.size() > 2)
      throw InputError(
          fmt::format("{} triangles meet at the edge from {}", triangles.size(), place_of(mesh, edge)),
          "a surface has two sides at an edge", "take doubled triangles and inner walls out");
    pairs[edge] = {triangles[0], triangles[1]};
  }
  return pairs;
}

/// Whether the triangle runs along its edge from the first to the second point.
bool runs_along(const std::array<std::size_t, 3>& corner, const Edge& edge) {
  for (std::size_t k = 0; k < 3; ++k)
    if (corner[k] == edge.first && corner[(k + 1) % 3] == edge.second) return true;
  return false;
}

/// The number of the shell that each triangle belongs to; turns triangles until neighbours agree.
std::vector<std::size_t> shells_of(TriangleMesh& mesh,
                                   const std::map<Edge, std::array<std::size_t, 2>>& pairs) {
  std::vector<std::vector<std::pair<std::size_t, Edge>>> beside(mesh.corner.size());
  for (const auto& [edge, two] : pairs) {
    beside[two[0]].emplace_back(two[1], edge);
    beside[two[1]].emplace_back(two[0], edge);
  }
  constexpr std::size_t none = ~std::size_t{0};
  std::vector<std::size_t> shell(mesh.corner.size(), none);
  std::size_t count = 0;
  for (std::size_t start = 0; start < shell.size(); ++start) {
    if (shell[start] != none) continue;
    std::vector<std::size_t> waiting{start};
    shell[start] = count;
    while (!waiting.empty()) {
      const std::size_t t = waiting.back();
      waiting.pop_back();
      for (const auto& [next, edge] : beside[t]) {
        const bool agree = runs_along(mesh.corner[t], edge) != runs_along(mesh.corner[next], edge);
        if (shell[next] == none) {
          if (!agree) std::swap(mesh.corner[next][1], mesh.corner[next][2]);
          shell[next] = count;
          waiting.push_back(next);
        } else if (!agree) {
          throw InputError("the surface has one side only, seen at the edge from " + place_of(mesh, edge),
                           "it has no inside", "");
        }
      }
    }
    ++count;
  }
  return shell;
}

/// Refuses shells that touch themselves or each other in a point: the triangles around it are several fans.
void refuse_touching_corners(const TriangleMesh& mesh) {
  std::vector<std::size_t> triangles(mesh.points.size(), 0), joints(mesh.points.size(), 0);
  for (const auto& c : mesh.corner)
    for (const std::size_t k : c) ++triangles[k];
  // around a point of one fan each triangle has a next one; walk from one and count
  std::map<std::pair<std::size_t, std::size_t>, std::size_t>
      next;  // (point, point after it) -> point before it
  for (const auto& c : mesh.corner)
    for (std::size_t k = 0; k < 3; ++k) next[{c[k], c[(k + 1) % 3]}] = c[(k + 2) % 3];
  for (std::size_t p = 0; p < mesh.points.size(); ++p) {
    if (triangles[p] == 0) continue;
    const auto first = next.lower_bound({p, 0});
    std::size_t at = first->first.second;
    do {
      at = next.at({p, at});
      ++joints[p];
    } while (at != first->first.second && joints[p] <= triangles[p]);
    if (joints[p] != triangles[p])
      throw InputError("the surface touches itself at " + position_text<3>(mesh.points[p]),
                       "its inside is not defined there", "move the parts that touch apart, or join them");
  }
}

void refuse_meetings(const TriangleMesh& mesh) {
  std::vector<Corners> triangles;
  for (std::size_t t = 0; t < mesh.corner.size(); ++t) triangles.push_back(corners_of(mesh, t));
  const BoxTree tree(triangles);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Corners& x = triangles[t];
    const Vec<3> lower = x[0].cwiseMin(x[1]).cwiseMin(x[2]), upper = x[0].cwiseMax(x[1]).cwiseMax(x[2]);
    tree.meeting(lower, upper, [&](std::size_t other) {
      if (other <= t) return;
      std::array<bool, 3> mine{}, its{};
      for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t b = 0; b < 3; ++b)
          if (mesh.corner[t][a] == mesh.corner[other][b]) mine[a] = its[b] = true;
      if (!triangles_meet(x, mine, triangles[other], its)) return;
      throw InputError(fmt::format("the surface meets itself: triangles {} and {} near {}", t + 1, other + 1,
                                   position_text<3>((x[0] + x[1] + x[2]) / 3)),
                       "its inside is not defined there",
                       "give a surface whose triangles meet at edges only");
    });
  }
}

/// Six times the signed volume within a shell.
double six_volumes(const TriangleMesh& mesh, const std::vector<std::size_t>& shell, std::size_t number) {
  double sum = 0;
  const Vec<3>& origin = mesh.points[0];
  for (std::size_t t = 0; t < shell.size(); ++t) {
    if (shell[t] != number) continue;
    const Corners x = corners_of(mesh, t);
    sum += (x[0] - origin).cross(x[1] - origin).dot(x[2] - origin);
  }
  return sum;
}

/// Whether the point lies within the shell, by the solid angle under which it sees it (Van Oosterom and
/// Strackee 1983, IEEE Trans. Biomed. Eng. 30, 125).
bool is_within(const TriangleMesh& mesh, const std::vector<std::size_t>& shell, std::size_t number,
               const Vec<3>& X) {
  double angle = 0;
  for (std::size_t t = 0; t < shell.size(); ++t) {
    if (shell[t] != number) continue;
    const Corners x = corners_of(mesh, t);
    const Vec<3> a = x[0] - X, b = x[1] - X, c = x[2] - X;
    const double ra = a.norm(), rb = b.norm(), rc = c.norm();
    angle += 2 * std::atan2(a.cross(b).dot(c), ra * rb * rc + a.dot(b) * rc + b.dot(c) * ra + c.dot(a) * rb);
  }
  return std::abs(angle) > 2 * std::numbers::pi;  // 4 pi within, 0 without
}

/// Turns each shell so that its triangles are seen counterclockwise from where the body is not.
void turn_outside(TriangleMesh& mesh, const std::vector<std::size_t>& shell) {
  const std::size_t count = 1 + *std::max_element(shell.begin(), shell.end());
  std::vector<bool> turn;
  for (std::size_t s = 0; s < count; ++s) {
    const auto first = static_cast<std::size_t>(std::find(shell.begin(), shell.end(), s) - shell.begin());
    const Vec<3>& X = mesh.points[mesh.corner[first][0]];
    bool hollow = false;
    for (std::size_t around = 0; around < count; ++around)
      if (around != s && is_within(mesh, shell, around, X)) hollow = !hollow;
    turn.push_back((six_volumes(mesh, shell, s) < 0) != hollow);
  }
  for (std::size_t t = 0; t < shell.size(); ++t)
    if (turn[shell[t]]) std::swap(mesh.corner[t][1], mesh.corner[t][2]);
}

}  // namespace

void require_closed(TriangleMesh& mesh) {
  refuse_empty_triangles(mesh);
  const auto pairs = pairs_at_edges(mesh);
  const std::vector<std::size_t> shell = shells_of(mesh, pairs);
  refuse_touching_corners(mesh);
  refuse_meetings(mesh);
  turn_outside(mesh, shell);
}

}  // namespace plumb
