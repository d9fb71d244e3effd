// What is recorded of other people's codes: its orders and verdicts follow from its errors, and the section
// says where it comes from.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "lib/convergence/order_fit.hpp"
#include "reports/assets.hpp"
#include "tests/reports/invented_report.hpp"

namespace plumb {
namespace {

const nlohmann::json& recorded() {
  static const auto kept = nlohmann::json::parse(reports::assets::foreign_codes_json);
  return kept;
}

TEST(ForeignCodes, RecordedOrdersAndVerdictsFollowFromTheRecordedErrors) {
  ASSERT_GE(recorded()["campaigns"].size(), 5u);
  for (const auto& campaign : recorded()["campaigns"]) {
    const std::string name = campaign["campaign"];
    const auto& fit = campaign["fits"][0];
    std::vector<Level> levels;
    for (const auto& level : campaign["levels"])
      levels.push_back({level["d"], level[level.contains("l2") ? "l2" : "relative_l2"]});
    const OrderFit again = fit_order(levels);
    EXPECT_NEAR(again.order, fit["order"].get<double>(), 1e-9) << name;  // round-off of a fit
    EXPECT_NEAR(again.lower, fit["ci95"][0].get<double>(), 1e-9) << name;
    EXPECT_NEAR(again.upper, fit["ci95"][1].get<double>(), 1e-9) << name;
    // 0.1: all that pass do so by less than 0.02, and an order of another kind is off by 0.5 or more
    EXPECT_EQ(fit["verdict"] == "pass", std::abs(again.order - fit["declared"].get<double>()) < 0.1) << name;
    EXPECT_EQ(campaign["status"] == "pass", fit["verdict"] == "pass") << name;
  }
}

class ForeignCodesSection : public test::InventedReport {};

TEST_F(ForeignCodesSection, SaysByWhichCommandAndWhenTheRecordedRowsWereMade) {
  const reports::Section& section = sections.at("foreign-codes");
  const std::string date = recorded()["measured"];
  const std::string& note = section.notes.at(0);
  EXPECT_NE(note.find("tests/foreign/run made them on " + date), std::string::npos) << note;
  for (const auto& program : recorded()["programs"])
    EXPECT_NE(note.find(program.get<std::string>()), std::string::npos) << note;
  for (const auto& code : recorded()["left_out"])
    EXPECT_NE(note.find(code.get<std::string>()), std::string::npos) << note;
  const auto& rows = section.tables.at(0).rows;
  ASSERT_EQ(rows.size(), 1 + recorded()["campaigns"].size());
  EXPECT_EQ(std::get<std::string>(rows[0][2]), "in this report");
  for (std::size_t k = 1; k < rows.size(); ++k)
    EXPECT_EQ(std::get<std::string>(rows[k][2]), "recorded " + date);
}

}  // namespace
}  // namespace plumb
