#include <fmt/format.h>

#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "reports/checks.hpp"
#include "reports/results.hpp"
#include "reports/section.hpp"

namespace plumb::reports::sections {
namespace {

using Json = nlohmann::ordered_json;

const std::string score_file = "verification/faults/score.json";

Section write(const Results& results) {
  const Json score = results.json("faults");
  const Json& faults = score.at("faults");
  std::string first, last;
  for (const auto& fault : faults) {
    const std::string date = fault.value("date", "");
    if (first.empty() || date < first) first = date;
    if (date > last) last = date;
  }
  Section s;
  s.question = "Would the tests have noticed if the code were wrong?";
  s.answer =
      fmt::format("{} of {} planted faults turned a test red, {} are explained as equivalent, {} survived.",
                  score.at("caught").get<int>(), faults.size(), score.at("equivalent").get<int>(),
                  score.at("survived").get<int>());
  s.checks.push_back(as(CheckKind::book_keeping, {"planted faults that no test sees", "0",
                                                  fmt::format("{}", score.at("survived").get<int>()),
                                                  pass_if(score.at("survived") == 0)}));
  DataTable table{"planted-faults",
                  "Faults and what caught them",
                  {{"fault"}, {"file"}, {"caught by"}, {"at commit"}},
                  {},
                  {"faults"}};
  std::map<std::string, int> by_program;
  for (const auto& fault : faults) {
    const bool seen = fault.at("caught_by").is_string();
    const std::string by = seen                           ? text(fault, "caught_by")
                           : fault.contains("equivalent") ? text(fault, "equivalent")
                                                          : "survived";
    table.rows.push_back({text(fault, "name"), text(fault, "file"), by, fault.value("commit", "")});
    if (seen) ++by_program[by.substr(0, by.find(':'))];
  }
  s.headlines = {{fmt::format("{} of {}", score.at("caught").get<int>(), faults.size()),
                  "planted faults turned a test red"}};
  DataTable programs{"planted-faults-by",
                     "Test programs that caught them first",
                     {{"program"}, {"faults", "", 0}},
                     {},
                     {"faults"}};
  for (const auto& entry : by_program)
    programs.rows.push_back({entry.first, static_cast<double>(entry.second)});
  s.tables = {programs, table};
  s.notes = {
      "Each fault is compiled into a copy of the library that is never installed; the test programs run "
      "until one fails. "
      "verification/faults/run repeats it; the table shows its stored score, made from " +
          first + " to " + last + " at the commits named, not by this report.",
      "The program named is the first that was tried and failed, not the only one that would."};
  return s;
}

}  // namespace

/// Faults planted into the code, and the tests that caught them.
SectionPlan planted_faults(bool) {
  return {820, "faults", "Planted faults", {{"faults", {"faults", score_file}, {score_file}}}, write};
}

}  // namespace plumb::reports::sections
