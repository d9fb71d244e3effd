#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "lib/convergence/norm_units.hpp"
#include "lib/convergence/words.hpp"
#include "verification/plumb/commands.hpp"
#include "verification/plumb/session.hpp"
#include "verification/plumb/usage.hpp"

namespace plumb::app {
namespace {

int verdicts(const Session& session) {
  auto rows = nlohmann::ordered_json::array();
  for (const VerdictWord& one : verdict_words) {
    rows.push_back({{"word", one.word}, {"meaning", one.meaning}});
    session.text() << fmt::format("{}\n    {}\n", one.word, one.meaning);
  }
  session.text() << "\nNorms\n    " << norms_explained << "\n\nExit codes of commands that judge\n";
  session.text() << "    0  everything that was declared passes, or nothing was declared\n"
                    "    1  anything else: the status says what\n"
                    "    2  bad input, a value that is not a number among it: nothing was judged\n";
  session.write_json({{"rows", rows}, {"norms", norms_explained}});
  return 0;
}

}  // namespace

/// `plumb verdicts`: what every word about an order means.
void add_verdicts(CLI::App& program, Session& session) {
  add_command(
      program, session,
      {"verdicts", "what pass, above, not-asymptotic .. mean, and the norms of errors", "plumb verdicts"}, {},
      [&session] { return verdicts(session); });
}

}  // namespace plumb::app
