#include "verification/plumb/oned_account.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>

#include "lib/convergence/status.hpp"
#include "oned/account.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

int account(const Session& session) {
  Json sentences = Json::array();
  bool all_measured = true;  // whether a sentence holds is a finding; a number that is none decides nothing
  for (const auto& sentence : oned::account()) {
    Json measured = Json::object();
    for (const auto& [name, value] : sentence.measured) {
      measured[name] = value;
      all_measured = all_measured && std::isfinite(value);
    }
    session.text() << fmt::format("{}: {}\n  {}. {}\n", sentence.where, sentence.claim,
                                  name_of(sentence.holds), sentence.finding);
    for (const auto& [name, value] : sentence.measured)
      session.text() << fmt::format("    {} = {:.6g}\n", name, value);
    sentences.push_back({{"where", sentence.where},
                         {"claim", sentence.claim},
                         {"holds", name_of(sentence.holds)},
                         {"finding", sentence.finding},
                         {"measured", measured}});
  }
  const std::string status = all_measured ? "pass" : "inconclusive";
  session.text() << "status: " << status << '\n';
  session.write_json({{"sentences", sentences}, {"status", status}});
  return exit_code_of(status);
}

}  // namespace

void add_account(CLI::App& group, Session& session) {
  add_command(group, session,
              {"account", "which sentences of paper 000 on the 1D study hold, with the numbers that decide",
               "plumb oned account"},
              {}, [&session] { return account(session); });
}

}  // namespace plumb::app
