#include "reports/page/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "lib/output/progress.hpp"
#include "reports/assets.hpp"
#include "reports/katex.hpp"
#include "reports/page/parts.hpp"
#include "reports/plot/svg_text.hpp"
#include "reports/theory/theory.hpp"

namespace plumb::reports {
namespace {

using plot::escaped;

std::string reproduce(const PageSection& section) {
  if (section.jobs.empty()) return {};
  std::string out =
      fmt::format(R"(<h3 id="{}-how">How to reproduce</h3><ul class="cmd">)", escaped(section.id));
  for (const auto& [id, job] : section.jobs)
    out += fmt::format("<li id=\"cmd-{0}\"><code>{1}</code> <small>{2}</small></li>\n", escaped(id),
                       escaped(job.command),
                       job.failure.empty() ? fmt::format("<a href=\"data/{}.json\">JSON</a>, {} of CPU time",
                                                         escaped(id), duration_text(job.cpu_s))
                                           : "no result: " + escaped(job.failure));
  return out + "</ul>\n";
}

}  // namespace

std::vector<KindCount> count_kinds(const std::vector<PageSection>& sections) {
  std::vector<KindCount> counts;
  for (const CheckKind kind : check_kinds()) {
    counts.push_back({kind});
    for (const auto& section : sections)
      for (const auto& check : section.section.checks) {
        if (check.kind != kind) continue;
        ++counts.back().all;
        counts.back().passed += check.verdict == "pass" ? 1 : 0;
      }
  }
  return counts;
}

std::vector<std::pair<std::string, std::size_t>> count_verdicts(const std::vector<PageSection>& sections) {
  std::map<std::string, std::size_t> found;
  for (const auto& section : sections)
    for (const auto& check : section.section.checks)
      if (check.kind != CheckKind::book_keeping || check.verdict != "pass") ++found[check.verdict];
  std::vector<std::pair<std::string, std::size_t>> counts;
  for (const auto& name : verdict_names()) counts.emplace_back(name, found[name]);
  return counts;
}

namespace page {

std::string text(const std::string& plain) {
  return theory::linked(escaped(plain));
}

std::string tags(const std::vector<std::pair<std::string, std::size_t>>& counts) {
  std::string out;
  for (const auto& [name, count] : counts)
    if (count > 0) out += verdict(name, fmt::format("{} {}", count, name)) + " ";
  return out;
}

std::string section(const PageSection& s) {
  const Section& content = s.section;
  std::string out = fmt::format(
      "<section id=\"{}\"><h2>{}</h2><p class=\"q\">{}</p><p class=\"a\">{} {}</p>\n", escaped(s.id),
      escaped(s.title), text(content.question), text(content.answer), tags(count_verdicts({s})));
  const std::size_t above = std::min(content.tables_above, content.tables.size());
  for (std::size_t k = 0; k < above; ++k) out += table(content.tables[k], s);
  if (!content.figures.empty()) {
    out += "<div class=\"figs\">";
    for (const auto& f : content.figures) out += figure(f, s);
    out += "</div>\n";
  }
  out += checks(s);
  for (std::size_t k = above; k < content.tables.size(); ++k) out += table(content.tables[k], s);
  for (const auto& note : content.notes) out += "<p class=\"note\">" + text(note) + "</p>\n";
  return out + reproduce(s) + "</section>\n";
}

}  // namespace page

std::string html(const Page& page) {
  std::string out =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">"
      "<meta name=\"color-scheme\" content=\"light dark\"><link rel=\"icon\" href=\"data:,\">";
  out += fmt::format("<title>{}</title><style>{}{}</style></head><body>\n", escaped(page.title),
                     assets::katex_css, assets::page_css);
  out += page::first_screen(page) + "<main>\n";
  std::string chapter;
  for (const auto& section : page.sections) {
    if (section.chapter != chapter) out += "<p class=\"chapter\">" + escaped(section.chapter) + "</p>\n";
    chapter = section.chapter;
    out += page::section(section);
  }
  out +=
      "<section id=\"theory\"><h2>Theory</h2><p class=\"q\">Which equations are solved, and what was found "
      "about them?</p>" +
      theory::page() + "</section>\n</main>";
  out +=
      "<footer><p>The numbers behind each picture and table are in the folder <code>data</code> beside this "
      "page. Nothing on it comes from the network.</p></footer>\n";
  return out + fmt::format("<script>{}</script>\n<script>{}</script></body></html>\n", assets::katex_js,
                           assets::page_js);
}

}  // namespace plumb::reports
