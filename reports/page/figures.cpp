#include <fmt/format.h>

#include "reports/page/parts.hpp"
#include "reports/plot/svg_text.hpp"

namespace plumb::reports::page {
namespace {

using plot::escaped;

/// Wider pictures take two places side by side [pixels].
constexpr int ordinary_width = 760;

/// All frames side by side; the script of the page shows one at a time, with a slider.
std::string frames(const Figure& figure) {
  std::string out = "<div class=\"frames\">";
  for (std::size_t k = 0; k < figure.frames.size(); ++k) {
    const auto& frame = figure.frames[k];
    out += fmt::format("<div class=\"frame\"><p>{}</p>{}</div>\n", escaped(frame.label),
                       svg(frame.picture, fmt::format("{}-{}", figure.id, k)));
  }
  return out + "</div>";
}

}  // namespace

std::string figure(const Figure& figure, const PageSection& section) {
  const auto drawn = section.drawn.find(figure.id);
  const std::string picture = !figure.frames.empty()         ? frames(figure)
                              : drawn != section.drawn.end() ? drawn->second
                                                             : svg(figure.picture, figure.id);
  return fmt::format(
      "<figure id=\"fig-{0}\"{4}>{1}<figcaption>{2} <span class=\"src\"><a href=\"data/{0}.csv\">CSV</a> · "
      "<a href=\"figures/{0}.svg\">SVG</a>{3}</span></figcaption></figure>\n",
      escaped(figure.id), picture, text(figure.caption), source_links(figure.jobs),
      !figure.frames.empty()                  ? " class=\"moving\""
      : figure.picture.width > ordinary_width ? " class=\"wide\""
                                              : "");
}

}  // namespace plumb::reports::page
