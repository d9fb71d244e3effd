#include "reports/plot/svg_text.hpp"

#include <fmt/format.h>

#include <regex>

#include "reports/palette.hpp"

namespace plumb::reports::plot {
namespace {

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

/// rgb( 10, 20, 30) -> #0a141e
std::string hex_colours(const std::string& svg) {
  static const std::regex rgb(R"(rgb\(\s*(\d+),\s*(\d+),\s*(\d+)\s*\))");
  std::string out;
  std::size_t from = 0;
  for (std::sregex_iterator m(svg.begin(), svg.end(), rgb), end; m != end; ++m) {
    out.append(svg, from, static_cast<std::size_t>(m->position()) - from);
    out += fmt::format("#{:02x}{:02x}{:02x}", std::stoi((*m)[1]), std::stoi((*m)[2]), std::stoi((*m)[3]));
    from = static_cast<std::size_t>(m->position() + m->length());
  }
  return out.append(svg, from, std::string::npos);
}

std::string colour_rule(std::string_view light, std::string_view dark) {
  return fmt::format(
      ".plumb [fill=\"{0}\"]{{fill:{1}}}.plumb [stroke=\"{0}\"]{{stroke:{1}}}.plumb "
      "[color=\"{0}\"]{{color:{1}}}",
      light, dark);
}

const std::string& style() {
  static const std::string text = [] {
    std::string rules = colour_rule("black", "#e4e4e0") + colour_rule("gray", "#454a52") +
                        colour_rule("#ffffff", "#16191d") + colour_rule("#606060", "#a8a8a4") +
                        colour_rule("#808080", "#909090");
    for (const auto& colour : palette)
      rules += colour_rule(colour.line, colour.dark) + colour_rule(colour.text, colour.dark);
    return "<style>.plumb text{font-family:system-ui,sans-serif}@media screen and "
           "(prefers-color-scheme:dark){" +
           rules + "}</style>";
  }();
  return text;
}

/// The mesh on a surface, as thin strokes of its quadrilaterals.
std::string mesh_style(const Picture& picture, const std::string& prefix) {
  if (!std::holds_alternative<Patches>(picture.map)) return {};
  return fmt::format(
      "<style>#{}-plot-1 "
      "polygon{{stroke:#000;stroke-opacity:.3;stroke-width:.5;shape-rendering:auto}}</style>",
      prefix);
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string out;
  for (char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else if (c == '\'')
      out += "&#39;";
    else if (static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t')
      out += c;
  }
  return out;
}

std::string tidy_svg(std::string svg, const Picture& picture, const std::string& prefix) {
  const std::size_t from = svg.find("<title>");
  const std::size_t to = svg.find("</desc>");
  if (from != std::string::npos && to != std::string::npos)
    svg.replace(
        from, to + 7 - from,
        fmt::format("<title>{}</title>{}", escaped(picture.title), style()) + mesh_style(picture, prefix));
  replace_all(svg, "<svg \n", "<svg class=\"plumb\" role=\"img\"\n");
  // Drop what gnuplot never uses here: filters for boxed text.
  const std::size_t filters = svg.find("<filter id='textbox'"), defs_end = svg.find("</defs>");
  if (filters != std::string::npos && defs_end != std::string::npos) svg.erase(filters, defs_end - filters);
  static const std::regex empty_group(
      R"(<g fill="none" color="[^"]*" stroke="[^"]*" stroke-width="[^"]*" stroke-linecap="butt" stroke-linejoin="miter">\s*</g>\n)");
  svg = std::regex_replace(svg, empty_group, "");
  svg = hex_colours(svg);
  replace_all(svg, "'gp", "'" + prefix + "-gp");
  replace_all(svg, "'#gp", "'#" + prefix + "-gp");
  replace_all(svg, "id=\"gnuplot_canvas\"", "id=\"" + prefix + "-canvas\"");
  static const std::regex plot_title(R"(<title>plumb_plot_\d+</title>)");
  svg = std::regex_replace(svg, plot_title, "");
  replace_all(svg, "id=\"plumb_plot_", "id=\"" + prefix + "-plot-");
  return svg;
}

}  // namespace plumb::reports::plot
