#include "lib/output/table.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

namespace plumb {
namespace {

TEST(Table, CsvQuotesOnlyWhatNeedsIt) {
  const Table table{{"name", "a, b"}, {{std::string("say \"so\""), std::string("two\nlines")}}};
  EXPECT_EQ(csv_text(table), "name,\"a, b\"\n\"say \"\"so\"\"\",\"two\nlines\"\n");
}

TEST(Table, CsvNumbersKeepAllDigits) {
  const Table table{{"x", "n"}, {{0.1, 12LL}, {1.0 / 3, -3LL}}};
  EXPECT_EQ(csv_text(table), "x,n\n0.10000000000000001,12\n0.33333333333333331,-3\n");
}

TEST(Table, CsvNamesNonFiniteNumbers) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  const Table table{{"a", "b", "c"}, {{std::numeric_limits<double>::quiet_NaN(), inf, -inf}}};
  EXPECT_EQ(csv_text(table), "a,b,c\nnan,inf,-inf\n");
}

TEST(Table, RowsOfJsonNeedNotHaveTheSameKeys) {
  const auto rows = nlohmann::ordered_json::parse(R"([{"n": 20, "ci": [1, 2]}, {"rmse": null, "n": 40}])");
  const Table table = table_of(rows);
  EXPECT_EQ(table.columns, (std::vector<std::string>{"n", "ci", "rmse"}));
  EXPECT_EQ(csv_text(table), "n,ci,rmse\n20,\"[1,2]\",\n40,,nan\n");
}

TEST(Table, PlainTextLinesUp) {
  const Table table{{"µ [Pa]", "n"}, {{1.5, 2LL}, {1234567.0, 3LL}}};
  EXPECT_EQ(plain_text(table), "µ [Pa]       n\n1.5          2\n1.23457e+06  3\n");
}

}  // namespace
}  // namespace plumb
