#include "reports/theory/theory.hpp"

#include <fmt/format.h>
#include <md4c-html.h>

#include <boost/algorithm/string/replace.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

#include "reports/katex.hpp"
#include "reports/theory_pages.hpp"

namespace plumb::reports::theory {
namespace {

/// "5.3" as "eq-5-3".
std::string anchor(std::string number) {
  boost::replace_all(number, ".", "-");
  return "eq-" + number;
}

/// "05-momentum.md" as "theory-5", "papers.md" as "theory-papers", the index as "theory"; empty for what is no page.
std::string id_of(const std::string& name) {
  static const std::regex chapter(R"((\d+)-.*)");
  for (const auto& page : assets::theory_pages) {
    std::smatch m;
    if (page.name != name) continue;
    if (name == "README.md") return "theory";
    if (std::regex_match(name, m, chapter)) return fmt::format("theory-{}", std::stoi(m[1]));
    return "theory-" + name.substr(0, name.rfind('.'));
  }
  return "";
}

/// Numbers of all equations, "5.3".
const std::set<std::string>& known() {
  static const std::set<std::string> all = [] {
    std::set<std::string> found;
    static const std::regex tag(R"(\\tag\{(\d+\.\d+)\})");
    for (const auto& page : assets::theory_pages)
      for (std::cregex_iterator m(page.text.begin(), page.text.end(), tag), end; m != end; ++m)
        found.insert((*m)[1]);
    return found;
  }();
  return all;
}

/// Every "(5.3)" of the text that is an equation as a link to it.
std::string with_links(const std::string& text) {
  static const std::regex number(R"(\((\d+\.\d+)\))");
  std::string out;
  std::size_t from = 0;
  for (std::sregex_iterator m(text.begin(), text.end(), number), end; m != end; ++m) {
    out.append(text, from, static_cast<std::size_t>(m->position()) - from);
    out += known().contains((*m)[1]) ? fmt::format("<a href=\"#{}\">{}</a>", anchor((*m)[1]), m->str())
                                     : m->str();
    from = static_cast<std::size_t>(m->position() + m->length());
  }
  return out.append(text, from, std::string::npos);
}

/// with_links outside of formulas, links and code.
std::string with_links_in_prose(const std::string& html) {
  std::string out;
  for (std::size_t at = 0; at < html.size();) {
    std::size_t from = std::string::npos, to = std::string::npos;
    for (const auto& [open, close] :
         {std::pair{"<x-equation", "</x-equation>"}, {"<a ", "</a>"}, {"<code", "</code>"}}) {
      const std::size_t found = html.find(open, at);
      if (found >= from) continue;
      from = found;
      to = html.find(close, found);
    }
    out += with_links(html.substr(at, from - at));
    if (from == std::string::npos) break;
    out += html.substr(from, to - from);
    at = to;
    out += html.substr(at, html.find('>', at) + 1 - at);
    at = html.find('>', at) + 1;
  }
  return out;
}

/// Headings two levels lower; the index has no title beside that of the section.
std::string with_headings(const std::string& name, const std::string& markdown) {
  std::string out;
  std::istringstream in(markdown);
  for (std::string line; std::getline(in, line);) {
    if (name == "README.md" && line.starts_with("# ")) continue;
    out += (line.starts_with("#") ? "##" + line : line) + "\n";
  }
  return out;
}

/// A displayed equation gets a box of its own, which scrolls on a narrow screen, with the id of its number.
std::string with_boxes(std::string html) {
  const std::string open = "<p><x-equation type=\"display\">", close = "</x-equation></p>", tag = "\\tag{";
  for (std::size_t at = 0; (at = html.find(open, at)) != std::string::npos;) {
    const std::size_t end = html.find(close, at), number = html.find(tag, at);
    if (end == std::string::npos) break;
    std::string id;
    if (number < end) {
      const std::size_t from = number + tag.size();
      id = " id=\"" + anchor(html.substr(from, html.find('}', from) - from)) + "\"";
    }
    html.replace(end + close.size() - 4, 4, "</div>");
    html.replace(at, 3, "<div class=\"eq\"" + id + ">");
  }
  return html;
}

/// Links to other pages as links within this one; those to what is not in it are left out.
std::string with_pages(const std::string& html) {
  static const std::regex link(R"re(<a href="([\w-]+\.md)">([^<]*)</a>)re");
  std::string out;
  std::size_t from = 0;
  for (std::sregex_iterator m(html.begin(), html.end(), link), end; m != end; ++m) {
    out.append(html, from, static_cast<std::size_t>(m->position()) - from);
    const std::string id = id_of((*m)[1]);
    out += id.empty() ? (*m)[2].str() : fmt::format("<a href=\"#{}\">{}</a>", id, (*m)[2].str());
    from = static_cast<std::size_t>(m->position() + m->length());
  }
  return out.append(html, from, std::string::npos);
}

void append(const MD_CHAR* text, MD_SIZE size, void* to) {
  static_cast<std::string*>(to)->append(text, size);
}

}  // namespace

std::string page_of(const std::string& name, const std::string& markdown) {
  const std::string text = with_headings(name, markdown);
  std::string out;
  if (md_html(text.data(), static_cast<MD_SIZE>(text.size()), append, &out,
              MD_FLAG_TABLES | MD_FLAG_LATEXMATHSPANS, MD_HTML_FLAG_XHTML) != 0)
    throw std::runtime_error("the theory cannot be turned into HTML");
  boost::replace_first(out, "<h3>", "<h3 id=\"" + id_of(name) + "\">");  // the title of the page
  boost::replace_all(out, "<table>",
                     "<div class=\"scroll\"><table>");  // wide tables scroll on a narrow screen
  boost::replace_all(out, "</table>", "</table></div>");
  return with_links_in_prose(with_pages(with_boxes(out)));
}

std::string page() {
  std::string out;
  if (assets::katex_js.empty())
    out =
        "<p class=\"note\">Formulas are shown as their LaTeX source, since KaTeX was not there when this program was "
        "built: it is Debian's package libjs-katex.</p>\n";
  for (const auto& page : assets::theory_pages)
    out += page_of(std::string(page.name), std::string(page.text));
  return out;
}

std::string linked(const std::string& html) {
  static const std::regex citation(R"(THEORY((?:[-, ]+\(\d+\.\d+\))+|,? chapter (\d+)))");
  std::string out;
  std::size_t from = 0;
  for (std::sregex_iterator m(html.begin(), html.end(), citation), end; m != end; ++m) {
    out.append(html, from, static_cast<std::size_t>(m->position()) - from);
    const std::string chapter = (*m)[2];
    const auto* there = std::ranges::find_if(assets::theory_pages, [&](const assets::TheoryPage& page) {
      return !chapter.empty() && id_of(std::string(page.name)) == "theory-" + chapter;
    });
    if (chapter.empty())
      out += with_links(m->str());
    else if (there != assets::theory_pages.end())
      out += fmt::format("<a href=\"#theory-{}\">{}</a>", chapter, m->str());
    else
      out += m->str();
    from = static_cast<std::size_t>(m->position() + m->length());
  }
  return out.append(html, from, std::string::npos);
}

}  // namespace plumb::reports::theory
