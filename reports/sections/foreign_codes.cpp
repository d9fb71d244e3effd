#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "reports/assets.hpp"
#include "reports/results.hpp"
#include "reports/section.hpp"

namespace plumb::reports::sections::foreign_codes {
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
  Picture picture{"Errors of other people's codes",
                  {"spacing", "m", Scale::log},
                  {"relative error in L₂", "", Scale::log}};
  picture.labels = Labels::legend;
  picture.height = 560;
  for (const Json& campaign : campaigns) picture.series.push_back(errors_of(campaign));
  return {
      "foreign-codes",
      picture,
      "Displacement against the manufactured solution. The first code ran for this report, the others are "
      "recorded.",
      {live}};
}

void append_rows(DataTable& table, const Json& campaign, const std::string& measured) {
  for (const Json& fit : campaign.at("fits"))
    table.rows.push_back({text(campaign, "campaign"), text(campaign, "solution"), measured,
                          number(fit, "declared"), number(fit, "order"), fit.at("ci95").at(0).get<double>(),
                          fit.at("ci95").at(1).get<double>(), fit.at("pairwise").back().get<double>(),
                          text(fit, "verdict")});
}

DataTable table_of(const std::vector<Json>& campaigns, const std::string& measured) {
  DataTable table{"foreign-codes-orders",
                  "Orders in L₂",
                  {{"code"},
                   {"solution"},
                   {"measured"},
                   {"declared", "", 2},
                   {"order", "", 4},
                   {"from", "", 4},
                   {"to", "", 4},
                   {"finest pair of levels", "", 4},
                   {"verdict"}},
                  {},
                  {live}};
  for (const Json& campaign : campaigns)
    append_rows(table, campaign, &campaign == &campaigns.front() ? "in this report" : measured);
  return table;
}

/// "a, b and c" of a list of words.
std::string listed(const Json& words) {
  std::string all;
  for (std::size_t k = 0; k < words.size(); ++k)
    all += (k == 0 ? "" : k + 1 == words.size() ? " and " : ", ") + words.at(k).get<std::string>();
  return all;
}

/// By which command, when and with what programs the recorded rows were made.
std::string origin_of(const Json& kept) {
  std::string note = fmt::format(
      "The other rows are recorded: {} made them on {} with {} and wrote them to "
      "reports/assets/foreign_codes.json. This report did not run them.",
      text(kept, "command"), text(kept, "measured"), listed(kept.at("programs")));
  if (!kept.at("left_out").empty())
    note += fmt::format(" Left out there, because the program was not installed: {}.",
                        listed(kept.at("left_out")));
  return note;
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
      "Campaigns ran {} codes and judged them, one for this report and {} recorded before: {} have the order "
      "that was declared for them{}",
      campaigns.size(), campaigns.size() - 1, passed,
      passed == campaigns.size() ? "." : "; the others stand in the table with their verdicts.");
  s.checks = {{"order in L₂ of a finite-element code of 60 lines in Python", "2",
               fmt::format("{:.2f}, 95 % interval [{:.2f}, {:.2f}]", number(fit, "order"),
                           fit.at("ci95").at(0).get<double>(), fit.at("ci95").at(1).get<double>()),
               text(fit, "verdict"), live}};
  s.figures = {picture_of(campaigns)};
  s.tables = {table_of(campaigns, "recorded " + text(kept, "measured"))};
  s.notes = {origin_of(kept),
             "verification/campaigns holds the files of all of them, and how to do the same with a code of "
             "your own."};
  return s;
}

}  // namespace

/// Programs of other people under campaigns.
SectionPlan planned(Extent) {
  return {930,
          "foreign-codes",
          "Other people's codes",
          {{live,
            {"campaign", "verification/campaigns/finite_elements.toml", "--out", "{out}"},
            {"verification/campaigns/finite_elements.toml", "verification/campaigns/finite_elements.py",
             "verification/campaigns/finite_elements.json.in"}}},
          write};
}

}  // namespace plumb::reports::sections::foreign_codes
