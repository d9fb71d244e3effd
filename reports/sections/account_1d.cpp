#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "reports/checks.hpp"
#include "reports/page/page.hpp"
#include "reports/results.hpp"
#include "reports/section.hpp"

namespace plumb::reports::sections::account_1d {
namespace {

/// "name = value; .." of all numbers that decide a sentence.
std::string numbers(const nlohmann::ordered_json& measured) {
  std::string out;
  for (const auto& [name, value] : measured.items())
    out += fmt::format("{}{} = {}", out.empty() ? "" : "; ", name,
                       value.is_number() ? number_text(value.get<double>(), 4) : "not finite");
  return out;
}

Section write(const Results& results) {
  DataTable table{"account-sentences",
                  "Sentences of sections 2.2 and 4.1",
                  {{"where"}, {"the paper says"}, {"here it"}, {"why"}, {"numbers that decide"}},
                  {},
                  {"account"}};
  std::size_t hold = 0, fail = 0;
  const auto result = results.json("account");
  for (const auto& sentence : result.at("sentences")) {
    const std::string holds = text(sentence, "holds");
    hold += holds == "holds" ? 1 : 0;
    fail += holds == "does not hold" ? 1 : 0;
    table.rows.push_back({text(sentence, "where"), text(sentence, "claim"), holds, text(sentence, "finding"),
                          numbers(sentence.at("measured"))});
  }
  if (table.rows.empty()) throw MissingResult("the account has no sentences");
  Section s;
  s.question = "Which sentences of the paper about the one-dimensional study hold?";
  s.answer = fmt::format(
      "Of {} sentences {} hold, {} hold under a condition that the paper does not state, and {} do not hold.",
      table.rows.size(), hold, table.rows.size() - hold - fail, fail);
  s.tables = {table};
  return s;
}

}  // namespace

/// The account of the sentences of sections 2.2 and 4.1 of paper 000.
SectionPlan planned(Extent) {
  return {
      150, "account", "What the paper says about one dimension", {{"account", {"oned", "account"}}}, write};
}

}  // namespace plumb::reports::sections::account_1d
