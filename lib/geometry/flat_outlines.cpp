#include "lib/geometry/flat_outlines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "lib/core/error.hpp"
#include "lib/geometry/crossing.hpp"
#include "lib/geometry/position_text.hpp"

namespace plumb {
namespace {

using Point = std::pair<double, double>;
using Outline = std::vector<Vec<2>>;

Vec<2> place_of(const Point& p) {
  return {p.first, p.second};
}

void refuse_height(const std::vector<std::array<Vec<3>, 3>>& triangles) {
  double low = triangles.front()[0][2], high = low, across = 0;
  for (const auto& t : triangles)
    for (const Vec<3>& X : t) {
      low = std::min(low, X[2]);
      high = std::max(high, X[2]);
      across = std::max(across, (X - triangles.front()[0]).head<2>().norm());
    }
  if (high - low > 1e-6 * across)
    throw InputError(fmt::format("its triangles reach from z = {:g} to z = {:g}", low, high),
                     "a body in 2D is what flat triangles cover",
                     "give the surface in the plane z = 0, or dimension = 3");
}

/// Edges that one triangle has, each with the body on its left: to where they lead by where they begin.
std::map<Point, Point> rim_of(const std::vector<std::array<Vec<3>, 3>>& triangles) {
  std::map<std::pair<Point, Point>, int> edges;
  for (const auto& t : triangles) {
    std::array<Point, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = {t[k][0] + 0.0, t[k][1] + 0.0};
    const double area = orientation(place_of(p[0]), place_of(p[1]), place_of(p[2]));
    if (area == 0) continue;
    if (area < 0) std::swap(p[1], p[2]);
    for (std::size_t k = 0; k < 3; ++k)
      if (++edges[{p[k], p[(k + 1) % 3]}] > 1)
        throw InputError("triangles lie on each other at the edge from " + position_text<2>(place_of(p[k])) +
                             " to " + position_text<2>(place_of(p[(k + 1) % 3])),
                         "the outline is that of triangles side by side", "take doubled triangles out");
  }
  std::map<Point, Point> rim;
  for (const auto& [edge, count] : edges) {
    if (edges.contains({edge.second, edge.first})) continue;
    if (!rim.emplace(edge.first, edge.second).second)
      throw InputError("the outline touches itself at " + position_text<2>(place_of(edge.first)),
                       "its inside is not defined there",
                       "move the parts apart, or join them; corners that belong together must have the same "
                       "coordinates");
  }
  return rim;
}

double twice_area(const Outline& outline) {
  double sum = 0;
  for (std::size_t k = 0; k < outline.size(); ++k)
    sum += orientation(outline[0], outline[k], outline[(k + 1) % outline.size()]);
  return sum;
}

void refuse_crossings(const std::vector<Outline>& outlines) {
  for (std::size_t a = 0; a < outlines.size(); ++a)
    for (std::size_t b = a + 1; b < outlines.size(); ++b)
      for (std::size_t k = 0; k < outlines[a].size(); ++k)
        for (std::size_t m = 0; m < outlines[b].size(); ++m)
          if (segments_meet(outlines[a][k], outlines[a][(k + 1) % outlines[a].size()], outlines[b][m],
                            outlines[b][(m + 1) % outlines[b].size()]))
            throw InputError("two outlines cross near " + position_text<2>(outlines[a][k]),
                             "triangles lie on each other there", "");
}

}  // namespace

std::vector<Outline> flat_outlines(const std::vector<std::array<Vec<3>, 3>>& triangles) {
  refuse_height(triangles);
  std::map<Point, Point> rim = rim_of(triangles);
  std::vector<Outline> outlines;
  while (!rim.empty()) {
    Outline outline;
    for (auto at = rim.begin(); at != rim.end(); at = rim.find(Point(outline.back()[0], outline.back()[1]))) {
      if (outline.empty()) outline.push_back(place_of(at->first));
      outline.push_back(place_of(at->second));
      rim.erase(at);
    }
    outline.pop_back();  // the first corner again
    outlines.push_back(std::move(outline));
  }
  if (outlines.empty()) throw InputError("its triangles cover nothing", "they have no area in x and y", "");
  std::stable_sort(outlines.begin(), outlines.end(),
                   [](const Outline& a, const Outline& b) { return twice_area(a) > twice_area(b); });
  if (outlines.size() > 1 && twice_area(outlines[1]) > 0)
    throw InputError("several bodies: one with a corner at " + position_text<2>(outlines[0][0]) +
                         ", another with one at " + position_text<2>(outlines[1][0]),
                     "a scene has one", "give each its own file and scene");
  refuse_crossings(outlines);
  return outlines;
}

}  // namespace plumb
