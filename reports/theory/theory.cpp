#include "reports/theory/theory.hpp"

#include <fmt/format.h>
#include <md4c-html.h>

#include <boost/algorithm/string/replace.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "reports/assets.hpp"
#include "reports/plot/svg_text.hpp"
#include "reports/theory/mathml.hpp"

namespace plumb::reports::theory {
namespace {

/// "(5.3)" as "eq-5-3".
std::string anchor(const std::string& number) {
  std::string id = "eq-" + number.substr(1, number.size() - 2);
  for (char& c : id)
    if (c == '.') c = '-';
  return id;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

const std::regex numbered(R"(^\s*(\(\d+\.\d+\))\s+(.*)$)");

/// Numbers of all equations, "(5.3)".
std::set<std::string> equations(const std::vector<std::string>& lines) {
  std::set<std::string> found;
  std::smatch m;
  for (const auto& line : lines)
    if (line.starts_with("    ") && std::regex_match(line, m, numbered)) found.insert(m[1]);
  return found;
}

const std::set<std::string>& known() {
  static const std::set<std::string> all = equations(lines_of(std::string(assets::theory_md)));
  return all;
}

/// Every "(5.3)" of the text that is an equation replaced by `with`, in which {0} is its id and {1} itself.
std::string with_links(const std::string& text, const std::set<std::string>& numbers, const char* with) {
  static const std::regex number(R"(\(\d+\.\d+\))");
  std::string out;
  std::size_t from = 0;
  for (std::sregex_iterator m(text.begin(), text.end(), number), end; m != end; ++m) {
    out.append(text, from, static_cast<std::size_t>(m->position()) - from);
    out +=
        numbers.contains(m->str()) ? fmt::format(fmt::runtime(with), anchor(m->str()), m->str()) : m->str();
    from = static_cast<std::size_t>(m->position() + m->length());
  }
  return out.append(text, from, std::string::npos);
}

/// The parts of a line that wide gaps divide, each a formula of its own, so that a narrow page can break
/// between them.
std::string formulas(const std::string& line) {
  static const std::regex gap(R"(\s{2,})");
  std::string out;
  for (std::sregex_token_iterator part(line.begin(), line.end(), gap, -1), end; part != end; ++part)
    out += (out.empty() ? "" : " &#8195; ") + mathml(*part);
  return out;
}

/// One line of a formula as a row: number, formula, what the paper calls it.
std::string formula_row(const std::string& line) {
  std::smatch m;
  std::string number, formula = line, source;
  if (std::regex_match(line, m, numbered)) number = m[1], formula = m[2];
  static const std::regex with_source(R"(^(.*\S)\s{3,}(\((?:A\.)?\d+[a-z]?\).*)$)");
  if (std::regex_match(formula, m, with_source)) {
    source = m[2];
    formula = std::string(m[1]);
  }
  formula.erase(0, formula.find_first_not_of(' '));
  return fmt::format("<tr{}><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                     number.empty() ? "" : " id=\"" + anchor(number) + "\"", number, formulas(formula),
                     plot::escaped(source));
}

/// A heading with a place to link to; the title of the file is the page's.
std::string heading(const std::string& line) {
  static const std::regex chapter(R"(^## (\d+)\. (.*)$)");
  std::smatch m;
  if (std::regex_match(line, m, chapter))
    return fmt::format("\n<h3 id=\"theory-{0}\">{0}. {1}</h3>\n\n", m[1].str(), plot::escaped(m[2]));
  return line.starts_with("# ") ? "" : "#" + line + "\n";
}

void append(const MD_CHAR* text, MD_SIZE size, void* to) {
  static_cast<std::string*>(to)->append(text, size);
}

}  // namespace

std::string page_of(const std::string& markdown) {
  const auto lines = lines_of(markdown);
  const auto numbers = equations(lines);
  std::string text;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const auto& line = lines[k];
    if (line.starts_with("    ")) {
      const bool first = text.empty() || !text.ends_with("</tr>\n");
      text += (first ? "\n<div class=\"scroll\"><table class=\"eq\">\n" : "") + formula_row(line);
      std::size_t next = k + 1;
      while (next < lines.size() && lines[next].empty()) ++next;
      if (next < lines.size() && lines[next].starts_with("    "))
        k = next - 1;  // formulas that only a blank line divides are one block
      else
        text += "</table></div>\n\n";
      continue;
    }
    text += line.starts_with("#") ? heading(line) : with_links(line, numbers, "[{1}](#{0})") + "\n";
  }
  std::string out;
  if (md_html(text.data(), static_cast<MD_SIZE>(text.size()), append, &out, MD_FLAG_TABLES,
              MD_HTML_FLAG_XHTML) != 0)
    throw std::runtime_error("the theory cannot be turned into HTML");
  // Wide tables scroll by themselves on a narrow screen; those of equations, which have no tbody, do so
  // already.
  boost::replace_all(out, "<table>", "<div class=\"scroll\"><table>");
  boost::replace_all(out, "</tbody>\n</table>", "</tbody>\n</table></div>");
  return out;
}

std::string page() {
  return page_of(std::string(assets::theory_md));
}

std::string linked(const std::string& html) {
  static const std::regex citation(R"(THEORY((?:[-, ]+\(\d+\.\d+\))+|(?:\.md)?,? chapter (\d+)))");
  static const std::string all(assets::theory_md);
  std::string out;
  std::size_t from = 0;
  for (std::sregex_iterator m(html.begin(), html.end(), citation), end; m != end; ++m) {
    out.append(html, from, static_cast<std::size_t>(m->position()) - from);
    const std::string chapter = (*m)[2];
    if (chapter.empty())
      out += with_links(m->str(), known(), "<a href=\"#{0}\">{1}</a>");
    else if (all.find("\n## " + chapter + ". ") != std::string::npos)
      out += fmt::format("<a href=\"#theory-{}\">{}</a>", chapter, m->str());
    else
      out += m->str();
    from = static_cast<std::size_t>(m->position() + m->length());
  }
  return out.append(html, from, std::string::npos);
}

}  // namespace plumb::reports::theory
