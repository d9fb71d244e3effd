#include <fmt/format.h>

#include <algorithm>
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
    constexpr std::size_t line = 60;  // letters; longer ones want a column that is not too narrow
    const std::string kind = text->size() > line ? " class=\"t\"" : "";
    return "<td" + kind + label + ">" + (is_verdict ? page::verdict(*text, *text) : escaped(*text)) + "</td>";
  }
  if (const auto* value = std::get_if<double>(&entry))
    return fmt::format(R"(<td class="n" data-v="{:.17g}">{}</td>)", *value,
                       number_text(*value, column.digits));
  return "<td></td>";
}

/// The job behind row r of a table, or "".
std::string job_of_row(const DataTable& table, std::size_t r) {
  if (table.row_jobs.size() == table.rows.size()) return table.row_jobs[r];
  if (table.jobs.size() == 1) return table.jobs[0];
  return table.jobs.size() == table.rows.size() ? table.jobs[r] : std::string();
}

/// The picture of row r: the one named, or the first of the section that shows its job; "" if there is none.
std::string picture_of_row(const DataTable& table, std::size_t r, const PageSection& section) {
  const auto& figures = section.section.figures;
  if (table.figures.size() == table.rows.size()) return table.figures[r];
  const std::string job = job_of_row(table, r);
  const auto shows = [&job](const Figure& figure) {
    return std::find(figure.jobs.begin(), figure.jobs.end(), job) != figure.jobs.end();
  };
  const auto found = std::find_if(figures.begin(), figures.end(), shows);
  return found == figures.end() ? std::string() : found->id;
}

/// Where the command of a job stands; the list of commands of the section if no job is named.
std::string command_link(const std::string& job, const PageSection& section) {
  const bool known = std::any_of(section.jobs.begin(), section.jobs.end(),
                                 [&job](const auto& entry) { return entry.first == job; });
  if (!known && section.jobs.empty()) return {};
  return fmt::format("<a href=\"#{}\">command</a>",
                     known ? "cmd-" + escaped(job) : escaped(section.id) + "-how");
}

/// The last cell of a row: where its picture and its command are.
std::string row_links(const DataTable& table, std::size_t r, const PageSection& section) {
  const std::string picture = picture_of_row(table, r, section);
  const std::string command = command_link(job_of_row(table, r), section);
  std::string out = picture.empty() ? "" : fmt::format("<a href=\"#fig-{}\">picture</a>", escaped(picture));
  if (!out.empty() && !command.empty()) out += " · ";
  return "<td class=\"see\">" + out + command + "</td>";
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

std::string source_links(const std::vector<std::string>& jobs) {
  std::string out = jobs.size() > 2 ? " · commands:" : "";
  for (std::size_t k = 0; k < jobs.size(); ++k)
    out += jobs.size() > 2
               ? fmt::format(" <a href=\"#cmd-{}\">{}</a>", escaped(jobs[k]), k + 1)
               : fmt::format(" · <a href=\"#cmd-{0}\">command</a> · <a href=\"data/{0}.json\">JSON</a>",
                             escaped(jobs[k]));
  return out;
}

std::string table(const DataTable& table, const PageSection& section) {
  const bool long_table = table.rows.size() > 20;
  std::string out =
      fmt::format(R"(<details class="tb" id="table-{}"{}><summary>{} <small>({} rows)</small></summary>)",
                  escaped(table.id), long_table ? "" : " open", escaped(table.title), table.rows.size());
  constexpr std::size_t many = 9;  // columns of numbers that fill a printed page
  out += fmt::format(R"(<div class="scroll"><table class="data{}"><thead><tr>)",
                     has_sentences(table)          ? " cards"
                     : table.columns.size() > many ? " many"
                                                   : "");
  for (const auto& column : table.columns)
    out += fmt::format("<th scope=\"col\">{}{}</th>", escaped(column.name),
                       column.unit.empty() ? "" : " <small>[" + escaped(column.unit) + "]</small>");
  out += "<th scope=\"col\" class=\"see\">see</th></tr></thead><tbody>\n";
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    out += "<tr>";
    for (std::size_t c = 0; c < table.columns.size(); ++c)
      out += c < table.rows[r].size() ? cell(table.rows[r][c], table.columns[c]) : "<td></td>";
    out += row_links(table, r, section) + "</tr>\n";
  }
  out += "</tbody></table></div>";
  return out + fmt::format("<p class=\"src\"><a href=\"data/table-{}.csv\">CSV</a>{}</p></details>\n",
                           escaped(table.id), source_links(table.jobs));
}

std::string checks(const PageSection& section) {
  const auto& checks = section.section.checks;
  if (checks.empty()) return {};
  std::string out = fmt::format(
      "<h3 id=\"{}-checks\">Checks</h3><div class=\"scroll\"><table class=\"data cards\"><thead><tr><th "
      "scope=\"col\">verdict</th><th scope=\"col\">kind</th><th scope=\"col\">what</th><th "
      "scope=\"col\">expected</th><th "
      "scope=\"col\">found</th><th scope=\"col\" class=\"see\">see</th></tr></thead><tbody>\n",
      escaped(section.id));
  for (const auto& check : checks)
    out += fmt::format(
        "<tr><td>{}</td><td data-l=\"kind\">{}</td><td>{}</td><td data-l=\"expected\">{}</td><td "
        "data-l=\"found\">{}</td><td class=\"see\">{}</td></tr>\n",
        verdict(check.verdict, check.verdict), name_of(check.kind), escaped(check.what),
        escaped(check.expected), escaped(check.measured), command_link(check.job, section));
  return out + "</tbody></table></div>\n";
}

}  // namespace page
}  // namespace plumb::reports
