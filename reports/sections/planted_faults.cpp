#include <fmt/format.h>

#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "reports/checks.hpp"
#include "reports/results.hpp"
#include "reports/section.hpp"

namespace plumb::reports::sections::planted_faults {
namespace {

using Json = nlohmann::ordered_json;

const std::string score_file = "verification/faults/score.json";

const std::string sample_file = "verification/faults/sampled.json";

/// Shares of a random sample by folder, all of it first.
DataTable sample_table(const Json& sample) {
  DataTable table{"sampled-faults",
                  "A random sample of small slips: how many of them a test sees",
                  {{"folder"},
                   {"caught", "", 0},
                   {"not seen", "", 0},
                   {"share", "%", 1},
                   {"from", "%", 1},
                   {"to", "%", 1}},
                  {},
                  {"faults"}};
  const auto add = [&](const std::string& name, const Json& row) {
    if (row.at("share").is_null()) return;
    table.rows.push_back({name, row.at("killed").get<double>(), row.at("alive").get<double>(),
                          100 * row.at("share").get<double>(), 100 * row.at("interval").at(0).get<double>(),
                          100 * row.at("interval").at(1).get<double>()});
  };
  add("in all", sample.at("all"));
  for (const auto& row : sample.at("folders")) add(text(row, "folder"), row);
  return table;
}

std::string sample_answer(const Json& sample) {
  const Json& all = sample.at("all");
  const auto percent = [](const Json& share) { return 100 * share.get<double>(); };
  return fmt::format(
      " Of slips drawn at random from the sources, {} of {} are seen: "
      "{:.0f} %, 95 % interval {:.0f} to {:.0f} %; before tests were written "
      "for those of this very sample it was {:.0f} %, {:.0f} to {:.0f} %.",
      all.at("killed").get<int>(), all.at("killed").get<int>() + all.at("alive").get<int>(),
      percent(all.at("share")), percent(all.at("interval").at(0)), percent(all.at("interval").at(1)),
      percent(all.at("share_at_first")), percent(all.at("interval_at_first").at(0)),
      percent(all.at("interval_at_first").at(1)));
}

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
  const Json& sample = score.at("sampled");
  if (!sample.is_null() && !sample.at("all").at("share").is_null()) {
    s.answer += sample_answer(sample);
    s.tables.push_back(sample_table(sample));
    s.notes.push_back(fmt::format(
        "The random sample (verification/faults/sample, seed {}, commit {}): {} drawn, {} "
        "do not compile, {} are explained as equivalent and count in neither column. Intervals "
        "are Wilson's, 95 %. The first share is a measurement; that after tests were written "
        "for what the sample had shown says nothing about slips that were not drawn.",
        sample.at("seed").get<long>(), text(sample, "commit"), sample.at("all").at("sampled").get<int>(),
        sample.at("all").at("not_compiled").get<int>(), sample.at("all").at("equivalent").get<int>()));
  }
  s.tables.push_back(programs);
  s.tables.push_back(table);
  s.notes.insert(
      s.notes.begin(),
      {"Each fault is compiled into a copy of the library that is never installed; the test programs run "
       "until one fails. "
       "verification/faults/run repeats it; the table shows its stored score, made from " +
           first + " to " + last + " at the commits named, not by this report.",
       "The program named is the first that was tried and failed, not the only one that would."});
  return s;
}

}  // namespace

/// Faults planted into the code, and the tests that caught them.
SectionPlan planned(Extent) {
  return {820,
          "faults",
          "Planted faults",
          {{"faults", {"faults", score_file, "--sampled", sample_file}, {score_file, sample_file}}},
          write};
}

}  // namespace plumb::reports::sections::planted_faults
