#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "reports/page/page.hpp"
#include "tests/support/program.hpp"

namespace {

using namespace plumb::reports;
using plumb::test::run_shell;

/// A page with a picture, a wide table with many rows and long words.
std::string page_text() {
  Picture picture{"Error against spacing", {"spacing", "m", Scale::log}, {"error", "m", Scale::log}};
  picture.series = {{"first", {0.1, 0.2, 0.4}, {1, 4, 16}}};
  DataTable table{"rows", "Rows", {}, {}};
  for (int c = 0; c < 14; ++c) table.columns.push_back({"a column with a name " + std::to_string(c)});
  for (int r = 0; r < 9; ++r) {
    std::vector<Entry> row;
    for (int c = 0; c < 14; ++c) row.emplace_back(static_cast<double>((r * 7 + 3) % 9) + 0.1 * c);
    table.rows.push_back(row);
  }
  PageSection section{"one", "A section", {}, {}};
  section.section.question = "Is it readable?";
  section.section.answer = std::string(120, 'x') + " " + std::string(30, 'y');
  section.section.figures = {{"figure", picture, "caption"}};
  section.section.tables = {table};
  section.section.checks = {{"a check", "expected", "measured", "pass"}};
  JobResult job;
  job.command = "plumb " + std::string(200, 'z');
  section.jobs = {{"job", job}};
  return html({"A report", "about", {{"commit", "abc"}}, {section}});
}

/// Does what a reader does and tells the page around it what it saw.
constexpr const char* reader = R"js(<script>
const seen = {};
const root = document.documentElement;
seen.frame = innerWidth;
seen.overflow = root.scrollWidth - root.clientWidth;
const table = document.querySelector('#rows table');
const shown = () => [...table.tBodies[0].rows].filter(r => !r.hidden).length;
const first = () => [...table.tBodies[0].rows].map(r => Number(r.cells[0].dataset.v));
const heading = table.tHead.rows[0].cells[0].querySelector('button');
heading.click(); seen.up = first();
heading.click(); seen.down = first();
const filter = document.querySelector('#rows input.filter');
filter.value = '9.300'; filter.dispatchEvent(new Event('input')); seen.filtered = shown();
filter.value = ''; filter.dispatchEvent(new Event('input')); seen.all = shown();
seen.text = parseFloat(getComputedStyle(document.querySelector('p.a')).fontSize);
parent.postMessage(JSON.stringify(seen), '*');
</script>)js";

class Browser : public ::testing::TestWithParam<int> {};

/// Opens the page in headless Chromium, uses it, and reads the result from the document's title.
TEST_P(Browser, OpensWithoutErrorsFitsTheWidthSortsAndFilters) {
  if (run_shell("command -v chromium").code != 0)
    GTEST_SKIP() << "chromium is not installed: nothing to open the page with";
  const plumb::test::TemporaryFolder folder;
  std::string page = page_text();
  page.insert(page.find("</body>"), reader);
  std::ofstream(folder / "page.html") << page;
  // A frame, because a window of Chromium is never narrower than 500 pixels.
  std::ofstream(folder / "frame.html")
      << "<title></title><script>onmessage = e => { document.title = e.data; };</script>"
         "<iframe src=\"page.html\" style=\"border:0;height:900px;width:"
      << GetParam() << "px\"></iframe>";
  const auto outcome = run_shell(
      "timeout 60 chromium --headless --no-sandbox --disable-gpu --disable-background-networking "
      "--enable-logging=stderr --user-data-dir=" +
      (folder / "profile").string() +
      " --window-size=1800,1000 --virtual-time-budget=3000 --dump-dom file://" +
      (folder / "frame.html").string());
  ASSERT_EQ(outcome.code, 0) << outcome.error;
  EXPECT_EQ(outcome.error.find("CONSOLE"), std::string::npos) << outcome.error;
  const auto start = outcome.out.find("<title>") + 7;
  const auto seen = nlohmann::json::parse(outcome.out.substr(start, outcome.out.find("</title>") - start));
  EXPECT_EQ(seen["frame"], GetParam());
  EXPECT_LE(seen["overflow"], 0) << "the page is wider than the window";
  EXPECT_EQ(seen["up"], (std::vector<double>{0, 1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(seen["down"], (std::vector<double>{8, 7, 6, 5, 4, 3, 2, 1, 0}));
  EXPECT_EQ(seen["filtered"], 1);
  EXPECT_EQ(seen["all"], 9);
  EXPECT_GE(seen["text"], 16);  // CSS pixels: the size that telephones are made for
}

INSTANTIATE_TEST_SUITE_P(Widths, Browser, testing::Values(400, 1600));

}  // namespace
