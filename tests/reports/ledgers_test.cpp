// What the sections made of stored lists say (planted faults, claims, sentences, bad input) and what maps of
// stability draw: results written by hand, and the sentences and numbers that follow from them.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "reports/named.hpp"
#include "reports/report.hpp"
#include "reports/results.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

using namespace plumb::reports;
using Json = nlohmann::ordered_json;

class Ledgers : public ::testing::Test {
 protected:
  void add(const std::string& job, const Json& json) {
    std::filesystem::create_directories(folder / job);
    std::ofstream(folder / job / "result.json") << json.dump();
    JobResult result;
    result.folder = folder / job;
    results.add(job, result);
  }
  Section section(const std::string& id) const {
    for (const auto& plan : section_plans(Extent::full))
      if (plan.id == id) return plan.write(results);
    throw std::runtime_error("no section " + id);
  }
  static std::string words(const DataTable& table, std::size_t row, std::size_t column) {
    return std::get<std::string>(table.rows.at(row).at(column));
  }
  static double value(const DataTable& table, std::size_t row, std::size_t column) {
    return std::get<double>(table.rows.at(row).at(column));
  }

  plumb::test::TemporaryFolder folder;
  Results results;
};

Json share(const std::string& name, int killed, int alive, double part, double low, double high) {
  return {{"folder", name},
          {"sampled", killed + alive + 3},
          {"killed", killed},
          {"alive", alive},
          {"equivalent", 1},
          {"not_compiled", 2},
          {"share", part},
          {"interval", {low, high}},
          {"killed_at_first", killed - 10},
          {"share_at_first", part - 0.25},
          {"interval_at_first", {low - 0.25, high - 0.25}}};
}

TEST_F(Ledgers, PlantedFaultsAreCountedAndTheSampleIsBesideThem) {
  const auto fault = [](const char* name, const Json& by, const char* date) {
    return Json{{"name", name}, {"file", "lib/a.cpp"}, {"caught_by", by}, {"date", date}, {"commit", "abc"}};
  };
  Json equivalent = fault("three", nullptr, "2026-01-03");
  equivalent["equivalent"] = "the same number";
  Json all = share("all", 30, 10, 0.75, 0.6, 0.86);
  all.erase("folder");
  add("faults",
      {{"faults",
        {fault("one", "laws: A.B", "2026-01-02"), fault("two", "laws: C.D", "2026-01-05"), equivalent,
         fault("four", nullptr, "2026-01-04")}},
       {"caught", 2},
       {"equivalent", 1},
       {"survived", 1},
       {"sampled",
        {{"seed", 7},
         {"commit", "def"},
         {"all", all},
         {"folders", {share("mms", 20, 5, 0.8, 0.61, 0.91), share("oned", 10, 5, 0.67, 0.42, 0.85)}}}}});
  const Section s = section("faults");
  EXPECT_EQ(
      s.answer,
      "2 of 4 planted faults turned a test red, 1 are explained as equivalent, 1 survived. Of slips drawn "
      "at random from the sources, 30 of 40 are seen: 75 %, 95 % interval 60 to 86 %; before tests were "
      "written for those of this very sample it was 50 %, 35 to 61 %.");
  EXPECT_EQ(s.checks.at(0).verdict, "fail");
  EXPECT_EQ(s.checks.at(0).measured, "1");
  const DataTable sample = by_id(s.tables, "sampled-faults");
  ASSERT_EQ(sample.rows.size(), 3u);
  EXPECT_EQ(words(sample, 0, 0), "in all");
  const double expected[] = {30, 10, 75, 60, 86};
  for (std::size_t k = 0; k < 5; ++k) EXPECT_NEAR(value(sample, 0, k + 1), expected[k], 1e-9);
  EXPECT_EQ(words(sample, 1, 0), "mms");
  EXPECT_EQ(value(sample, 1, 1), 20);
  EXPECT_NEAR(value(sample, 2, 5), 85, 1e-9);
  const DataTable programs = by_id(s.tables, "planted-faults-by");
  ASSERT_EQ(programs.rows.size(), 1u);
  EXPECT_EQ(words(programs, 0, 0), "laws");
  EXPECT_EQ(value(programs, 0, 1), 2);
  const DataTable faults = by_id(s.tables, "planted-faults");
  ASSERT_EQ(faults.rows.size(), 4u);
  for (const auto& [row, by] : {std::pair(0, "laws: A.B"), {2, "the same number"}, {3, "survived"}})
    EXPECT_EQ(words(faults, static_cast<std::size_t>(row), 2), by);
  EXPECT_NE(s.notes.at(0).find("from 2026-01-02 to 2026-01-05"), std::string::npos) << s.notes[0];
  bool told = false;
  for (const auto& note : s.notes)
    told =
        told || note.find("seed 7, commit def): 43 drawn, 2 do not compile, 1 are explained as equivalent") !=
                    std::string::npos;
  EXPECT_TRUE(told);
}

TEST_F(Ledgers, ClaimsAreCountedByStatusAndPart) {
  const auto claim = [](const char* where, const char* status) {
    return Json{{"paper", "000"},
                {"where", where},
                {"claim", "c"},
                {"published", "p"},
                {"status", status},
                {"finding", "f"},
                {"evidence", "e"},
                {"unit", "m"},
                {"readings",
                 {{{"name", "one"}, {"value", 0.25}, {"holds", true}},
                  {{"name", "two"}, {"value", 4}, {"holds", false}}}}};
  };
  add("claims", {{"claims",
                  {claim("4.1, Figure 4", "reproduced"), claim("5.1", "reproduced"),
                   claim("5.1", "reproduced"), claim("5.2", "contradicted"), claim("5.2", "contradicted"),
                   claim("5.3, Table 1", "open"), claim("6", "ambiguous"), claim("5.5", "ambiguous"),
                   claim("5.5", "ambiguous"), claim("5.5", "ambiguous")}}});
  const Section s = section("claims");
  EXPECT_EQ(
      s.answer,
      "Of 10 claims 3 are reproduced in every reading tried, 4 in some readings only (ambiguous), 2 are "
      "contradicted and 1 are open.");
  ASSERT_EQ(s.headlines.size(), 1u);
  EXPECT_EQ(s.headlines[0].number, "10 claims");
  EXPECT_EQ(s.headlines[0].what, "of the papers: 3 reproduced, 4 ambiguous, 2 contradicted, 1 open");
  EXPECT_EQ(by_id(s.tables, "claims-003").rows.size(), 0u);
  EXPECT_EQ(by_id(s.tables, "claims-4").rows.size(), 2u);  // what section 6 says stands with 4
  EXPECT_EQ(by_id(s.tables, "claims-5-5").rows.size(), 3u);
  const DataTable first = by_id(s.tables, "claims-5-1");
  for (const auto& [column, text] :
       {std::pair(0, "5.1"), {1, "c"}, {2, "p"}, {3, "reproduced"}, {5, "f"}, {6, "e"}})
    EXPECT_EQ(words(first, 0, static_cast<std::size_t>(column)), text);
  EXPECT_EQ(words(first, 0, 4), "✓ 0.25 m: one\n✗ 4 m: two");
  std::map<std::string, std::string> verdicts;
  for (const auto& check : s.checks) verdicts[check.what] = check.verdict + " " + check.measured;
  EXPECT_EQ(verdicts["claims in the ledger"], "fail 10");
  EXPECT_EQ(verdicts["open claims of paper 000, section 5.3"], "fail 1");
  EXPECT_EQ(verdicts["open claims of paper 000, section 5.1"], "pass 0");
}

TEST_F(Ledgers, SentencesAreCounted) {
  const auto sentence = [](const char* holds) {
    return Json{{"where", "2.2"},
                {"claim", "c"},
                {"holds", holds},
                {"finding", "f"},
                {"measured", {{"a", 0.5}, {"b", nullptr}}}};
  };
  add("account", {{"sentences",
                   {sentence("holds"), sentence("holds"), sentence("does not hold"), sentence("with RK3"),
                    sentence("holds"), sentence("does not hold")}}});
  const Section s = section("account");
  EXPECT_EQ(
      s.answer,
      "Of 6 sentences 3 hold, 1 hold under a condition that the paper does not state, and 2 do not hold.");
  const std::vector<std::string> row{"2.2", "c", "holds", "f", "a = 0.5000; b = not finite"};
  for (std::size_t k = 0; k < row.size(); ++k) EXPECT_EQ(words(s.tables.at(0), 0, k), row[k]);
}

TEST_F(Ledgers, RefusalsAreCounted) {
  add("refusals",
      {{"count", 90}, {"wrong", 2}, {"slowest_s", 0.25}, {"rows", {{{"what", "w"}, {"message", "m"}}}}});
  const Section s = section("bad-input");
  EXPECT_EQ(s.answer, "90 bad inputs were tried; 2 of them got another message than the one written down.");
  EXPECT_EQ(s.checks.at(0).verdict, "fail");
  EXPECT_EQ(s.checks.at(0).expected, "all 90");
  EXPECT_EQ(s.checks.at(0).measured, "88");
  EXPECT_EQ(s.checks.at(1).verdict, "pass");
  EXPECT_EQ(s.checks.at(2).verdict, "pass");
  EXPECT_EQ(words(s.tables.at(0), 0, 0) + words(s.tables[0], 0, 1), "wm");
}

/// Two schemes at two values of the second parameter: stable up to `limit`, unstable from `y`.
class Maps : public Ledgers {
 protected:
  void SetUp() override {
    for (const auto& plan : section_plans(Extent::full))
      if (plan.id == "stability-maps")
        for (const auto& job : plan.jobs) add(job.id, study(job.id));
    add("edge-theory",
        {{"rows",
          {spectrum("verlet", "improved", "0.9", 1.0), spectrum("verlet", "improved", "1.2", 1.5),
           spectrum("rk3", "improved", "0.9", 9)}}});
    add("edge-small-motion", study("small motion"));
  }
  static Json spectrum(const char* integrator, const char* gradient, const char* beta, double cfl) {
    return {{"method.integrator", integrator},
            {"method.gradient", gradient},
            {"method.beta", beta},
            {"stable_cfl", cfl}};
  }
  static Json row(const char* variant, double x, const Json& limit, const Json& y, const Json& cause) {
    return {{"variant", variant},  {"x", x},      {"limit", limit},    {"y", y},    {"cause", cause},
            {"status", "no body"}, {"time", 0.5}, {"hourglass", 0.25}, {"runs", 7}, {"cpu_s", 2.5}};
  }
  static Json study(const std::string& name) {
    return {{"study", name},
            {"parameter", "cfl"},
            {"over", "beta"},
            {"from", 0.1},
            {"rows",
             {row("verlet, improved", 0.9, 1.0, 1.1, "inverted"),
              row("verlet, improved", 1.2, 1.45, 2.0, nullptr),
              row("other", 0.9, nullptr, nullptr, "refused"), row("other", 1.2, 0.5, 0.6, "hourglass")}}};
  }
};

TEST_F(Maps, NumbersAreThoseOfTheirRows) {
  const Section s = section("stability-maps");
  // 5 studies of 4 rows
  EXPECT_EQ(s.answer,
            "140 runs of 5 studies were driven to their edge in 50 s of CPU time; the causes are in colour.");
  const DataTable table = by_id(s.tables, "edge-small-motion-limits");
  ASSERT_EQ(table.rows.size(), 4u);
  EXPECT_EQ(words(table, 0, 0), "verlet, improved");
  const double numbers[] = {0.9, 1.0, 1.1};
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(value(table, 0, k + 1), numbers[k]);
  EXPECT_EQ(words(table, 0, 4), "inverted");
  const double rest[] = {0.5, 0.25, 7, 2.5};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(value(table, 0, k + 5), rest[k]);
  EXPECT_EQ(table.columns[1].name, "beta");
  EXPECT_EQ(table.columns[2].name, "stable up to cfl");
  // 1.0 against 1.0, 1.45 against 1.5: one in thirty
  EXPECT_EQ(s.checks.at(0).verdict, "pass");
  EXPECT_NE(s.checks[0].measured.find("0.033"), std::string::npos) << s.checks[0].measured;
  EXPECT_NE(s.notes.back().find("other, 0.9 (small motion)"), std::string::npos) << s.notes.back();
  EXPECT_NE(s.notes.back().find(": no body."), std::string::npos) << s.notes.back();
}

TEST_F(Maps, ColoursAreTheOutcomesOverTheParameter) {
  const Figure figure = by_id(section("stability-maps").figures, "edge-small-motion-map");
  EXPECT_EQ(figure.caption,
            "Schemes: 1: verlet, improved; 2: other. For each from left to right beta = 0.9, 1.2.");
  const auto& map = std::get<CategoryMap>(figure.picture.map);
  ASSERT_EQ(map.x.size(), 6u);  // two groups of two values and a gap
  const double x[] = {1 - 0.5 / 3, 1 + 0.5 / 3, 1.5, 2 - 0.5 / 3, 2 + 0.5 / 3, 2.5};
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(map.x[k], x[k], 1e-12);
  ASSERT_EQ(map.y.size(), 60u);
  const double top = 1.15 * 2.0;
  for (std::size_t j = 0; j < 60; ++j) {
    const double y = map.y[j];
    EXPECT_NEAR(y, top * (static_cast<double>(j) + 0.5) / 60, 1e-12);
    const auto seen = [&](std::size_t k) {
      return map.z.at(j * 6 + k) < 0 ? "" : map.names.at(static_cast<std::size_t>(map.z[j * 6 + k]));
    };
    EXPECT_EQ(seen(0), y <= 1.0 ? "stable" : y < 1.1 ? "" : "inverted") << y;
    EXPECT_EQ(seen(1), y <= 1.45 ? "stable" : "") << y;  // unstable from 2, of no known cause
    EXPECT_EQ(seen(2), "") << y;
    EXPECT_EQ(seen(3), "refused") << y;
    EXPECT_EQ(seen(4), y <= 0.5 ? "stable" : y < 0.6 ? "" : "hourglass") << y;
  }
}

/// Errors of 0.04 and 0.0025 for 1 s and 16 s, times a number of the scheme: 0.01 lies halfway in logarithms.
/// The coarsest level of the column is better than 0.01, and the paper's scheme breaks on its jittered plate.
TEST_F(Ledgers, CostsOfAnErrorAreBetweenTheLevels) {
  for (const auto& plan : section_plans(Extent::full))
    if (plan.id == "work-ratio")
      for (const auto& job : plan.jobs) {
        const double slow = job.id.ends_with("paper") ? 1 : job.id.ends_with("adjoint") ? 0.5 : 3;
        const double scale = job.id.starts_with("ratio-column") ? 0.2 : 1;
        const bool breaks = job.id == "ratio-plate-2-paper";
        const auto level = [&](double d, double error, double cost) {
          return Json{{"d", d},
                      {"relative_l2", breaks ? Json() : Json(scale * error)},
                      {"cpu_s", slow * cost},
                      {"setup_s", 3 * slow * cost}};
        };
        add(job.id, {{"levels", {level(0.2, 0.04, 1), level(0.1, 0.0025, 16)}}});
      }
  const Section s = section("work-ratio");
  // 0.01 and 0.001 of two solutions on two clouds, 0.0005 is the best of the column
  EXPECT_EQ(
      s.answer,
      "Of 8 errors asked for, compatible bonds reach 6 and the paper's scheme 5 with the levels computed.");
  const DataTable& table = s.tables.at(0);
  ASSERT_EQ(table.rows.size(), 24u);
  const auto is = [&](std::size_t row, std::size_t column, double expected) {
    EXPECT_NEAR(value(table, row, column), expected, 1e-12) << row << ' ' << column;
  };
  is(0, 2, 0.01);
  is(0, 4, 4);  // the paper's scheme: steps, with set-up, and the ratios to itself
  is(0, 5, 16);
  is(0, 6, 1);
  is(0, 7, 1);
  is(1, 4, 2);
  is(1, 7, 0.5);
  is(2, 4, 12);
  is(2, 6, 3);
  EXPECT_EQ(words(table, 3, 8), "not with these levels: 0.0025 at d = 0.1 m, order there 4.00");
  EXPECT_EQ(words(table, 6, 8), "the finest run breaks");
  EXPECT_TRUE(std::holds_alternative<std::monostate>(table.rows[7][6])) << "no ratio to a run that breaks";
  is(12, 4, 1);  // the column: what its coarsest level costs
  EXPECT_EQ(words(table, 12, 0), "stretched column under traction");
}

}  // namespace
