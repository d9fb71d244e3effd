#include "reports/picture.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "lib/core/error.hpp"
#include "reports/plot/gnuplot.hpp"
#include "reports/plot/prepare.hpp"
#include "reports/plot/script.hpp"
#include "reports/plot/svg_text.hpp"

namespace plumb::reports {
namespace {

std::string draw(const plot::Prepared& prepared, plot::Format format) {
  const plot::TemporaryFolder folder;
  const auto file = folder.path() / "picture";
  plot::run_gnuplot(plot::script(prepared, format, file.string()), file, folder);
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// A number of a CSV file; what is not finite stays empty.
std::string cell(double value) {
  return std::isfinite(value) ? fmt::format("{:.17g}", value) : std::string();
}

std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string out = "\"";
  for (char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

}  // namespace

std::vector<Dropped> save(const Picture& picture, const std::filesystem::path& file) {
  const auto ending = file.extension();
  if (ending != ".svg" && ending != ".png")
    throw InputError(fmt::format("no picture can be drawn into \"{}\"", file.string()),
                     "the ending says how, and only .svg and .png are known",
                     "Write for instance picture.svg.");
  const auto prepared = plot::prepare(picture);
  const bool is_svg = ending == ".svg";
  std::string bytes = draw(prepared, is_svg ? plot::Format::svg : plot::Format::png);
  if (is_svg) bytes = plot::tidy_svg(std::move(bytes), prepared.picture, "plumb");
  std::ofstream out(file, std::ios::binary);
  out << bytes << std::flush;
  if (!out)
    throw InputError(fmt::format("the picture \"{}\" cannot be written", file.string()),
                     "its folder does not exist, is not yours, or is full", "Choose another place.");
  return prepared.dropped;
}

std::string svg(const Picture& picture, const std::string& prefix) {
  const auto prepared = plot::prepare(picture);
  return plot::tidy_svg(draw(prepared, plot::Format::svg), prepared.picture, prefix);
}

std::string data_csv(const Picture& picture) {
  std::string out;
  const auto grid = [&out](const auto& map, const auto& text) {
    out += "x,y,value\n";
    for (std::size_t j = 0; j < map.y.size(); ++j)
      for (std::size_t i = 0; i < map.x.size(); ++i)
        out += fmt::format("{},{},{}\n", cell(map.x[i]), cell(map.y[j]), text(map.z[j * map.x.size() + i]));
  };
  if (const auto* map = std::get_if<HeatMap>(&picture.map)) grid(*map, [](double z) { return cell(z); });
  if (const auto* map = std::get_if<CategoryMap>(&picture.map))
    grid(*map,
         [map](int z) { return z < 0 ? std::string() : csv_text(map->names[static_cast<std::size_t>(z)]); });
  if (const auto* map = std::get_if<PointMap>(&picture.map)) {
    out += "x,y,value\n";
    for (std::size_t k = 0; k < map->x.size(); ++k)
      out += fmt::format("{},{},{}\n", cell(map->x[k]), cell(map->y[k]), cell(map->z[k]));
  }
  if (const auto* map = std::get_if<Patches>(&picture.map)) {
    out += "x1,y1,x2,y2,x3,y3,x4,y4,value\n";
    for (std::size_t k = 0; k < map->z.size(); ++k) {
      for (std::size_t c = 4 * k; c < 4 * k + 4; ++c)
        out += fmt::format("{:.9g},{:.9g},", map->x[c], map->y[c]);
      out += cell(map->z[k]) + "\n";
    }
  }
  if (const auto* rows = std::get_if<Intervals>(&picture.map)) {
    out += "name,low,value,high,expected\n";
    for (std::size_t k = 0; k < rows->names.size(); ++k)
      out += fmt::format("{},{},{},{},{}\n", csv_text(rows->names[k]), cell(rows->low[k]),
                         cell(rows->value[k]), cell(rows->high[k]), cell(rows->expected[k]));
  }
  if (picture.series.empty()) return out;
  if (!out.empty()) out += "\n";
  out += "series,x,y,low,high\n";
  for (const auto& series : picture.series)
    for (std::size_t k = 0; k < series.x.size(); ++k)
      out += fmt::format("{},{},{},{},{}\n", csv_text(series.label), cell(series.x[k]), cell(series.y[k]),
                         series.band ? cell(series.band->low[k]) : "",
                         series.band ? cell(series.band->high[k]) : "");
  return out;
}

}  // namespace plumb::reports
