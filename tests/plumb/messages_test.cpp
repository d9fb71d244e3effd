// The words that a user sees: their form, hints at likely causes, help.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "lib/input/document.hpp"
#include "lib/input/section.hpp"
#include "places.hpp"
#include "tests/support/program.hpp"

namespace plumb {
namespace {

using test::run_plumb;

/// Sentences that end in a stop, and begin with a capital, a name in quotes or brackets, a number or an
/// option; the first one stands behind the program and the place, and begins as it likes.
std::string fault_of(const std::string& message) {
  if (!message.starts_with("plumb")) return "does not begin with the program";
  if (message.find_first_of("\n") != std::string::npos) return "has several lines";
  if (std::string(".?!").find(message.back()) == std::string::npos) return "does not end in a stop";
  if (std::regex_search(message, std::regex(R"([?!]\.|\s\.(\s|$))"))) return "has a stop too many";
  // the old form, "problem (why) suggestion": a parenthesis that is followed by a word and not by a stop
  if (std::regex_search(message, std::regex(R"(\((it|the|a|valid:|expected|there) [^()]*\))")))
    return "has its reason in parentheses";
  const std::regex start(R"([^.][.?!] ([a-z][a-z]+)[ ,.])");
  for (std::sregex_iterator match(message.begin(), message.end(), start), end; match != end; ++match)
    if ((*match)[1] != "plumb") return "begins a sentence with \"" + (*match)[1].str() + "\"";
  return "";
}

TEST(Messages, EveryRefusalOfTheTableHasTheForm) {
  const std::string table = PLUMBLINE_SOURCE_DIR "/verification/bad_inputs.toml";
  const TomlValue document = parse_document(read_text(table), table);
  std::size_t seen = 0;
  for (const auto& bad : document.find("bad")->items) {
    const std::string message = bad.find("message")->text;
    EXPECT_EQ(fault_of(message), "") << message;
    ++seen;
  }
  EXPECT_GE(seen, 150u);
}

TEST(Messages, TheFormIsSeenToBeBroken) {
  EXPECT_EQ(fault_of("plumb: a is b. It must be c. Give d."), "");
  for (const char* wrong : {"a. B.", "plumb: a", "plumb: a (it must be) give b", "plumb: a. It is. did you?",
                            "plumb: a. It is?.", "plumb: a. .", "plumb: a (it must be). Give b."})
    EXPECT_NE(fault_of(wrong), "") << wrong;
}

/// Help by the word, wherever the word of a subcommand may stand.
TEST(Help, TheWordHelpIsTheOption) {
  EXPECT_EQ(run_plumb("help").out, run_plumb("").out);
  EXPECT_EQ(run_plumb("help run").out, run_plumb("run --help").out);
  EXPECT_EQ(run_plumb("help oned").out, run_plumb("oned --help").out);
  for (const char* words : {"help oned study", "oned help study"})
    EXPECT_EQ(run_plumb(words).out, run_plumb("oned study --help").out) << words;
  EXPECT_EQ(run_plumb("oned help").out, run_plumb("oned --help").out);
  for (const char* words : {"help", "help run", "oned help", "", "new", "completion"})
    EXPECT_EQ(run_plumb(words).code, 0) << words;
  for (const char* words : {"help rnu", "oned help stdy", "help oned nothing"}) {
    const auto outcome = run_plumb(words);
    EXPECT_EQ(outcome.code, 2) << words;
    EXPECT_NE(outcome.error.find("unknown command"), std::string::npos) << outcome.error;
  }
}

/// "help" that is a value stays one.
TEST(Help, AFileOfThatNameIsNoQuestion) {
  const auto outcome = run_plumb("run help");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.error.find("help: cannot be read"), std::string::npos) << outcome.error;
}

nlohmann::json failure_of(const std::string& changes) {
  const test::TemporaryFolder folder;
  const auto outcome =
      run_plumb("run " PLUMBLINE_SOURCE_DIR
                "/verification/scenes/free_plate.toml --threads 1 --json - "
                "--set \"initial.velocity=['sin(9*X)', 'sin(7*Y)']\" --set scene.end_time=0.2 --out " +
                folder.path().string() + " " + changes);
  EXPECT_EQ(outcome.code, 1) << outcome.error;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["status"], "unstable");
  return json["failure"];
}

TEST(Unstable, NamesTheLikelyCauseWhereItIsKnown) {
  const std::string verlet = failure_of("--set method.cfl=3")["likely_cause"];
  EXPECT_NE(verlet.find("the time step is 3 of the time that a pressure wave needs"), std::string::npos)
      << verlet;
  EXPECT_NE(verlet.find("verlet bears about 1.1; use cfl = 0.5"), std::string::npos) << verlet;
  const std::string rk3 = failure_of("--set method.cfl=3 --set method.integrator=rk3")["likely_cause"];
  EXPECT_NE(rk3.find("rk3 bears about 0.96"), std::string::npos) << rk3;
}

}  // namespace
}  // namespace plumb
