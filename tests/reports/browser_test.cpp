#include "tests/support/browser.hpp"

#include <gtest/gtest.h>

#include "reports/page/page.hpp"

namespace {

using namespace plumb::reports;
using plumb::test::Browser;

/// A page with a picture, frames, a wide table with many rows, and long words.
std::string page_text() {
  Picture picture{"Error against spacing", {"spacing", "m", Scale::log}, {"error", "m", Scale::log}};
  picture.series = {{"first", {0.1, 0.2, 0.4}, {1, 4, 16}}};
  DataTable table{"rows", "Rows", {}, {}};
  for (int c = 0; c < 14; ++c) table.columns.push_back({"a column with a name " + std::to_string(c)});
  for (int r = 0; r < 23; ++r) {
    std::vector<Entry> row;
    row.reserve(14);
    for (int c = 0; c < 14; ++c) row.emplace_back(static_cast<double>((r * 7 + 3) % 23) + 0.1 * c);
    table.rows.push_back(row);
  }
  PageSection section{"one", "A section", {}, {}};
  section.section.question = "Is it readable?";
  section.section.answer = std::string(120, 'x') + " " + std::string(30, 'y');
  section.section.figures = {{"figure", picture, "caption"}, {"moving", picture, "frames"}};
  for (const char* time : {"t = 1 s", "t = 2 s", "t = 3 s"})
    section.section.figures[1].frames.push_back({time, picture});
  section.section.tables = {table};
  section.section.checks = {{"a check", "expected", "measured", "pass"}, {"another", "2", "3", "fail"}};
  section.section.headlines = {{"9 of 9", "faults"}};
  section.section.notes = {"See THEORY (5.3) and THEORY chapter 11."};
  JobResult job;
  job.command = "plumb " + std::string(200, 'z');
  section.jobs = {{"job", job}};
  return html({"A report", "about", {{"commit", "abc"}}, {section}});
}

class InBrowser : public ::testing::TestWithParam<int> {
 protected:
  void SetUp() override {
    if (!Browser::installed())
      FAIL() << "chromium or pdftotext is not installed: both are in .ci/packages.txt";
  }
};

TEST_P(InBrowser, OpensWithoutErrorsFitsTheWidthSortsFiltersAndMoves) {
  const auto seen = Browser().open(page_text(), GetParam(), plumb::test::reader);
  EXPECT_EQ(seen["console"], "");
  EXPECT_EQ(seen["frame"], GetParam());
  EXPECT_LE(seen["overflow"], 0) << "the page is wider than the window";
  EXPECT_TRUE(seen["lost"].empty()) << seen["lost"];
  EXPECT_TRUE(seen["twice"].empty()) << seen["twice"];
  EXPECT_TRUE(seen["unsorted"].empty()) << seen["unsorted"];
  EXPECT_TRUE(seen["unfiltered"].empty()) << seen["unfiltered"];
  EXPECT_EQ(seen["sliders"], 1);
  EXPECT_TRUE(seen["stuck"].empty()) << seen["stuck"];
  EXPECT_GE(seen["text"], 16);  // CSS pixels: the size that telephones are made for
}

/// Every formula of lib/theory is one for KaTeX, which is strict: a slip is an error and not a guess. What is drawn needs no font
/// but those inside the page, and leaves no letter of LaTeX behind.
TEST_F(InBrowser, DrawsEveryFormula) {
  const auto seen = Browser().open(page_text(), 1600, R"js(
const all = [...document.querySelectorAll('x-equation')];
seen.formulas = all.length;
seen.undrawn = all.filter(e => !e.querySelector('.katex-html')).map(e => e.textContent);
seen.refused = [...document.querySelectorAll('.katex-error')].map(e => e.title);
const inside = [...document.querySelector('style').textContent.matchAll(/@font-face{font-family:(KaTeX_\w+);font-style:(\w+)/g)]
  .map(m => m[1] + ' ' + m[2]);
const kinds = new Map([...document.querySelectorAll('.katex-html *')].map(e => [e.parentElement.className + '/' + e.className, e]));
seen.fonts = [...new Set([...kinds.values()].map(e => getComputedStyle(e))
  .map(s => s.fontFamily.split(',')[0] + ' ' + s.fontStyle + (s.fontWeight === '400' ? '' : ' ' + s.fontWeight)))]
  .filter(f => !inside.includes(f));
)js");
  EXPECT_EQ(seen["console"], "");
  EXPECT_GT(seen["formulas"], 1000);
  EXPECT_TRUE(seen["undrawn"].empty())
      << "without libjs-katex nothing is drawn; it is in .ci/packages.txt: " << seen["undrawn"];
  EXPECT_TRUE(seen["refused"].empty()) << seen["refused"];
  EXPECT_TRUE(seen["fonts"].empty()) << seen["fonts"];
}

INSTANTIATE_TEST_SUITE_P(Widths, InBrowser, testing::Values(400, 1600));

/// Paper has no script: what it shows is also what a reader without JavaScript can read, closed tables
/// included.
TEST_F(InBrowser, PrintsEverythingWithoutScriptAndCutsNothing) {
  const Browser browser;
  const std::string page = page_text();
  const auto cells = browser.open(page, 1600, plumb::test::reader)["cells"];
  ASSERT_GT(cells.size(), 23u * 14u);
  int words = 0, outside = 0;
  const std::string printed = browser.print(page, words, outside);
  EXPECT_GT(words, 1000);
  EXPECT_EQ(outside, 0);
  for (const auto& cell : cells)
    EXPECT_NE(printed.find(cell.get<std::string>()), std::string::npos) << cell << " is not on the sheets";
}

}  // namespace
