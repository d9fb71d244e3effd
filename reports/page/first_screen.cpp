#include <fmt/format.h>

#include "lib/convergence/norm_units.hpp"
#include "lib/convergence/words.hpp"
#include "reports/page/parts.hpp"
#include "reports/plot/svg_text.hpp"

namespace plumb::reports::page {
namespace {

using plot::escaped;

std::string tiles(const Page& page) {
  std::string out = "<div class=\"tiles\">";
  for (const auto& [name, count] : count_verdicts(page.sections))
    out += count == 0 ? fmt::format("<div class=\"tile v-{0} none\"><b>0</b> {0}</div>", escaped(name))
           : name == "pass"
               ? fmt::format(R"(<div class="tile v-{0}"><b>{1}</b> {0}</div>)", escaped(name), count)
               : fmt::format(R"(<a class="tile v-{0}" href="#not-passed"><b>{1}</b> {0}</a>)", escaped(name),
                             count);
  out += "</div>";
  out += "<div class=\"tiles\">";
  for (const auto& [kind, passed, all] : count_kinds(page.sections))
    if (all > 0)
      out += fmt::format(R"(<div class="tile"><b>{} of {}</b> {}{}</div>)", passed, all, name_of(kind),
                         kind == CheckKind::book_keeping ? ", counted apart" : "");
  out += "</div>";
  std::string facts;
  for (const auto& section : page.sections)
    for (const auto& fact : section.section.headlines)
      facts += fmt::format(R"(<a class="tile" href="#{}"><b>{}</b> {}</a>)", escaped(section.id),
                           escaped(fact.number), escaped(fact.what));
  return facts.empty() ? out : out + "<div class=\"tiles\">" + facts + "</div>";
}

/// Every word about an order or a check, and what the norms are.
std::string legend() {
  const auto row = [](std::string_view word, std::string_view meaning) {
    return fmt::format("<tr><td>{}</td><td data-l=\"meaning\">{}</td></tr>\n", escaped(std::string(word)),
                       escaped(std::string(meaning)));
  };
  std::string rows;
  for (const VerdictWord& one : verdict_words) rows += row(one.word, one.meaning);
  return "<details class=\"tb\" id=\"words\"><summary>What the words mean</summary><div "
         "class=\"scroll\"><table "
         "class=\"data cards\"><thead><tr><th scope=\"col\">word</th><th "
         "scope=\"col\">meaning</th></tr></thead>"
         "<tbody>\n" +
         rows + row("norms of errors", norms_explained) + "</tbody></table></div></details>\n";
}

/// Every check that did not pass, so that nobody has to look for it.
std::string not_passed(const Page& page) {
  std::string rows;
  std::size_t count = 0;
  for (const auto& section : page.sections)
    for (const auto& check : section.section.checks) {
      if (check.verdict == "pass") continue;
      ++count;
      rows += fmt::format(
          "<tr><td>{}</td><td><a href=\"#{}-checks\">{}</a></td><td>{}</td><td "
          "data-l=\"expected\">{}</td><td "
          "data-l=\"found\">{}</td></tr>\n",
          verdict(check.verdict, check.verdict), escaped(section.id), escaped(section.title),
          escaped(check.what), escaped(check.expected), escaped(check.measured));
    }
  if (count == 0) return "<p>Every check passed.</p>\n";
  return fmt::format(
      "<details class=\"tb\" id=\"not-passed\"{}><summary>What did not pass <small>({} checks)</small>"
      "</summary><div class=\"scroll\"><table class=\"data cards\"><thead><tr><th scope=\"col\">verdict</th>"
      "<th scope=\"col\">section</th><th scope=\"col\">what</th><th scope=\"col\">expected</th>"
      "<th scope=\"col\">found</th></tr></thead><tbody>\n{}</tbody></table></div></details>\n",
      count <= 6 ? " open" : "", count, rows);
}

std::string contents(const Page& page) {
  std::string out = "<nav aria-label=\"Sections\">", chapter;
  for (const auto& s : page.sections) {
    if (s.chapter != chapter || out.back() == '"')
      out += fmt::format("{}<p class=\"chapter\">{}</p><ul>", chapter.empty() ? "" : "</ul>",
                         escaped(s.chapter));
    chapter = s.chapter;
    out += fmt::format("<li><a href=\"#{}\">{}</a> {}<br><span>{}</span></li>\n", escaped(s.id),
                       escaped(s.title), tags(count_verdicts({s})), escaped(s.section.answer));
  }
  if (!page.sections.empty()) out += "</ul>";
  return out +
         "<p class=\"chapter\">Theory</p><ul><li><a href=\"#theory\">The equations</a></li></ul></nav>\n";
}

}  // namespace

std::string first_screen(const Page& page) {
  std::string out =
      fmt::format("<header><h1>{}</h1><p class=\"sub\">{}</p>", escaped(page.title), escaped(page.subtitle)) +
      tiles(page) + "<dl class=\"facts\">";
  for (const auto& [name, value] : page.facts)
    out += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", escaped(name), escaped(value));
  return out + "</dl></header>\n" + legend() + not_passed(page) + contents(page);
}

}  // namespace plumb::reports::page
