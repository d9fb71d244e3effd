#include "lib/geometry/clipped_cells.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "lib/geometry/flat_pieces.hpp"
#include "lib/geometry/simplex.hpp"
#include "lib/geometry/voronoi_cells.hpp"

namespace plumb {
namespace {

/// Longest edge of a simplex that is cut, in mean spacings.
template <int d>
constexpr double finest = d == 2 ? 0.125 : 0.25;
/// Corners nearer to the surface than this (in spacings) are on it: well above the rounding of coordinates.
constexpr double touching = 1e-10;
/// Pieces of surface whose normals differ by less than 45 degrees make one facet: a cell at a curved surface
/// turns by d/R, at an edge of a body mostly by more.
constexpr double same_side = 0.7;

/// Two faces of planes are one if their normals agree but for rounding.
constexpr double same_plane = 1 - 1e-12;
/// Where more planes meet, as at the tip of a cone of triangles, they are cut as curved surfaces are.
constexpr std::size_t most_planes = 6;

/// A piece of the surface in one cell.
template <int d>
struct Piece {
  Vec<d> area, moment;  ///< moment: centroid times |area|
  double size;          ///< |area|, summed
};

/// What is collected for one cell while its simplices are clipped.
template <int d>
struct Clipper {
  const Shape<d>& shape;
  double spacing;
  Vec<d> wall_normal = Vec<d>::Zero();  ///< of the box at the face that is being clipped
  bool flat = false;                    ///< the particle lies on that face, and its simplices have no volume
  double volume = 0;
  Vec<d> moment = Vec<d>::Zero();
  std::vector<Piece<d>> pieces = {};
  std::vector<Plane<d>> planes = {};  ///< of flat pieces near the simplex that is being cut

  double distance(const Vec<d>& X) const {
    const double found = shape.clip(X);
    return std::abs(found) < touching * spacing ? 0 : found;
  }

  void add_face(const Simplex<d>& s, int opposite, const Vec<d>& area, double same) {
    const double size = area.norm();
    if (!(size > 0)) return;
    for (auto& piece : pieces)
      if (piece.area.dot(area) > same * piece.area.norm() * size) {
        piece.area += area;
        piece.moment += size * s.face_middle(opposite);
        piece.size += size;
        return;
      }
    pieces.push_back({area, size * s.face_middle(opposite), size});
  }

  bool lies_on(const Plane<d>& plane, const Vec<d>& X) const {
    return std::abs(plane.side(X)) < touching * spacing;
  }
  /// Whether holds(c) for all corners of the face opposite to one.
  template <class Holds>
  static bool all_of_face(int opposite, Holds&& holds) {
    for (int c = 0; c <= d; ++c)
      if (c != opposite && !holds(c)) return false;
    return true;
  }

  /// Whether the face opposite to a corner is a part of a flat piece of the surface; nullopt if a corner of it
  /// is on none of them, as at a curved one.
  std::optional<bool> is_flat_surface(const Simplex<d>& s, int opposite) const {
    for (const auto& plane : planes)
      if (all_of_face(opposite, [&](int c) { return lies_on(plane, s.corner[c]); }))
        return distance(s.face_middle(opposite)) == 0;
    const bool chord = all_of_face(opposite, [&](int c) {
      return std::any_of(planes.begin(), planes.end(),
                         [&](const auto& p) { return lies_on(p, s.corner[c]); });
    });
    return chord ? std::optional(false) : std::nullopt;
  }

  /// A simplex that is inside. Its face on a curved surface is the one whose corners all touch it.
  void keep(const Simplex<d>& s) {
    const double part = s.volume();
    volume += part;
    moment += part * s.middle();
    if (s.wall >= 0) {
      const Vec<d> area = s.face(s.wall);
      add_face(s, s.wall, area.dot(wall_normal) < 0 ? Vec<d>(-area) : area, same_side);
    }
    if (flat) return;
    const bool one = std::count(s.distance.begin(), s.distance.end(), 0.0) == d;
    for (int c = 0; c <= d; ++c) {
      if (c == s.wall || !all_of_face(c, [&](int k) { return s.distance[k] == 0; })) continue;
      const std::optional<bool> of_plane = is_flat_surface(s, c);
      if (of_plane.value_or(one)) add_face(s, c, s.face(c), of_plane ? same_plane : same_side);
    }
  }

  /// Where the edge from a point inside to one outside meets the surface (false position, Illinois).
  Vec<d> crossing(const Vec<d>& inside, double f_inside, const Vec<d>& outside, double f_outside) const {
    double lower = 0, upper = 1, f_lower = f_inside, f_upper = f_outside, t = 0.5;
    int last = 0;
    for (int pass = 0; pass < 40; ++pass) {
      t = (lower * f_upper - upper * f_lower) / (f_upper - f_lower);
      const double f = distance(inside + t * (outside - inside));
      if (f == 0) break;
      if (f < 0) {
        lower = t;
        f_lower = f;
        if (last < 0) f_upper *= 0.5;
        last = -1;
      } else {
        upper = t;
        f_upper = f;
        if (last > 0) f_lower *= 0.5;
        last = 1;
      }
    }
    return inside + t * (outside - inside);
  }

  /// Cuts until no edge crosses the surface.
  void cut(const Simplex<d>& s) {
    for (int a = 0; a <= d; ++a)
      for (int b = 0; b <= d; ++b)
        if (s.distance[a] < 0 && s.distance[b] > 0) {
          const Vec<d> point = crossing(s.corner[a], s.distance[a], s.corner[b], s.distance[b]);
          cut(s.half(b, a, point, 0));
          cut(s.half(a, b, point, 0));
          return;
        }
    if (std::any_of(s.distance.begin(), s.distance.end(), [](double x) { return x < 0; })) {
      keep(s);
    } else if (std::all_of(s.distance.begin(), s.distance.end(), [](double x) { return x == 0; })) {
      if (shape.clip(s.middle()) < 0) keep(s);
    }
  }

  /// Cuts along the planes from the n-th on, so that no piece reaches across one, and then along what is
  /// curved.
  void cut_along(const Simplex<d>& s, std::size_t n) {
    if (n == planes.size()) return cut(s);
    std::array<double, d + 1> side;
    for (int c = 0; c <= d; ++c) {
      side[c] = planes[n].side(s.corner[c]);
      if (std::abs(side[c]) < touching * spacing) side[c] = 0;
    }
    for (int a = 0; a <= d; ++a)
      for (int b = 0; b <= d; ++b)
        if (side[a] < 0 && side[b] > 0) {
          const Vec<d> point = s.corner[a] + side[a] / (side[a] - side[b]) * (s.corner[b] - s.corner[a]);
          const double there = distance(point);
          cut_along(s.half(b, a, point, there), n);
          cut_along(s.half(a, b, point, there), n);
          return;
        }
    cut_along(s, n + 1);
  }

  /// Halves until the simplex is away from the surface or small.
  void clip(const Simplex<d>& s) {
    const Vec<d> middle = s.middle();
    double radius = 0;
    for (const auto& corner : s.corner) radius = std::max(radius, (corner - middle).norm());
    const double there = shape.clip(middle);
    if (there > radius) return;
    if (there < -radius) return keep(s);
    const auto [edge, length] = s.longest_edge();
    if (length < finest<d> * spacing) {
      planes.clear();
      planes_near(shape, middle, radius, planes);
      if (planes.size() > most_planes) planes.clear();
      return cut_along(s, 0);
    }
    const Vec<d> point = 0.5 * (s.corner[edge.first] + s.corner[edge.second]);
    const double of_point = distance(point);
    clip(s.half(edge.first, edge.second, point, of_point));
    clip(s.half(edge.second, edge.first, point, of_point));
  }
};

/// Facets of a cell. The owner lies on one if it lies on the surface and the facet is beside it, not across.
template <int d>
void append_facets(const Clipper<d>& clipper, const Vec<d>& X, Index owner, std::vector<Facet<d>>& facets) {
  const bool touches = std::abs(clipper.shape.distance(X)) < 1e-9 * clipper.spacing;
  for (const auto& piece : clipper.pieces) {
    Facet<d> facet{owner, piece.moment / piece.size, piece.area};
    const double depth = std::abs((facet.centroid - X).dot(piece.area)) / piece.area.norm();
    facet.depth = touches && depth < 0.2 * clipper.spacing ? 0 : depth;
    facets.push_back(facet);
  }
}

/// Clips one cell: a fan of simplices from the particle to each face.
template <int d>
void clip_cell(Clipper<d>& clipper, const Vec<d>& X, const VoronoiCell<d>& cell) {
  for (std::size_t n = 0; n < cell.faces.size(); ++n) {
    const auto& face = cell.faces[n];
    clipper.wall_normal = Vec<d>::Zero();
    if (const auto wall = -1 - cell.beyond[n]; wall >= 0) clipper.wall_normal[wall / 2] = wall % 2 ? 1 : -1;
    clipper.flat =
        cell.beyond[n] < 0 && std::abs(clipper.wall_normal.dot(face[0] - X)) < 1e-9 * clipper.spacing;
    for (std::size_t k = 1; k + 1 < face.size() + (d == 2 ? 1 : 0); ++k) {
      Simplex<d> s;
      s.corner[0] = X;
      s.corner[1] = face[0];
      s.corner[2] = face[k];
      if constexpr (d == 3) s.corner[3] = face[k + 1];
      for (int c = 0; c <= d; ++c) s.distance[c] = clipper.distance(s.corner[c]);
      s.wall = cell.beyond[n] < 0 ? 0 : -1;
      clipper.clip(s);
    }
  }
}

}  // namespace

template <int d>
ClippedCells<d> clipped_cells(const std::vector<Vec<d>>& X, const Shape<d>& shape) {
  ClippedCells<d> cells{std::vector<double>(X.size(), 0.0), X, {}};
  const double spacing = std::pow(shape.box.size.prod() / static_cast<double>(X.size()), 1.0 / d);
  Shape<d> whole = shape;
  if (!whole.clip) whole.clip = [](const Vec<d>&) { return -std::numeric_limits<double>::infinity(); };
  for_each_voronoi_cell<d>(X, shape.box, true, [&](const VoronoiCell<d>& cell) {
    Clipper<d> clipper{whole, spacing};
    clip_cell(clipper, X[cell.owner], cell);
    cells.volume[cell.owner] = clipper.volume;
    if (clipper.volume > 0) cells.centroid[cell.owner] = clipper.moment / clipper.volume;
    append_facets(clipper, X[cell.owner], cell.owner, cells.facets);
  });
  std::stable_sort(cells.facets.begin(), cells.facets.end(),
                   [](const Facet<d>& a, const Facet<d>& b) { return a.owner < b.owner; });
  return cells;
}

template ClippedCells<2> clipped_cells<2>(const std::vector<Vec<2>>&, const Shape<2>&);
template ClippedCells<3> clipped_cells<3>(const std::vector<Vec<3>>&, const Shape<3>&);

}  // namespace plumb
