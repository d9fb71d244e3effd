#include "reports/plot/check.hpp"

#include <fmt/format.h>

#include <cmath>

#include "lib/core/error.hpp"

namespace plumb::reports::plot {
namespace {

void check_size(const Picture& picture) {
  if (picture.width >= 200 && picture.width <= 8000 && picture.height >= 150 && picture.height <= 8000)
    return;
  throw InputError(fmt::format("a picture of {} x {} pixels cannot be drawn", picture.width, picture.height),
                   "it must be from 200 x 150 to 8000 x 8000", "Choose another size.");
}

void check_axis(const Axis& axis, const char* which) {
  const auto problem = fmt::format("the {} axis \"{}\" cannot be drawn", which, axis.label);
  for (const auto& end : {axis.min, axis.max}) {
    if (!end) continue;
    if (!std::isfinite(*end))
      throw InputError(problem, "one of its ends is not finite", "Leave the end to the data.");
    if (axis.scale == Scale::log && *end <= 0)
      throw InputError(problem, fmt::format("it is logarithmic and ends at {:g}", *end),
                       "Use a positive end.");
  }
  if (axis.min && axis.max && *axis.min >= *axis.max)
    throw InputError(problem, "its low end is not below its high end", "Exchange them.");
}

void check_series(const Series& series) {
  const bool band_fits = !series.band || (series.band->low.size() == series.x.size() &&
                                          series.band->high.size() == series.x.size());
  if (series.x.size() == series.y.size() && band_fits) return;
  throw InputError(fmt::format("series \"{}\" cannot be drawn", series.label),
                   fmt::format("it has {} x, {} y{}", series.x.size(), series.y.size(),
                               band_fits ? "" : " and a band of another length"),
                   "Give lists of one length.");
}

template <class Map>
void check_map(const Map& map, const Axis& x, const Axis& y) {
  if (map.z.size() != map.x.size() * map.y.size() || map.z.empty())
    throw InputError(
        "the map cannot be drawn",
        fmt::format("{} x {} grid points and {} values", map.x.size(), map.y.size(), map.z.size()),
        "Give one value for each grid point.");
  const auto rising = [](const std::vector<double>& v, bool log) {
    for (std::size_t i = 0; i < v.size(); ++i)
      if (!std::isfinite(v[i]) || (log && v[i] <= 0) || (i > 0 && v[i] <= v[i - 1])) return false;
    return true;
  };
  if (!rising(map.x, x.scale == Scale::log) || !rising(map.y, y.scale == Scale::log))
    throw InputError("the map cannot be drawn",
                     "its grid must rise, be finite, and be positive on logarithmic axes", "Sort the grid.");
}

void check_intervals(const Intervals& rows) {
  const std::size_t n = rows.names.size();
  if (n > 0 && rows.low.size() == n && rows.value.size() == n && rows.high.size() == n &&
      rows.expected.size() == n)
    return;
  throw InputError("the intervals cannot be drawn",
                   fmt::format("{} names, {} low, {} and {} high ends, {} values expected", n,
                               rows.low.size(), rows.value.size(), rows.high.size(), rows.expected.size()),
                   "Give lists of one length.");
}

}  // namespace

void check(const Picture& picture) {
  check_size(picture);
  check_axis(picture.x, "x");
  check_axis(picture.y, "y");
  for (const auto& series : picture.series) check_series(series);
  if (const auto* map = std::get_if<HeatMap>(&picture.map)) check_map(*map, picture.x, picture.y);
  if (const auto* map = std::get_if<PointMap>(&picture.map))
    if (map->x.empty() || map->x.size() != map->y.size() || map->x.size() != map->z.size() ||
        !(map->size > 0))
      throw InputError("the body cannot be drawn",
                       fmt::format("{} and {} positions, {} values, size {}", map->x.size(), map->y.size(),
                                   map->z.size(), map->size),
                       "Give one value for each position and a positive size.");
  if (const auto* rows = std::get_if<Intervals>(&picture.map)) check_intervals(*rows);
  if (const auto* map = std::get_if<Patches>(&picture.map))
    if (map->z.empty() || map->x.size() != 4 * map->z.size() || map->y.size() != map->x.size())
      throw InputError(
          "the body cannot be drawn",
          fmt::format("{} and {} corners, {} values", map->x.size(), map->y.size(), map->z.size()),
          "Give four corners for each value.");
  if (const auto* map = std::get_if<CategoryMap>(&picture.map)) {
    check_map(*map, picture.x, picture.y);
    for (int z : map->z)
      if (z >= static_cast<int>(map->names.size()))
        throw InputError("the map cannot be drawn", fmt::format("category {} has no name", z),
                         "Name every category.");
  }
  if (picture.series.empty() && std::holds_alternative<std::monostate>(picture.map))
    throw InputError(fmt::format("picture \"{}\" cannot be drawn", picture.title), "it has no data",
                     "Add a series.");
  if (picture.equal_axes && (picture.x.scale == Scale::log || picture.y.scale == Scale::log))
    throw InputError(fmt::format("picture \"{}\" cannot be drawn", picture.title),
                     "equal lengths on both axes have no meaning on a logarithmic one", "Use linear axes.");
  const bool log_log = picture.x.scale == Scale::log && picture.y.scale == Scale::log;
  for (const auto& triangle : picture.triangles)
    if (!log_log || triangle.series >= picture.series.size())
      throw InputError(fmt::format("a triangle of slope {:g} cannot be drawn", triangle.order),
                       "it needs two logarithmic axes and a series above it", "Make both axes logarithmic.");
}

std::vector<Dropped> drop_impossible_points(Picture& picture) {
  std::vector<Dropped> dropped;
  const bool log_x = picture.x.scale == Scale::log;
  const bool log_y = picture.y.scale == Scale::log;
  for (auto& series : picture.series) {
    Series kept = series;
    kept.x.clear();
    kept.y.clear();
    if (kept.band) kept.band = Band{};
    bool finite_lost = false, positive_lost = false;
    for (std::size_t k = 0; k < series.x.size(); ++k) {
      const double x = series.x[k], y = series.y[k];
      const bool finite = std::isfinite(x) && std::isfinite(y);
      const bool positive = !(log_x && x <= 0) && !(log_y && y <= 0);
      finite_lost = finite_lost || !finite;
      positive_lost = positive_lost || (finite && !positive);
      if (!finite || !positive) continue;
      kept.x.push_back(x);
      kept.y.push_back(y);
      if (kept.band) {
        kept.band->low.push_back(series.band->low[k]);
        kept.band->high.push_back(series.band->high[k]);
      }
    }
    const std::size_t lost = series.x.size() - kept.x.size();
    const std::string why = finite_lost && positive_lost ? "not finite, or not positive on a logarithmic axis"
                            : finite_lost                ? "not finite"
                                                         : "not positive on a logarithmic axis";
    if (kept.x.empty())
      throw InputError(fmt::format("series \"{}\" cannot be drawn", series.label),
                       lost == 0 ? "it has no points" : fmt::format("all {} points are {}", lost, why),
                       lost == 0 ? "Give it points." : "Use a linear axis or leave the series out.");
    if (lost > 0) dropped.push_back({series.label, lost, why});
    series = std::move(kept);
  }
  return dropped;
}

}  // namespace plumb::reports::plot
