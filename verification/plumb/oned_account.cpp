#include "plumb/oned_account.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <ostream>

#include "oned/account.hpp"
#include "plumb/session.hpp"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

int account(const Session& session) {
  Json sentences = Json::array();
  for (const auto& sentence : oned::account()) {
    Json measured = Json::object();
    for (const auto& [name, value] : sentence.measured) measured[name] = value;
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
  session.write_json({{"sentences", sentences}});
  return 0;
}

}  // namespace

void add_account(CLI::App& group, Session& session) {
  add_command(group, session,
              {"account", "which sentences of paper 000 on the 1D study hold, with the numbers that decide",
               "plumb oned account"},
              {}, [&session] { return account(session); });
}

}  // namespace plumb
