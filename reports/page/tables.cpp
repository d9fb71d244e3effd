#include <fmt/format.h>

#include <cmath>

#include "reports/page/parts.hpp"
#include "reports/plot/svg_text.hpp"

namespace plumb::reports {
namespace {

using plot::escaped;

/// An exponent in raised digits, so that it survives copying as text.
std::string raised(int exponent) {
  static const char* const digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string out = exponent < 0 ? "⁻" : "";
  for (char c : std::to_string(std::abs(exponent))) out += digits[c - '0'];
  return out;
}

/// Tables with sentences become cards on a narrow screen; tables of numbers scroll.
bool has_sentences(const DataTable& table) {
  constexpr std::size_t sentence = 40;  // letters
  for (const auto& row : table.rows)
    for (const auto& entry : row)
      if (const auto* text = std::get_if<std::string>(&entry); text && text->size() > sentence) return true;
  return false;
}

std::string cell(const Entry& entry, const Column& column) {
  const std::string label = " data-l=\"" + escaped(column.name) + "\"";
  if (const auto* text = std::get_if<std::string>(&entry)) {
    const bool is_verdict =
        std::find(verdict_names().begin(), verdict_names().end(), *text) != verdict_names().end();
    return "<td" + label + ">" + (is_verdict ? page::verdict(*text, *text) : escaped(*text)) + "</td>";
  }
  if (const auto* value = std::get_if<double>(&entry))
    return fmt::format("<td class=\"n\" data-v=\"{:.17g}\">{}</td>", *value,
                       number_text(*value, column.digits));
  return "<td></td>";
}

/// Command and JSON of one or two runs; the numbered commands of more.
std::string source_links(const std::vector<std::string>& jobs) {
  std::string out = jobs.size() > 2 ? " · commands:" : "";
  for (std::size_t k = 0; k < jobs.size(); ++k)
    out += jobs.size() > 2
               ? fmt::format(" <a href=\"#cmd-{}\">{}</a>", escaped(jobs[k]), k + 1)
               : fmt::format(" · <a href=\"#cmd-{0}\">command</a> · <a href=\"data/{0}.json\">JSON</a>",
                             escaped(jobs[k]));
  return out;
}

}  // namespace

std::string number_text(double value, int digits) {
  if (!std::isfinite(value)) return "not finite";
  if (digits == 0) return fmt::format("{:.0f}", value);
  if (value == 0) return "0";
  const double size = std::abs(value);
  if (size < 1e-3 || size >= 1e6) {
    const std::string text = fmt::format("{:.{}e}", value, digits - 1);
    const auto e = text.find('e');
    return text.substr(0, e) + "·10" + raised(std::stoi(text.substr(e + 1)));
  }
  const int before = static_cast<int>(std::floor(std::log10(size))) + 1;
  return fmt::format("{:.{}f}", value, std::max(0, digits - before));
}

namespace page {

std::string verdict(const std::string& name, const std::string& text) {
  return fmt::format("<span class=\"v v-{}\">{}</span>", escaped(name), escaped(text));
}

std::string table(const DataTable& table) {
  const bool long_table = table.rows.size() > 12;
  const bool pictured = table.figures.size() == table.rows.size() && !table.rows.empty();
  std::string out =
      fmt::format("<details class=\"tb\" id=\"{}\"{}><summary>{} <small>({} rows)</small></summary>",
                  escaped(table.id), long_table ? "" : " open", escaped(table.title), table.rows.size());
  out += "<div class=\"scroll\"><table class=\"data";
  out += has_sentences(table) ? " cards\"><thead><tr>" : "\"><thead><tr>";
  for (const auto& column : table.columns)
    out += fmt::format("<th scope=\"col\">{}{}</th>", escaped(column.name),
                       column.unit.empty() ? "" : " <small>[" + escaped(column.unit) + "]</small>");
  if (pictured) out += "<th scope=\"col\">see</th>";
  out += "</tr></thead><tbody>\n";
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    out += "<tr>";
    for (std::size_t c = 0; c < table.columns.size(); ++c)
      out += c < table.rows[r].size() ? cell(table.rows[r][c], table.columns[c]) : "<td></td>";
    if (pictured) out += fmt::format("<td><a href=\"#{}\">picture</a></td>", escaped(table.figures[r]));
    out += "</tr>\n";
  }
  out += "</tbody></table></div>";
  return out + fmt::format("<p class=\"src\"><a href=\"data/{}.csv\">CSV</a>{}</p></details>\n",
                           escaped(table.id), source_links(table.jobs));
}

std::string checks(const std::string& section_id, const std::vector<Check>& checks) {
  if (checks.empty()) return {};
  std::string out = fmt::format(
      "<h3 id=\"{}-checks\">Checks</h3><div class=\"scroll\"><table class=\"data cards\"><thead><tr><th "
      "scope=\"col\">verdict</th><th scope=\"col\">"
      "what</th><th scope=\"col\">expected</th><th scope=\"col\">found</th></tr></thead><tbody>\n",
      escaped(section_id));
  for (const auto& check : checks)
    out += fmt::format(
        "<tr><td>{}</td><td>{}</td><td data-l=\"expected\">{}</td><td data-l=\"found\">{}</td></tr>\n",
        verdict(check.verdict, check.verdict), escaped(check.what), escaped(check.expected),
        escaped(check.measured));
  return out + "</tbody></table></div>\n";
}

std::string figure(const Figure& figure) {
  return fmt::format(
      "<figure id=\"{0}\">{1}<figcaption>{2} <span class=\"src\"><a href=\"data/{0}.csv\">CSV</a> · "
      "<a href=\"figures/{0}.svg\">SVG</a>{3}</span></figcaption></figure>\n",
      escaped(figure.id), svg(figure.picture, figure.id), escaped(figure.caption), source_links(figure.jobs));
}

}  // namespace page
}  // namespace plumb::reports
