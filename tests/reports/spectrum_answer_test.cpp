// The answer of the section on spectra: of a scheme it names the radii at which no body of any layout has a
// mode of nearly no energy that is not rigid. A body that was refused, or whose modes were not found, is not
// free of them.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/reports/invented_report.hpp"

namespace {

using namespace plumb::reports;
using Json = nlohmann::ordered_json;

class SpectrumAnswer : public plumb::test::InventedReport {
 protected:
  /// Writes the number of such modes into every row of that gradient: none at all but at the radii named.
  void set(const std::string& job, const std::string& gradient, const std::map<std::string, Json>& at_beta) {
    const auto file = folder / job / "result.json";
    Json result = Json::parse(plumb::test::content_of(file));
    int changed = 0;
    for (auto& row : result["rows"]) {
      if (row["method.gradient"] != gradient) continue;
      const auto found = at_beta.find(row["method.beta"].get<std::string>());
      // where there is one, only one layout has it
      const bool here = found != at_beta.end() && row["body.jitter"] == "0.2";
      row["near_zero_not_rigid"] = here ? found->second : Json(0);
      ++changed;
    }
    EXPECT_GT(changed, 10);
    std::ofstream(file) << result.dump();
  }
  std::string answer() const {
    for (const auto& plan : section_plans(Extent::full))
      if (plan.id == "spectrum") return plan.write(invention.results).answer;
    return "no section";
  }
};

TEST_F(SpectrumAnswer, NamesTheRadiiWithoutSuchModes) {
  set("plate-soft", "compatible", {});
  set("plate-soft", "improved", {{"0.6", 1}, {"1.2", 3}, {"1.35", nullptr}, {"1.5", 12}});
  set("plate-soft", "standard",
      {{"0.6", 1}, {"0.75", 1}, {"0.9", 2}, {"1.05", 1}, {"1.2", 1}, {"1.35", 1}, {"1.5", 1}});
  set("cube-soft", "compatible", {{"1.5", 2}});
  set("cube-soft", "improved",
      {{"0.6", 4}, {"0.75", 1}, {"0.9", nullptr}, {"1.05", 1}, {"1.2", 1}, {"1.35", 1}});
  set("cube-soft", "standard", {});
  const std::string said = answer(), all = "at beta = 0.6, 0.75, 0.9, 1.05, 1.2, 1.35, 1.5";
  for (const std::string& part :
       {"compatible bonds " + all + " in 2D and at beta = 0.6, 0.75, 0.9, 1.05, 1.2, 1.35 in 3D",
        std::string("the improved gradient at beta = 0.75, 0.9, 1.05 in 2D and at beta = 1.5 in 3D"),
        "the standard one at no beta in 2D and " + all + " in 3D"})
    EXPECT_NE(said.find(part), std::string::npos) << part << "\nin: " << said;
}

}  // namespace
