#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "reports/checks.hpp"
#include "reports/results.hpp"
#include "reports/section.hpp"

namespace plumb::reports::sections::bad_input {
namespace {

Section write(const Results& results) {
  const auto result = results.json("refusals");
  const double count = number(result, "count"), wrong = number(result, "wrong");
  Section s;
  s.question = "What does the program say to input that cannot be used?";
  s.answer = fmt::format(
      "{:.0f} bad inputs were tried; {:.0f} of them got another message than the one written down.", count,
      wrong);
  s.checks = {as(CheckKind::regression, {"bad inputs refused with the message that is written down",
                                         fmt::format("all {:.0f}", count),
                                         fmt::format("{:.0f}", count - wrong), pass_if(wrong == 0)}),
              as(CheckKind::book_keeping,
                 bound_check("CPU time until the slowest one is refused [s]", number(result, "slowest_s"), 1,
                             "nobody waits longer to be told")),
              as(CheckKind::book_keeping,
                 {"bad inputs tried", "at least 80", fmt::format("{:.0f}", count), pass_if(count >= 80)})};
  DataTable table{
      "bad-input", "Bad inputs and what a user is told", {{"input"}, {"message"}}, {}, {"refusals"}, {}};
  for (const auto& row : result.at("rows")) table.rows.push_back({text(row, "what"), text(row, "message")});
  s.tables = {std::move(table)};
  s.notes = {
      "Each is one change to a good scene or study, or a command line. A command line that ends with "
      "another exit code than 2 counts as another message."};
  return s;
}

}  // namespace

/// Bad input and its messages.
SectionPlan planned(Extent) {
  const std::string table = "verification/bad_inputs.toml";
  return {1010, "bad-input", "Bad input", {{"refusals", {"refusals", table}, {table}}}, write};
}

}  // namespace plumb::reports::sections::bad_input
