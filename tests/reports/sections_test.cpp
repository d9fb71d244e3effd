// What every section says of invented results is what it said: words to the letter, numbers to 1e-6, pictures
// and tables by their axes, units and digits and by sums of what they show. A change that is meant is written
// to tests/reports/sections by
//   PLUMB_WRITE_SAID=1 tests_reports --gtest_filter='*Sections*'
// and read before it is kept. Regression: which number is right is the matter of the other tests of this
// room.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <set>

#include "places.hpp"
#include "tests/reports/invented_report.hpp"
#include "tests/support/said.hpp"

namespace {

using namespace plumb::reports;
namespace test = plumb::test;

/// A list of numbers as its length, its sum, and a sum that depends on their order.
std::string sums_of(const std::vector<double>& values) {
  double sum = 0, ordered = 0;
  for (std::size_t n = 0; n < values.size(); ++n)
    if (std::isfinite(values[n])) {
      sum += values[n];
      ordered += values[n] / static_cast<double>(n + 1);
    }
  return fmt::format("{} numbers, sum {:.8g}, ordered {:.8g}", values.size(), sum, ordered);
}

std::string words_of(const Axis& axis) {
  const auto end = [](const std::optional<double>& value) {
    return value ? fmt::format("{:.8g}", *value) : "free";
  };
  return fmt::format("{} [{}] {} from {} to {}, ticks {}", axis.label, axis.unit,
                     axis.scale == Scale::log ? "log" : "linear", end(axis.min), end(axis.max),
                     sums_of(axis.ticks));
}

class Sections : public test::InventedReport {
 protected:
  template <class... Arguments>
  void say(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
    for (const auto& line : test::lines_of(fmt::format(text, std::forward<Arguments>(arguments)...)))
      said.push_back(line);
  }

  void say_map(const Picture& picture) {
    if (const auto* map = std::get_if<HeatMap>(&picture.map))
      say("  heat map {} [{}]: {}; {}; {}", map->label, map->unit, sums_of(map->x), sums_of(map->y),
          sums_of(map->z));
    if (const auto* map = std::get_if<PointMap>(&picture.map))
      say("  points {} [{}] of size {:.8g}: {}; {}; {}", map->label, map->unit, map->size, sums_of(map->x),
          sums_of(map->y), sums_of(map->z));
    if (const auto* map = std::get_if<Intervals>(&picture.map))
      for (std::size_t n = 0; n < map->names.size(); ++n)
        say("  {}: {:.8g} {:.8g} {:.8g}, expected {:.8g}", map->names[n], map->low[n], map->value[n],
            map->high[n], map->expected[n]);
    if (const auto* map = std::get_if<Patches>(&picture.map)) {
      say("  patches {} [{}] from {:.8g} to {:.8g}: {}; {}; {}", map->label, map->unit, map->low.value_or(-1),
          map->high.value_or(-1), sums_of(map->x), sums_of(map->y), sums_of(map->z));
      for (const auto& rod : map->rods)
        say("  rod {}: {:.8g} {:.8g} {:.8g} {:.8g}", rod.label, rod.x0, rod.y0, rod.x1, rod.y1);
    }
  }

  void say_picture(const Picture& picture) {
    say("  {} ({} x {}, {}, {})", picture.title, picture.width, picture.height,
        picture.labels == Labels::legend ? "legend" : "names at the ends",
        picture.equal_axes ? "equal axes" : "free axes");
    say("  x {}\n  y {}", words_of(picture.x), words_of(picture.y));
    for (const auto& s : picture.series)
      say("  {}: style {}, colour {}, {}, x {}, y {}, band {}", s.label, static_cast<int>(s.style),
          s.colour ? std::to_string(*s.colour) : "its own", s.dashed ? "dashed" : "drawn through",
          sums_of(s.x), sums_of(s.y), s.band ? sums_of(s.band->low) + "; " + sums_of(s.band->high) : "none");
    for (const auto& t : picture.triangles)
      say("  triangle of order {:.8g} below series {}", t.order, t.series);
    for (const auto& l : picture.lines)
      say("  line {} at {:.8g}, {}", l.label, l.at, l.vertical ? "vertical" : "level");
    say_map(picture);
  }

  void say_table(const DataTable& table) {
    say("table {}: {}", table.id, table.title);
    for (const auto& column : table.columns)
      say("  column {} [{}], {} digits", column.name, column.unit, column.digits);
    std::vector<double> numbers;
    for (const auto& row : table.rows) {
      std::string words;
      for (const auto& entry : row) {
        if (const auto* number = std::get_if<double>(&entry)) numbers.push_back(*number);
        const auto* word = std::get_if<std::string>(&entry);
        words += word ? *word + " | " : std::holds_alternative<double>(entry) ? "number | " : "nothing | ";
      }
      say("  {}", words);
    }
    say("  {}", sums_of(numbers));
    say("  jobs {}; figures {}; jobs of rows {}", fmt::join(table.jobs, " "), fmt::join(table.figures, " "),
        fmt::join(table.row_jobs, " "));
  }

  void say_section(const Section& s) {
    said.clear();
    say("{}\n{}", s.question, s.answer);
    for (const auto& h : s.headlines) say("headline {}: {}", h.number, h.what);
    for (const auto& c : s.checks)
      say("check {} | {} | {} | {} | {} | {}", c.what, c.expected, c.measured, c.verdict, c.job,
          name_of(c.kind));
    for (const auto& f : s.figures) {
      say("figure {}: {}\n  jobs {}", f.id, f.caption, fmt::join(f.jobs, " "));
      say_picture(f.picture);
      for (const auto& frame : f.frames) {
        say("  frame {}", frame.label);
        say_picture(frame.picture);
      }
    }
    for (const auto& t : s.tables) say_table(t);
    for (const auto& n : s.notes) say("note {}", n);
  }

  /// Compares what is said with what is kept under that name; 1e-12: zero but for round-off.
  void compare(const std::string& name, double relative) const {
    const std::string kept = PLUMBLINE_SOURCE_DIR "/tests/reports/sections/" + name + ".txt";
    if (std::getenv("PLUMB_WRITE_SAID")) {
      std::ofstream out(kept);
      for (const auto& line : said) out << line << '\n';
    }
    EXPECT_EQ(test::differences(said, test::lines_of(test::content_of(kept)), relative, 1e-12), "")
        << name << "\n(if this is meant: PLUMB_WRITE_SAID=1 writes it anew)";
  }

  std::vector<std::string> said;
};

TEST_F(Sections, SayWhatTheySaid) {
  ASSERT_GT(sections.size(), 15u);
  for (const auto& [id, section] : sections) {
    say_section(section);
    for (auto& line : said) line = test::rounded(line);
    compare(id, 1e-6);  // sums of some hundred numbers in any order, printed with 8 digits
  }
}

/// What a job is asked, too: commands are shown beside the results. Of a long report, what is not in the full one.
TEST_F(Sections, AskWhatTheyAsked) {
  std::set<std::string> known;
  for (const auto& [extent, name] : {std::pair(Extent::full, "jobs"), {Extent::long_run, "jobs-long"}}) {
    said.clear();
    for (const auto& plan : section_plans(extent)) {
      say("{} {} {}", plan.place, plan.id, plan.title);
      for (const auto& job : plan.jobs) {
        const std::string line = fmt::format("  {}{}: {} < {}", job.id, job.alone ? " (alone)" : "",
                                             fmt::join(job.arguments, " "), fmt::join(job.inputs, " "));
        if (known.insert(line).second) say("{}", line);
      }
    }
    compare(name, 0);
  }
}

/// The core asks nothing that a full report does not ask, and shows something of every chapter.
TEST(Extents, TheCoreIsAPartOfTheFullReportAndHasAllChapters) {
  std::map<std::string, std::vector<std::string>> full;
  std::set<std::string> chapters, shown;
  for (const auto& plan : section_plans(Extent::full))
    for (const auto& job : plan.jobs) full[job.id] = job.arguments;
  std::size_t in_core = 0;
  for (const auto& plan : section_plans(Extent::core)) {
    chapters.insert(chapter_of(plan.place));
    if (plan.least > Extent::core) continue;
    shown.insert(chapter_of(plan.place));
    for (const auto& job : plan.jobs) {
      ASSERT_TRUE(full.contains(job.id)) << job.id;
      EXPECT_EQ(full.at(job.id), job.arguments) << job.id;
      ++in_core;
    }
  }
  EXPECT_EQ(shown, chapters);
  EXPECT_LT(in_core, full.size());
}

}  // namespace
