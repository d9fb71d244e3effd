#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "reports/assets.hpp"
#include "reports/results.hpp"
#include "reports/section.hpp"

namespace plumb::reports::sections {
namespace {

using Json = nlohmann::ordered_json;

const std::string live = "foreign-elements";

Series errors_of(const Json& campaign) {
  Series series{text(campaign, "campaign"), {}, {}};
  for (const Json& level : campaign.at("levels")) {
    if (!level.contains("relative_l2")) continue;
    series.x.push_back(number(level, "d"));
    series.y.push_back(number(level, "relative_l2"));
  }
  return series;
}

Figure picture_of(const std::vector<Json>& campaigns) {
  Picture picture{
      "Errors of other people's codes", {"spacing", "m", Scale::log}, {"relative L2 error", "", Scale::log}};
  picture.labels = Labels::legend;
  picture.height = 560;
  for (const Json& campaign : campaigns) picture.series.push_back(errors_of(campaign));
  return {"foreign-codes",
          picture,
          "Displacement against the manufactured solution. CalculiX and LAMMPS: as the table says.",
          {live}};
}

DataTable table_of(const std::vector<Json>& campaigns) {
  DataTable table{"foreign-codes-orders",
                  "Orders in L2",
                  {{"code"},
                   {"solution"},
                   {"declared", "", 2},
                   {"order", "", 4},
                   {"from", "", 4},
                   {"to", "", 4},
                   {"finest pair", "", 4},
                   {"verdict"}},
                  {},
                  {live}};
  for (const Json& campaign : campaigns)
    for (const Json& fit : campaign.at("fits"))
      table.rows.push_back({text(campaign, "campaign"), text(campaign, "solution"), number(fit, "declared"),
                            number(fit, "order"), fit.at("ci95").at(0).get<double>(),
                            fit.at("ci95").at(1).get<double>(), fit.at("pairwise").back().get<double>(),
                            text(fit, "verdict")});
  return table;
}

Section write(const Results& results) {
  const Json kept = Json::parse(assets::foreign_codes_json);
  std::vector<Json> campaigns{results.json(live)};
  for (const Json& campaign : kept.at("campaigns")) campaigns.push_back(campaign);
  const Json& fit = campaigns.front().at("fits").front();
  Section s;
  s.question = "Can a code that Plumbline did not write be verified with it?";
  std::size_t passed = 0;
  for (const Json& campaign : campaigns) passed += text(campaign, "status") == "pass" ? 1 : 0;
  s.answer = fmt::format(
      "{} programs were run by campaigns and judged, {} of them to the order that was declared; the others "
      "stand in the table with "
      "their verdicts.",
      campaigns.size(), passed);
  s.checks = {{"order of a finite-element code of 60 lines in Python, L2", "2",
               fmt::format("{:.3f} [{:.3f}, {:.3f}]", number(fit, "order"),
                           fit.at("ci95").at(0).get<double>(), fit.at("ci95").at(1).get<double>()),
               text(fit, "verdict"), live}};
  s.figures = {picture_of(campaigns)};
  s.tables = {table_of(campaigns)};
  s.notes = {"The first row is a campaign of this report. The others were run by tests/foreign/run " +
             text(kept, "measured") +
             ", which installs the programs; verification/campaigns holds all files."};
  return s;
}

}  // namespace

/// Programs of other people under campaigns.
SectionPlan foreign_codes(bool) {
  return {930,
          "foreign-codes",
          "Other people's codes",
          {{live,
            {"campaign", "verification/campaigns/finite_elements.toml", "--out", "{out}"},
            {"verification/campaigns/finite_elements.toml", "verification/campaigns/finite_elements.py",
             "verification/campaigns/finite_elements.json.in"}}},
          write};
}

}  // namespace plumb::reports::sections
