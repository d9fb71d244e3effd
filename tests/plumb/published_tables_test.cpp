// `plumb judge` on tables that other people have published with their orders:
// verification/campaigns/published.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "places.hpp"
#include "tests/support/program.hpp"

namespace plumb::published_tables_test {
namespace {

using Json = nlohmann::json;

const std::string folder = PLUMBLINE_SOURCE_DIR "/verification/campaigns/published/";

Json judged(const std::string& file, const std::string& options = "") {
  const auto outcome = test::run_shell(PLUMB_EXECUTABLE " judge '" + folder + file + "' --json - " + options);
  EXPECT_NE(outcome.code, 2) << outcome.error;
  return Json::parse(outcome.out);
}

/// Half a unit of the last digit of a number as it is printed.
double half_unit(const std::string& number) {
  const auto exponent = number.find('e'), point = number.find('.');
  const std::string digits = number.substr(0, exponent);
  const auto decimals = point == std::string::npos ? 0.0 : static_cast<double>(digits.size() - point - 1);
  const double power = exponent == std::string::npos ? 0 : std::stod(number.substr(exponent + 1));
  return 0.5 * std::pow(10, power - decimals);
}

/// The columns of a table, as text, by the names that judge gives them.
std::map<std::string, std::vector<std::string>> columns_of(const std::string& file) {
  std::map<std::string, std::vector<std::string>> columns;
  std::vector<std::string> names;
  std::istringstream lines(test::content_of(folder + file));
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream cells(line);
    std::vector<std::string> row;
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
    if (names.empty()) {
      names = row;
      names.front() = "h";
      continue;
    }
    for (std::size_t k = 0; k < row.size(); ++k) columns[names[k]].push_back(row[k]);
  }
  return columns;
}

/// How far the order between two rows may be off: rounding of the printed errors and of the printed order.
double uncertainty(const std::map<std::string, std::vector<std::string>>& columns, const std::string& name,
                   std::size_t row, double order_unit) {
  double of_errors = 0;
  for (const std::size_t k : {row, row + 1}) {
    const std::string& error = columns.at(name)[k];
    of_errors += half_unit(error) / std::stod(error);
  }
  const double ratio = std::stod(columns.at("h")[row]) / std::stod(columns.at("h")[row + 1]);
  return of_errors / std::log(ratio) + order_unit;
}

const Json& tables() {
  static const Json all = Json::parse(test::content_of(folder + "published.json"))["tables"];
  return all;
}

TEST(PublishedTables, EveryPrintedOrderIsFound) {
  std::size_t orders = 0, wrong = 0;
  for (const Json& table : tables()) {
    const std::string file = table["file"];
    if (table["columns"].empty()) continue;
    const auto columns = columns_of(file);
    const Json found = judged(file);
    for (const Json& fit : found["fits"]) {
      const std::string name = fit["norm"];
      const Json& printed = table["columns"].at(name);
      ASSERT_EQ(printed.size(), fit["pairwise"].size()) << file;
      for (std::size_t k = 0; k < printed.size(); ++k) {
        const double off = std::abs(fit["pairwise"][k].get<double>() - printed[k].get<double>());
        const double most = uncertainty(columns, name, k, 0.5 * std::pow(10, -table["decimals"].get<int>()));
        const std::string where = file + ", " + name + ", pair " + std::to_string(k + 1);
        ++orders;
        if (table.contains("contradicted") && table["contradicted"] == k) {
          EXPECT_GT(off, 100 * most) << where << " is said to contradict its rows";
          ++wrong;
        } else {
          EXPECT_LE(off, most * (1 + 1e-9))
              << where << ": " << fit["pairwise"][k] << ", printed " << printed[k];
        }
      }
    }
    EXPECT_EQ(found["fits"].size(), table["columns"].size()) << file;
  }
  EXPECT_EQ(orders, 122u);
  EXPECT_EQ(wrong, 2u);
}

TEST(PublishedTables, OrderLimitAndIndexOfThreeGrids) {
  int seen = 0;
  for (const Json& table : tables()) {
    if (!table.contains("limit")) continue;
    ++seen;
    const Json found = judged(table["file"], "--limit unknown");
    const auto half = [&](const char* key) { return 0.5 * std::pow(10, -table[key].get<int>()); };
    EXPECT_NEAR(found["order"].get<double>(), table["order"].get<double>(), half("order_decimals"));
    EXPECT_NEAR(found["limit"].get<double>(), table["limit"].get<double>(), half("limit_decimals"));
    ASSERT_EQ(found["gci"].size(), table["gci_percent"].size());
    for (std::size_t k = 0; k < found["gci"].size(); ++k)
      EXPECT_NEAR(100 * found["gci"][k].get<double>(), table["gci_percent"][k].get<double>(),
                  half("gci_decimals"));
  }
  EXPECT_EQ(seen, 1);
}

// Two tables print an order that does not follow from their rows. With one row more, whose spacing the others
// suggest and whose error follows from the printed order of the next pair, that order and the overall one do.
TEST(PublishedTables, TheLostRowIsFound) {
  int seen = 0;
  for (const Json& table : tables()) {
    if (!table.contains("overall")) continue;
    ++seen;
    const auto columns = columns_of(table["file"]);
    const double overall = table["overall"];
    EXPECT_GT(std::abs(judged(table["file"])["fits"][0]["order"].get<double>() - overall), 1e-3);
    const std::size_t before = table["contradicted"];
    const double lost = 10.0 / 127, h = std::stod(columns.at("h")[before + 1]),
                 error = std::stod(columns.at("error")[before + 1]) *
                         std::pow(lost / h, table["columns"]["error"][before].get<double>());
    std::string text = "h,error\n";
    for (std::size_t k = 0; k < columns.at("h").size(); ++k) {
      text += columns.at("h")[k] + "," + columns.at("error")[k] + "\n";
      if (k == before) text += fmt::format("{:.17g},{:.17g}\n", lost, error);
    }
    const test::TemporaryFolder own;
    std::ofstream(own / "whole.csv") << text;
    const auto outcome =
        test::run_shell(PLUMB_EXECUTABLE " judge " + (own / "whole.csv").string() + " --json -");
    EXPECT_NEAR(Json::parse(outcome.out)["fits"][0]["order"].get<double>(), overall, 1e-12);
  }
  EXPECT_EQ(seen, 2);
}

}  // namespace
}  // namespace plumb::published_tables_test
