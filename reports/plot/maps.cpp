#include "reports/plot/maps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/palette.hpp"
#include "reports/plot/axes.hpp"

namespace plumb::reports::plot {

/// Cells of categories are framed in white, unless frames would be all that one sees.
constexpr std::size_t most_framed_rows = 24;
namespace {

template <class Map, class Value>
std::string cells(const Prepared& p, const Map& map, const std::string& name, Value&& value) {
  std::string out = "$" + name + " << EOD\n";
  for (std::size_t j = 0; j < map.y.size(); ++j)
    for (std::size_t i = 0; i < map.x.size(); ++i) {
      const std::string z = value(map.z[j * map.x.size() + i]);
      if (z.empty()) continue;
      out += fmt::format("{:.12g} {:.12g} {:.12g} {:.12g} {:.12g} {:.12g} {}\n", map.x[i], map.y[j],
                         p.x_borders[i], p.x_borders[i + 1], p.y_borders[j], p.y_borders[j + 1], z);
    }
  return out + "EOD\n";
}

/// The palette and the bar that explains it.
std::string colour_bar(const Prepared& p, bool log, const std::string& label) {
  std::string out;
  const double w = p.picture.width;
  for (std::size_t k = 0; k < heat_stops.size(); ++k)
    out += fmt::format("{}{} \"{}\"", k == 0 ? "set palette defined (" : ", ", k, heat_stops[k]);
  out += fmt::format(")\n{}set cblabel {} noenhanced\n",
                     log ? "set logscale cb\nset format cb \"10^{%T}\"\n" : "", literal(label));
  return out +
         fmt::format("set colorbox user origin screen {:.6f}, graph 0 size screen {:.6f}, graph 1 noborder\n",
                     1 - 80 / w, 14 / w);
}

/// The particles of a body as squares, one line each.
std::string body_cells(const PointMap& map) {
  std::string out = "$body << EOD\n";
  const double half = 0.5 * map.size;
  for (std::size_t k = 0; k < map.x.size(); ++k)
    if (std::isfinite(map.z[k]))
      out += fmt::format("{:.6g} {:.6g} {:.6g} {:.6g} {:.6g} {:.6g} {:.6g}\n", map.x[k], map.y[k],
                         map.x[k] - half, map.x[k] + half, map.y[k] - half, map.y[k] + half, map.z[k]);
  return out + "EOD\n";
}

/// The names of the rows, their values with intervals, and short strokes at what was expected.
std::string interval_rows(const Intervals& rows, std::vector<std::string>& plots) {
  std::string names, out;
  const auto n = rows.names.size();
  std::string met = "$met << EOD\n", missed = "$missed << EOD\n", wanted = "$wanted << EOD\n";
  bool any_met = false, any_missed = false, any_wanted = false;
  for (std::size_t k = 0; k < n; ++k) {
    const double at = static_cast<double>(n - 1 - k), expected = rows.expected[k];
    names += fmt::format("{}{} {}", k == 0 ? "" : ", ", literal(rows.names[k]), at);
    if (std::isfinite(expected)) {
      any_wanted = true;
      wanted += fmt::format("{:.12g} {} 0 0.7\n", expected, at - 0.35);
    }
    if (!std::isfinite(rows.value[k])) continue;
    const bool known = std::isfinite(rows.low[k]) && std::isfinite(rows.high[k]);
    const bool holds =
        !std::isfinite(expected) || (known && rows.low[k] <= expected && expected <= rows.high[k]);
    (holds ? any_met : any_missed) = true;
    (holds ? met : missed) +=
        fmt::format("{:.12g} {} {:.12g} {:.12g}\n", rows.value[k], at, known ? rows.low[k] : rows.value[k],
                    known ? rows.high[k] : rows.value[k]);
  }
  out += fmt::format("set ytics ({}) noenhanced\n{}EOD\n{}EOD\n{}EOD\n", names, met, missed, wanted);
  if (any_wanted) plots.emplace_back("$wanted with vectors nohead lw 3 lc rgb \"#808080\" notitle");
  const auto bars = [&plots](const char* data, const Ink& colour, int shape) {
    plots.push_back(fmt::format("{} with xerrorbars pt {} ps 0.7 lw 1.8 lc rgb \"{}\" notitle", data, shape,
                                colour.line));
  };
  if (any_met) bars("$met", ink(0), 7);
  if (any_missed) bars("$missed", ink(1), 9);
  return out;
}

/// The quadrilaterals of a surface in the order given, its rods and its colour bar.
std::string patches(const Prepared& p, const Patches& map, std::vector<std::string>& plots) {
  std::string out = colour_bar(p, false, with_unit(map.label, map.unit));
  out += "unset border\nunset xtics\nunset ytics\nunset grid\n$patches << EOD\n";
  double low = map.z[0], high = map.z[0];
  for (std::size_t k = 0; k < map.z.size(); ++k) {
    low = std::min(low, map.z[k]), high = std::max(high, map.z[k]);
    for (std::size_t c = 4 * k; c < 4 * k + 4; ++c)
      out += fmt::format("{:.6g} {:.6g} {:.5g}\n", map.x[c], map.y[c], map.z[k]);
    out += "\n";
  }
  low = map.low.value_or(low), high = map.high.value_or(high);
  out += fmt::format("EOD\nset cbrange [{:.12g}:{:.12g}]\n", low, high > low ? high : low + 1);
  for (const auto& rod : map.rods) {
    out += fmt::format(
        "set arrow from {:.6g},{:.6g} to {:.6g},{:.6g} filled size screen 0.012,20 lw 1.3 "
        "lc rgb \"#606060\"\n",
        rod.x0, rod.y0, rod.x1, rod.y1);
    out += fmt::format(
        "set label {} at {:.6g},{:.6g} {} noenhanced tc rgb \"#606060\"\n", literal(rod.label), rod.x1,
        rod.y1, rod.x1 < rod.x0 - 1e-9 * std::abs(rod.x1) ? "right offset -0.4,0" : "left offset 0.5,0.3");
  }
  plots.emplace_back("$patches using 1:2:3 with polygons fs solid noborder fc palette notitle");
  return out;
}

}  // namespace

std::string map_commands(const Prepared& p, std::vector<std::string>& plots) {
  std::string out;
  const std::string style = "using 1:2:3:4:5:6";
  if (const auto* map = std::get_if<HeatMap>(&p.picture.map)) {
    const bool log = map->scale == Scale::log;
    out += colour_bar(p, log, with_unit(map->label, map->unit));
    out += cells(p, *map, "map", [log](double z) {
      return std::isfinite(z) && !(log && z <= 0) ? fmt::format("{:.12g}", z) : std::string();
    });
    plots.push_back("$map " + style + ":7 with boxxyerror fs solid noborder lc palette notitle");
  }
  if (const auto* map = std::get_if<PointMap>(&p.picture.map)) {
    out += colour_bar(p, false, with_unit(map->label, map->unit)) + body_cells(*map);
    plots.push_back("$body " + style + ":7 with boxxyerror fs solid noborder lc palette notitle");
  }
  if (const auto* rows = std::get_if<Intervals>(&p.picture.map)) out += interval_rows(*rows, plots);
  if (const auto* map = std::get_if<Patches>(&p.picture.map)) out += patches(p, *map, plots);
  if (const auto* map = std::get_if<CategoryMap>(&p.picture.map))
    for (int c = 0; c < static_cast<int>(map->names.size()); ++c) {
      const auto mine = [c](int z) { return z == c ? std::string("1") : std::string(); };
      const bool used = std::find(map->z.begin(), map->z.end(), c) != map->z.end();
      out += cells(p, *map, fmt::format("map{}", c), mine);
      const bool few = map->y.size() <= most_framed_rows;
      plots.push_back(fmt::format(R"({} with boxxyerror fc rgb "{}" fs solid border lc rgb "{}" title {})",
                                  used ? fmt::format("$map{} {}", c, style) : "keyentry", ink(c).line,
                                  few ? "#ffffff" : ink(c).line, literal(map->names[c])));
    }
  return out;
}

}  // namespace plumb::reports::plot
