#include "reports/plot/prepare.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "reports/plot/check.hpp"

namespace plumb::reports::plot {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

/// Smallest and largest value met so far; values that an axis cannot show are passed over.
struct Extent {
  bool log = false;
  double low = inf, high = -inf;
  void add(double value) {
    if (!std::isfinite(value) || (log && value <= 0)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void add(const std::vector<double>& values) {
    for (double v : values) add(v);
  }
};

Range padded(Extent extent, const Axis& axis, double padding) {
  if (!(extent.low <= extent.high)) extent.low = extent.high = 1;
  Range range{extent.low, extent.high, extent.log};
  if (extent.low == extent.high) {
    const double half = extent.low == 0 ? 1 : std::abs(extent.low) / 2;
    range.low = extent.log ? extent.low / 2 : extent.low - half;
    range.high = extent.log ? extent.high * 2 : extent.high + half;
  }
  const Range tight = range;
  range.low = axis.min.value_or(tight.value(-padding));
  range.high = axis.max.value_or(tight.value(1 + padding));
  return range;
}

/// The axis of a map ends where its outer cells end; its numbers stand at the grid points if they have room.
void add_cells(Extent& extent, std::vector<double>& borders, Axis& axis, const std::vector<double>& grid) {
  borders = cell_borders(grid, extent.log);
  extent.add(borders);
  const Range range{borders.front(), borders.back(), extent.log};
  double narrowest = 1;
  for (std::size_t i = 1; i < grid.size(); ++i)
    narrowest = std::min(narrowest, range.fraction(grid[i]) - range.fraction(grid[i - 1]));
  if (axis.ticks.empty() && narrowest > 0.07) axis.ticks = grid;
}

void set_ranges(Prepared& p) {
  Extent x{p.picture.x.scale == Scale::log}, y{p.picture.y.scale == Scale::log};
  for (const auto& series : p.picture.series) {
    x.add(series.x);
    y.add(series.y);
    if (series.band) {
      y.add(series.band->low);
      y.add(series.band->high);
    }
  }
  for (const auto& line : p.picture.lines) (line.vertical ? x : y).add(line.at);
  x.add(p.picture.x.ticks);
  y.add(p.picture.y.ticks);
  const auto add_map = [&](const auto& map) {
    add_cells(x, p.x_borders, p.picture.x, map.x);
    add_cells(y, p.y_borders, p.picture.y, map.y);
  };
  const bool has_map = !std::holds_alternative<std::monostate>(p.picture.map);
  if (const auto* map = std::get_if<HeatMap>(&p.picture.map)) add_map(*map);
  if (const auto* map = std::get_if<CategoryMap>(&p.picture.map)) add_map(*map);
  if (const auto* map = std::get_if<PointMap>(&p.picture.map))
    for (const double side : {-0.5, 0.5})
      for (std::size_t k = 0; k < map->x.size(); ++k) {
        x.add(map->x[k] + side * map->size);
        y.add(map->y[k] + side * map->size);
      }
  if (const auto* rows = std::get_if<Intervals>(&p.picture.map)) {
    for (const auto* values : {&rows->low, &rows->value, &rows->high, &rows->expected}) x.add(*values);
    y.add(-0.6);
    y.add(static_cast<double>(rows->names.size()) - 0.4);
  }
  if (const auto* map = std::get_if<Patches>(&p.picture.map)) {
    x.add(map->x);
    y.add(map->y);
  }
  p.x = padded(x, p.picture.x, has_map ? 0 : 0.03);
  p.y = padded(y, p.picture.y, has_map ? 0 : 0.06);
}

/// Height of the line of `series` at x, by interpolation on the axes as drawn.
double line_fraction(const Prepared& p, const Series& series, double x) {
  std::vector<std::pair<double, double>> points;
  for (std::size_t k = 0; k < series.x.size(); ++k)
    points.emplace_back(p.x.fraction(series.x[k]), p.y.fraction(series.y[k]));
  std::sort(points.begin(), points.end());
  // cppcheck-suppress containerOutOfBounds ; a series without points was refused before
  if (x <= points.front().first) return points.front().second;
  for (std::size_t k = 1; k < points.size(); ++k) {
    const auto& [x0, y0] = points[k - 1];
    const auto& [x1, y1] = points[k];
    if (x <= x1) return x1 == x0 ? y1 : y0 + (y1 - y0) * (x - x0) / (x1 - x0);
  }
  return points.back().second;
}

/// Puts each triangle a little below its line, over the middle of the series, and lowers the axis if it needs
/// room.
void place_triangles(Prepared& p) {
  double lowest = p.y.low;
  for (const auto& wanted : p.picture.triangles) {
    const auto& series = p.picture.series[wanted.series];
    const auto [first, last] = std::minmax_element(series.x.begin(), series.x.end());
    const double centre = (p.x.fraction(*first) + p.x.fraction(*last)) / 2;
    Triangle t;
    t.order = wanted.order;
    t.x[0] = p.x.value(centre - 0.11);
    t.x[1] = p.x.value(centre + 0.11);
    const double rise = std::pow(t.x[1] / t.x[0], wanted.order);
    const double gap = 0.06;
    const auto under = [&](double x) {
      double least = 1;
      for (const auto& other : p.picture.series) least = std::min(least, line_fraction(p, other, x));
      return p.y.value(least - gap);
    };
    const double under0 = under(centre - 0.11), under1 = under(centre + 0.11);
    t.y[0] = std::min(under0, under1 / rise);
    t.y[1] = t.y[0] * rise;
    t.x[2] = wanted.order > 0 ? t.x[1] : t.x[0];
    t.y[2] = std::min(t.y[0], t.y[1]);
    lowest = std::min(lowest, p.y.value(p.y.fraction(t.y[2]) - 0.07));
    p.triangles.push_back(t);
  }
  if (!p.picture.y.min) p.y.low = lowest;
}

/// Labels at the right ends of the lines, moved apart until none covers another.
void place_labels(Prepared& p, double area_height) {
  for (std::size_t s = 0; s < p.picture.series.size(); ++s) {
    const auto& series = p.picture.series[s];
    if (series.label.empty()) continue;
    const auto at =
        static_cast<std::size_t>(std::max_element(series.x.begin(), series.x.end()) - series.x.begin());
    p.labels.push_back({s, series.x[at], series.y[at], std::clamp(p.y.fraction(series.y[at]), 0.0, 1.0)});
  }
  const auto higher = [](const EndLabel& a, const EndLabel& b) { return a.height > b.height; };
  std::stable_sort(p.labels.begin(), p.labels.end(), higher);
  const double gap = line_px / area_height;
  double ceiling = 1 + gap / 2;
  for (auto& label : p.labels) ceiling = (label.height = std::min(label.height, ceiling)) - gap;
  double floor = -gap / 2;
  for (auto label = p.labels.rbegin(); label != p.labels.rend(); ++label)
    floor = (label->height = std::max(label->height, floor)) + gap;
}

void set_margins(Prepared& p) {
  const Picture& picture = p.picture;
  p.title = wrap(picture.title, static_cast<std::size_t>((picture.width - 20) / (letter_px * 1.08)));
  const double notes = line_px * static_cast<double>(p.dropped.size());
  p.margins = {76, 16, 24 + line_px * static_cast<double>(p.title.size()), 60 + notes};
  std::size_t longest = 0;
  for (const auto& series : picture.series) longest = std::max(longest, letters(series.label));
  if (const auto* map = std::get_if<CategoryMap>(&picture.map))
    for (const auto& name : map->names) longest = std::max(longest, letters(name));
  const double wide = static_cast<double>(longest) * letter_px;
  const bool category = std::holds_alternative<CategoryMap>(picture.map);
  const bool body = std::holds_alternative<Patches>(picture.map);
  if (body || std::holds_alternative<HeatMap>(picture.map) || std::holds_alternative<PointMap>(picture.map))
    p.margins.right = 92;
  if (body) p.margins.left = 14, p.margins.bottom = 12 + notes;  // no axes
  if (const auto* rows = std::get_if<Intervals>(&picture.map)) {
    std::size_t name = 0;
    for (const auto& row : rows->names) name = std::max(name, letters(row));
    p.margins.left = std::min(20 + static_cast<double>(name) * letter_px, 0.62 * picture.width);
  }
  if (picture.labels == Labels::legend || category) {
    const std::size_t entries =
        picture.series.size() + (category ? std::get<CategoryMap>(picture.map).names.size() : 0);
    const double area = picture.width - p.margins.left - p.margins.right;
    p.legend_columns = std::max<std::size_t>(1, static_cast<std::size_t>(area / (1.15 * wide + 70)));
    p.legend_rows = (entries + p.legend_columns - 1) / p.legend_columns;
    p.margins.bottom += 6 + legend_px * static_cast<double>(p.legend_rows);
  } else if (longest > 0) {
    p.margins.right += std::min(wide + 14, 0.45 * picture.width);
  }
}

/// A long legend makes the picture higher, not the plot flat.
void keep_room(Prepared& p) {
  constexpr double least = 230;  // of the plot [pixels]
  const double left = p.picture.height - p.margins.top - p.margins.bottom;
  if (p.legend_rows > 0 && left < least) p.picture.height += static_cast<int>(least - left);
}

/// Widens one axis about its middle until a unit of x is as long as a unit of y.
void make_equal(Prepared& p) {
  const double width = p.picture.width - p.margins.left - p.margins.right;
  const double height = p.picture.height - p.margins.top - p.margins.bottom;
  const double units_per_pixel = std::max((p.x.high - p.x.low) / width, (p.y.high - p.y.low) / height);
  const auto widen = [](Range& range, double length) {
    const double middle = (range.low + range.high) / 2;
    range.low = middle - length / 2;
    range.high = middle + length / 2;
  };
  widen(p.x, units_per_pixel * width);
  widen(p.y, units_per_pixel * height);
}

}  // namespace

Prepared prepare(const Picture& picture) {
  check(picture);
  Prepared p;
  p.picture = picture;
  p.dropped = drop_impossible_points(p.picture);
  set_ranges(p);
  place_triangles(p);
  set_margins(p);
  keep_room(p);
  if (picture.equal_axes) make_equal(p);
  if (picture.labels == Labels::ends && !std::holds_alternative<CategoryMap>(picture.map))
    place_labels(p, p.picture.height - p.margins.top - p.margins.bottom);
  return p;
}

}  // namespace plumb::reports::plot
