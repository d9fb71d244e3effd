#include "reports/page/page.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <regex>
#include <set>

#include "lib/convergence/words.hpp"
#include "reports/checks.hpp"

namespace {

using namespace plumb::reports;

Page sample() {
  Picture picture{"a < b", {"x", "m"}, {"y", "Pa"}};
  picture.series = {{"line", {1, 2, 3}, {1, 4, 9}}};
  PageSection section{"plate", "Plate & <script>alert(1)</script>", {}, {}};
  section.section.question = "Is 1 < 2?";
  section.section.answer = "Yes \"it\" is.";
  section.section.checks = {
      {"order", "2", "2.01", "pass"}, {"floor", "0", "1", "fail"}, {"later", "-", "-", "not-computed"}};
  section.section.figures = {{"plate-error", picture, "caption & more", {"plate-run"}}};
  section.section.tables = {
      {"plate-levels",
       "Levels",
       {{"d", "m", 3}, {"error", "m", 2}, {"verdict"}},
       {{0.1, 1.2345e-7, "pass"}, {0.05, std::numeric_limits<double>::quiet_NaN(), std::monostate{}}},
       {"plate-run"},
       {"plate-error", "plate-error"}}};
  section.section.notes = {"A note."};
  JobResult job;
  job.command = "plumb run 'a b.toml'";
  section.jobs = {{"plate-run", job}};
  return {"Report", "About", {{"commit", "abc"}}, {section}};
}

std::set<std::string> all(const std::string& text, const std::string& pattern) {
  std::set<std::string> found;
  const std::regex expression(pattern);
  for (std::sregex_iterator m(text.begin(), text.end(), expression), end; m != end; ++m)
    found.insert((*m)[1]);
  return found;
}

TEST(Page, EveryTextIsEscaped) {
  const std::string page = html(sample());
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
  for (const char* wanted : {"Plate &amp; &lt;script&gt;alert(1)&lt;/script&gt;", "Is 1 &lt; 2?",
                             "Yes &quot;it&quot; is.", "caption &amp; more", "plumb run &#39;a b.toml&#39;"})
    EXPECT_NE(page.find(wanted), std::string::npos) << wanted;
}

TEST(Page, EveryWordIsExplained) {
  const std::string page = html(sample());
  for (const auto& one : plumb::verdict_words)
    EXPECT_NE(page.find("<td>" + std::string(one.word) + "</td><td data-l=\"meaning\">"), std::string::npos)
        << one.word;
  for (const auto& name : verdict_names()) EXPECT_FALSE(plumb::meaning_of(name).empty()) << name;
  EXPECT_NE(page.find("m^2 in 2D and m^2.5 in 3D"), std::string::npos);
}

/// `text` without what stands between `from` and `to`.
std::string without(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += from.size())
    text.erase(at + from.size(), text.find(to, at) - at - from.size());
  return text;
}

TEST(Page, NothingComesFromTheNetwork) {
  const std::string page = without(html(sample()), "<script>", "</script>");  // KaTeX has words of HTML in it
  // A link to a paper is followed by a reader, if at all: nothing loads it.
  const std::regex paper(R"(<a href="https://(doi|arxiv)\.org/)");
  for (const auto& place :
       all(std::regex_replace(page, paper, "<a href=\"#"), R"((?:src|href|action)=["']([^"']*)["'])"))
    EXPECT_TRUE(place.starts_with("#") || place.starts_with("data") || place.starts_with("figures/"))
        << place;
  EXPECT_EQ(page.find("@import"), std::string::npos);
  for (std::size_t at = 0; (at = page.find("url(", at)) != std::string::npos; ++at)
    EXPECT_EQ(page.compare(at, 9, "url(data:"), 0) << page.substr(at, 40);
}

TEST(Page, IdsAreUniqueAndEveryAnchorHasOne) {
  const std::string page = html(sample());
  std::multiset<std::string> ids;
  const std::regex expression(R"( id=["']([^"']*)["'])");
  for (std::sregex_iterator m(page.begin(), page.end(), expression), end; m != end; ++m) ids.insert((*m)[1]);
  for (const auto& id : ids) EXPECT_EQ(ids.count(id), 1u) << id;
  for (const auto& anchor : all(page, R"(href=["']#([^"']*)["'])"))
    EXPECT_EQ(ids.count(anchor), 1u) << anchor;
  EXPECT_EQ(ids.count("cmd-plate-run"), 1u);
}

/// A table that answers the question stands above the pictures; it is there once.
TEST(Page, TablesStandAboveOrBelowThePictures) {
  Page page = sample();
  Section& section = page.sections[0].section;
  section.tables.push_back(section.tables[0]);
  section.tables[1].id = "second";
  section.tables[1].title = "The second";
  const auto places = [&](std::size_t above) {
    section.tables_above = above;
    const std::string text = html(page);
    EXPECT_EQ(text.find("The second"), text.rfind("The second"));
    const auto pictures = text.find("class=\"figs\"");
    return std::pair(text.find("Levels") < pictures, text.find("The second") < pictures);
  };
  EXPECT_EQ(places(0), std::pair(false, false));
  EXPECT_EQ(places(1), std::pair(true, false));
  EXPECT_EQ(places(2), std::pair(true, true));
}

TEST(Page, CountsEveryVerdictOnTheFirstScreen) {
  const auto counts = count_verdicts(sample().sections);
  ASSERT_EQ(counts.size(), verdict_names().size());
  EXPECT_EQ(counts[0], (std::pair<std::string, std::size_t>{"pass", 1}));
  for (const auto& [name, count] : counts)
    EXPECT_EQ(count, name == "pass" || name == "fail" || name == "not-computed" ? 1u : 0u) << name;
  EXPECT_NE(html(sample()).find("<b>1</b> not-computed"), std::string::npos);
}

/// What shows nothing about a number is counted apart, and when it fails it is seen all the same.
TEST(Page, BookKeepingIsNotCountedAmongWhatPassed) {
  Page page = sample();
  auto& checks = page.sections[0].section.checks;
  checks.push_back({"runs to its end", "completed", "completed", "pass", {}, CheckKind::book_keeping});
  EXPECT_EQ(count_verdicts(page.sections)[0].second, 1u);
  checks.push_back({"claims", "at least 40", "39", "fail", {}, CheckKind::book_keeping});
  checks.push_back({"loss", "6 %", "6 %", "pass", {}, CheckKind::reproduced});
  EXPECT_EQ(count_verdicts(page.sections)[0].second, 2u);
  EXPECT_EQ(count_verdicts(page.sections)[1].second, 2u);
  std::map<std::string, std::pair<std::size_t, std::size_t>> kinds;
  for (const auto& [kind, passed, total] : count_kinds(page.sections)) kinds[name_of(kind)] = {passed, total};
  const std::map<std::string, std::pair<std::size_t, std::size_t>> wanted{
      {"verified", {1, 3}}, {"reproduced", {1, 1}}, {"regression", {0, 0}}, {"book-keeping", {1, 2}}};
  EXPECT_EQ(kinds, wanted);
  const std::string text = html(page), first = text.substr(0, text.find("<main>"));
  EXPECT_NE(first.find("<b>1 of 3</b> verified"), std::string::npos);
  EXPECT_NE(first.find("<b>1 of 2</b> book-keeping"), std::string::npos);
  EXPECT_EQ(first.find("regression"), std::string::npos);
}

TEST(Page, EveryRowLinksToItsCommandAndItsPicture) {
  Page page = sample();
  PageSection& section = page.sections[0];
  JobResult other;
  other.command = "plumb list";
  section.jobs.emplace_back("other-run", other);
  DataTable& table = section.section.tables[0];
  table.figures.clear();  // found by the job then
  table.jobs = {"plate-run", "other-run"};
  const std::string by_row = html(page);
  EXPECT_NE(by_row.find("<a href=\"#fig-plate-error\">picture</a> · <a href=\"#cmd-plate-run\">command</a>"),
            std::string::npos);
  EXPECT_NE(by_row.find("<td class=\"see\"><a href=\"#cmd-other-run\">command</a>"), std::string::npos);
  table.jobs = {"plate-run", "other-run",
                "plate-run"};  // which row is whose is not known: the list of commands
  EXPECT_NE(html(page).find("<td class=\"see\"><a href=\"#plate-how\">command</a>"), std::string::npos);
  table.row_jobs = {"other-run", "plate-run"};
  EXPECT_EQ(html(page).find(
                "<td class=\"see\"><a href=\"#plate-how\">command</a></td></tr>\n</tbody></table></div><p"),
            std::string::npos);
}

TEST(Page, FirstScreenShowsScoresAndWhatDidNotPass) {
  Page page = sample();
  page.sections[0].section.headlines = {{"94 of 94", "planted faults"}};
  const std::string text = html(page);
  const std::string first = text.substr(0, text.find("<main>"));
  EXPECT_NE(first.find("<b>94 of 94</b> planted faults"), std::string::npos);
  EXPECT_NE(first.find("What did not pass"), std::string::npos);
  EXPECT_NE(first.find("floor"), std::string::npos);           // failed
  EXPECT_NE(first.find("<td>later</td>"), std::string::npos);  // not computed
  EXPECT_EQ(first.find("<td>order</td>"), std::string::npos);  // passed
}

TEST(Page, FramesAreAllInThePage) {
  Page page = sample();
  Figure& figure = page.sections[0].section.figures[0];
  figure.frames = {{"t = 1 s", figure.picture}, {"t = 2 s", figure.picture}};
  const std::string text = html(page);
  EXPECT_NE(text.find("t = 1 s"), std::string::npos);
  EXPECT_NE(text.find("t = 2 s"), std::string::npos);
}

TEST(Page, TablesShowRoundedNumbersAndKeepAllDigitsForSorting) {
  const std::string page = html(sample());
  const auto sort_values = all(page, "data-v=\"([^\"]*)\">1.2·10⁻⁷</td>");
  ASSERT_EQ(sort_values.size(), 1u);
  EXPECT_EQ(std::stod(*sort_values.begin()), 1.2345e-7);
  EXPECT_NE(page.find(">not finite</td>"), std::string::npos);
}

TEST(Page, NumbersHaveAsManyDigitsAsTheyAreWorth) {
  EXPECT_EQ(number_text(1.2345, 3), "1.23");
  EXPECT_EQ(number_text(123.45, 2), "123");
  EXPECT_EQ(number_text(-0.0123456, 3), "-0.0123");
  EXPECT_EQ(number_text(0, 3), "0");
  EXPECT_EQ(number_text(64000.4, 0), "64000");  // a count
  EXPECT_EQ(number_text(64000, 1), "64000");
  EXPECT_EQ(number_text(0.012, 1), "0.01");
  EXPECT_EQ(number_text(1.5e12, 2), "1.5·10¹²");
}

TEST(Checks, VerdictsFollowTheData) {
  EXPECT_EQ(number_check("", 1.0 + 1e-9, 1.0, 1e-8, "").verdict, "pass");
  EXPECT_EQ(number_check("", 1.0, 1.0, 1e-8, "").measured, "1, exactly");
  EXPECT_EQ(number_check("", 1.0 + 1e-7, 1.0, 1e-8, "").verdict, "fail");
  EXPECT_EQ(number_check("", std::numeric_limits<double>::quiet_NaN(), 1.0, 1e-8, "").verdict, "fail");
  EXPECT_EQ(bound_check("", 2e-12, 1e-12, "").verdict, "fail");
  EXPECT_EQ(bound_check("", std::numeric_limits<double>::quiet_NaN(), 1e-12, "").verdict, "fail");
  const std::vector<double> d{0.2, 0.1, 0.05, 0.025};
  EXPECT_EQ(order_check("", d, {4e-2, 1e-2, 2.5e-3, 6.25e-4}, 2).verdict, "pass");
  EXPECT_EQ(order_check("", d, {4e-2, 2e-2, 1e-2, 5e-3}, 2).verdict, "fail");
  EXPECT_EQ(order_check("", {0.2, 0.1}, {4e-2, 1e-2}, 2).verdict, "too-few-levels");
}

}  // namespace
