#include "reports/plot/script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/palette.hpp"
#include "reports/plot/axes.hpp"
#include "reports/plot/maps.hpp"

namespace plumb::reports::plot {
namespace {

constexpr int point_shapes[] = {7, 5, 9, 11, 13, 6, 4, 8};
constexpr const char* dashes[] = {"solid", "(9,4)", "(2,4)", "(9,3,2,3)"};

std::size_t colour_of(const Picture& picture, std::size_t s) {
  return picture.series[s].colour.value_or(s);
}

std::string frame(const Prepared& p, Format format, const std::string& output) {
  const Picture& picture = p.picture;
  const Margins& m = p.margins;
  const double w = picture.width, h = picture.height;
  std::string out = format == Format::svg
                        ? fmt::format(
                              "set terminal svg size {},{} dynamic enhanced font \"sans-serif,{}\" "
                              "name \"plumb\" background \"#ffffff\"\n",
                              picture.width, picture.height, font_px)
                        : fmt::format(
                              "set terminal pngcairo size {},{} enhanced font \"DejaVu Sans,9.5\" "
                              "background \"#ffffff\"\n",
                              picture.width, picture.height);
  out += fmt::format("set output {}\n", literal(output));
  out += fmt::format("set lmargin at screen {:.6f}\nset rmargin at screen {:.6f}\n", m.left / w,
                     1 - m.right / w);
  out += fmt::format("set bmargin at screen {:.6f}\nset tmargin at screen {:.6f}\n", m.bottom / h,
                     1 - m.top / h);
  out += "set grid lc rgb \"gray\" lw 0.5 dt solid\nset tics scale 0.6 nomirror\nset border 3\n";
  std::string title;
  for (const auto& line : p.title) title += (title.empty() ? "" : "\n") + line;
  out += fmt::format("set title {} noenhanced offset 0,-0.2\n", literal(title));
  out += fmt::format("set xlabel {} noenhanced offset 0,0.3\n",
                     literal(with_unit(picture.x.label, picture.x.unit)));
  out += fmt::format("set label {} at screen {:.6f}, graph 0.5 center rotate by 90 noenhanced\n",
                     literal(with_unit(picture.y.label, picture.y.unit)), 14 / w);
  out += axis_commands("x", p.x, picture.x.ticks) + axis_commands("y", p.y, picture.y.ticks);
  return out;
}

std::string end_labels(const Prepared& p) {
  std::string out;
  const double width = p.picture.width - p.margins.left - p.margins.right;
  const double height = p.picture.height - p.margins.top - p.margins.bottom;
  for (const auto& label : p.labels) {
    const Ink& colour = ink(colour_of(p.picture, label.series));
    const double at = 1 + 12 / width;
    out += fmt::format("set label {} at graph {:.6f}, graph {:.6f} left noenhanced tc rgb \"{}\"\n",
                       literal(p.picture.series[label.series].label), at, label.height, colour.text);
    const double gone_up = std::abs(label.height - p.y.fraction(label.y)) * height;
    const double gone_right = (1 - p.x.fraction(label.x)) * width;
    if (gone_up < 0.5 * line_px && gone_right < 30) continue;
    out += fmt::format(
        "set arrow from first {:.12g}, first {:.12g} to graph {:.6f}, graph {:.6f} nohead back "
        "lw 0.6 dt (3,3) lc rgb \"{}\"\n",
        label.x, label.y, 1 + 9 / width, label.height, colour.line);
  }
  return out;
}

std::string annotations(const Prepared& p) {
  std::string out;
  for (const auto& line : p.picture.lines) {
    const std::string at = fmt::format("first {:.12g}", line.at);
    const std::string from = line.vertical ? at + ", graph 0" : "graph 0, " + at;
    const std::string to = line.vertical ? at + ", graph 1" : "graph 1, " + at;
    out += fmt::format("set arrow from {} to {} nohead back lw 1.2 dt (6,4) lc rgb \"#808080\"\n", from, to);
    if (!line.label.empty())
      out += line.vertical
                 ? fmt::format(
                       "set label {} at {}, graph 0.98 right rotate by 90 offset -0.6,0 noenhanced tc rgb "
                       "\"#606060\"\n",
                       literal(line.label), at)
                 : fmt::format(
                       "set label {} at graph 0.01, {} left offset 0,0.5 noenhanced tc rgb \"#606060\"\n",
                       literal(line.label), at);
  }
  for (const auto& t : p.triangles) {
    out += fmt::format("set object polygon from {:.12g},{:.12g}", t.x[0], t.y[0]);
    for (int corner : {1, 2, 0}) out += fmt::format(" to {:.12g},{:.12g}", t.x[corner], t.y[corner]);
    out += " fillstyle empty border lc rgb \"#606060\" lw 1.2\n";
    out += fmt::format("set label \"slope {}\" at {:.12g},{:.12g} center offset 0,-0.7 tc rgb \"#606060\"\n",
                       tick_text(t.order), std::sqrt(t.x[0] * t.x[1]), t.y[2]);
  }
  double above = 8;
  for (auto lost = p.dropped.rbegin(); lost != p.dropped.rend(); ++lost, above += line_px)
    out += fmt::format("set label {} at screen {:.6f}, screen {:.6f} left noenhanced tc rgb \"#606060\"\n",
                       literal(fmt::format("Not drawn: {} point{} of \"{}\", {}.", lost->points,
                                           lost->points == 1 ? "" : "s", lost->series, lost->why)),
                       10.0 / p.picture.width, above / p.picture.height);
  return out;
}

std::string legend(const Prepared& p) {
  if (p.legend_rows == 0) return "set key off\n";
  const double notes = line_px * static_cast<double>(p.dropped.size());
  return fmt::format(
      "set key at screen 0.5, screen {:.6f} center bottom horizontal maxcols {} Left reverse "
      "noenhanced samplen 2.5 spacing 1.05\n",
      (4 + notes) / p.picture.height, p.legend_columns);
}

std::string series_commands(const Prepared& p, std::vector<std::string>& plots) {
  std::string out;
  for (std::size_t s = 0; s < p.picture.series.size(); ++s) {
    const auto& series = p.picture.series[s];
    const Ink& colour = ink(colour_of(p.picture, s));
    out += fmt::format("$s{} << EOD\n", s);
    for (std::size_t k = 0; k < series.x.size(); ++k)
      out += fmt::format("{:.12g} {:.12g} {:.12g} {:.12g}\n", series.x[k], series.y[k],
                         series.band ? series.band->low[k] : 0, series.band ? series.band->high[k] : 0);
    out += "EOD\n";
    if (series.band)
      plots.push_back(
          fmt::format("$s{} using 1:3:4 with filledcurves lc rgb \"{}\" "
                      "fs transparent solid 0.18 noborder notitle",
                      s, colour.line));
    const bool by_dash = series.style == Style::lines && p.picture.labels == Labels::legend;
    const std::string dash = series.dashed ? dashes[1] : by_dash ? dashes[s % 4] : dashes[0];
    const std::string line = fmt::format("lw 1.8 dt {}", dash);
    const std::string points =
        fmt::format("pt {} ps 0.55", point_shapes[colour_of(p.picture, s) % 8] - (series.hollow ? 1 : 0));
    const std::string look = series.style == Style::lines    ? "lines " + line
                             : series.style == Style::points ? "points " + points
                                                             : fmt::format("linespoints {} {}", line, points);
    plots.push_back(fmt::format("$s{} using 1:2 with {} lc rgb \"{}\" title {}", s, look, colour.line,
                                literal(series.label)));
  }
  return out;
}

}  // namespace

std::string script(const Prepared& prepared, Format format, const std::string& output) {
  std::vector<std::string> plots;
  std::string out = "set encoding utf8\n" + frame(prepared, format, output) + annotations(prepared) +
                    end_labels(prepared) + legend(prepared) + map_commands(prepared, plots) +
                    series_commands(prepared, plots);
  for (std::size_t k = 0; k < plots.size(); ++k) out += (k == 0 ? "plot " : ", \\\n     ") + plots[k];
  return out + "\nunset output\n";
}

}  // namespace plumb::reports::plot
