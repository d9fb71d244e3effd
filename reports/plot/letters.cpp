#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "lib/core/error.hpp"
#include "reports/picture.hpp"
#include "reports/plot/gnuplot.hpp"

namespace plumb::reports {
namespace {

constexpr std::size_t rows = 22;  // less than any terminal has

/// For gnuplot: in single quotes.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("''") : std::string(1, c);
  return out + "'";
}

std::string title_of(const Axis& axis) {
  return axis.unit.empty() || axis.unit == "1" ? axis.label : fmt::format("{} [{}]", axis.label, axis.unit);
}

bool drawable(double x, const Axis& axis) {
  return std::isfinite(x) && (axis.scale == Scale::linear || x > 0);
}

}  // namespace

std::optional<std::string> with_letters(const Picture& picture, std::size_t columns) {
  if (picture.map.index() != 0) return std::nullopt;
  const plot::TemporaryFolder folder;
  const auto file = folder.path() / "letters";
  std::string script = fmt::format(
      "set encoding utf8\nset terminal dumb size {},{}\nset output {}\nset title {}\nset xlabel {}\nset ylabel {}\n",
      std::clamp<std::size_t>(columns, 40, 120), rows, quoted(file.string()), quoted(picture.title),
      quoted(title_of(picture.x)), quoted(title_of(picture.y)));
  if (picture.x.scale == Scale::log) script += "set logscale x\n";
  if (picture.y.scale == Scale::log) script += "set logscale y\n";
  std::string plots, data;
  for (const Series& series : picture.series) {
    plots += fmt::format("{} '-' with {} title {}", plots.empty() ? "plot" : ",",
                         series.style == Style::lines ? "lines" : "points", quoted(series.label));
    for (std::size_t k = 0; k < series.x.size(); ++k)
      if (drawable(series.x[k], picture.x) && drawable(series.y[k], picture.y))
        data += fmt::format("{:.6g} {:.6g}\n", series.x[k], series.y[k]);
    data += "e\n";
  }
  try {
    plot::run_gnuplot(script + plots + "\n" + data, file, folder);
  } catch (const InputError&) {
    return std::nullopt;  // nobody asked for it
  }
  std::ifstream in(file);
  return std::string(std::istreambuf_iterator<char>(in), {});
}

}  // namespace plumb::reports
