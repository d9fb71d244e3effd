#include "lib/output/json.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

TEST(Json, NonFiniteNumbersBecomeNullAndTheStatusSaysWhich) {
  const Json clean = with_finite_numbers({{"rmse", nan}, {"ci95", {-inf, 2.0, inf}}, {"n", 20}});
  EXPECT_TRUE(clean["rmse"].is_null());
  EXPECT_TRUE(clean["ci95"][0].is_null());
  EXPECT_EQ(clean["ci95"][1], 2.0);
  EXPECT_EQ(clean["status"], "not finite: rmse (nan), ci95[0] (-inf), ci95[2] (inf)");
}

TEST(Json, StatusBelongsToTheInnermostObject) {
  const Json clean = with_finite_numbers({{"rows", {{{"x", 1.0}}, {{"x", nan}}}}});
  EXPECT_FALSE(clean.contains("status"));
  EXPECT_FALSE(clean["rows"][0].contains("status"));
  EXPECT_EQ(clean["rows"][1]["status"], "not finite: x (nan)");
}

TEST(Json, StatusOfTheResultIsKept) {
  const Json clean = with_finite_numbers({{"status", "unstable"}, {"energy", inf}});
  EXPECT_EQ(clean["status"], "unstable");
  EXPECT_EQ(clean["not_finite"], "energy (inf)");
}

TEST(Json, FiniteValuesAreUntouched) {
  const Json value{{"a", {1, 2.5, "text", nullptr, true}}, {"b", {{"c", -0.0}}}};
  EXPECT_EQ(with_finite_numbers(value), value);
}

TEST(Json, NumbersReadBackToTheSameBits) {
  Json list = Json::array();
  for (const double x : {0.1, 1.0 / 3, 5e-324, 1.7976931348623157e308, 9007199254740993.0, -0.0, 1e23})
    list.push_back(x);
  const Json back = Json::parse(json_text({{"x", list}}));
  for (std::size_t k = 0; k < list.size(); ++k) {
    EXPECT_EQ(back["x"][k].get<double>(), list[k].get<double>());
    EXPECT_EQ(std::signbit(back["x"][k].get<double>()), std::signbit(list[k].get<double>()));
  }
}

TEST(Json, TextIsValidUtf8AndEndsWithANewline) {
  EXPECT_EQ(json_text({{"name", "Fließ"}}), "{\n \"name\": \"Fließ\"\n}\n");
  EXPECT_NO_THROW(Json::parse(json_text({{"name", "broken \xff byte"}})));
}

}  // namespace
}  // namespace plumb
