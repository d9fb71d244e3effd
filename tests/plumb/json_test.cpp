// Everything that --json writes has one shape: verification/schema/result.json.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "places.hpp"
#include "tests/support/commands.hpp"
#include "tests/support/schema.hpp"

namespace plumb {
namespace {

using nlohmann::json;
using test::run_plumb;

const std::string tree = PLUMBLINE_SOURCE_DIR "/verification/";

const test::Schema& schema() {
  static const test::Schema read(json::parse(test::content_of(tree + "schema/result.json")));
  return read;
}

/// Empty if the text is a document of the shape, else what is wrong with it.
std::string complaints(const std::string& text) {
  const json document = json::parse(text, nullptr, false);
  if (document.is_discarded()) return "no JSON: " + text.substr(0, 200);
  std::string all;
  for (const auto& one : schema().complaints(document)) all += one + '\n';
  return all;
}

/// Small calls of every subcommand in each of its modes; "{}" is a folder of their own.
const std::vector<std::string> calls{
    "run @scenes/free_plate.toml --set scene.max_steps=2 --out {}/out",
    "explain @scenes/free_plate.toml",
    "mms @studies/swinging_plate.toml --set study.spacings=[0.5,0.4] --set study.periods=0.1",
    "mms --list",
    "mms --check swinging-plate --points 10",
    "mms @studies/time_step_plate.toml --temporal --set study.periods=0.02 --set "
    "study.spacings=[0.5]",
    "mms @studies/swinging_plate.toml --work-precision --repeats 1 --set study.spacings=[0.5,0.4] --set "
    "study.periods=0.1",
    "static @studies/static_plate.toml --set study.spacings=[0.5,0.4]",
    "operators @studies/operators.toml --set study.spacings=[0.1,0.05]",
    "oned kernels --at 0",
    "oned correction --points 5",
    "oned function --n 8",
    "oned gradient",
    "oned study --n 20,40",
    "oned response",
    "oned account",
    "spectrum @scenes/free_plate.toml",
    "spectrum @scenes/free_plate.toml --over method.beta=0.9,1.2",
    "spectrum @scenes/free_plate.toml --symbol 4",
    "stability {}/map.toml --cache ''",
    "extrapolate --spacings 0.4,0.2,0.1 --values 1.16,1.04,1.01",
    "extrapolate --spacings 0.4,0.2,0.1 --values 1.16,1.04,1.01 --reference 0.001,1.0",
    "judge {}/errors.csv --expect 2",
    "judge {}/errors.csv --limit unknown",
    "judge --particles @campaigns/first.csv --solution standing-wave --dimension 2 --time 0",
    "campaign @campaigns/finite_elements.toml --out {}/campaign",
    "compare @campaigns/first.csv @campaigns/second.csv",
    "verdicts",
    "material @material/sheet.toml",
    "bench --case adjoint-verlet-2d --n 1000 --repeats 1 --seconds 0.001",
    "bench --kernels --n 1000 --seconds 0.001",
    "claims",
    "faults",
    "refusals {}/bad.toml",
    "list",
    "new bar {}/bar",
    "new scene {}/first",
    "new study {}/order",
    "report --only kernels --out {}/report",
    "schema study",
    "schema result",
    "keys path",
    "manual",
    "completion bash",
    "completion zsh"};

class JsonShape : public testing::TestWithParam<std::string> {};

TEST_P(JsonShape, IsTheOneOfTheSchema) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "errors.csv") << "0.1,1e-2\n0.05,2.5e-3\n0.025,6.25e-4\n0.0125,1.5625e-4\n";
  std::ofstream(folder / "map.toml") << "[stability]\nscene = \"" + tree + "scenes/free_plate.toml\"\n" +
                                            R"toml(
set = ["scene.end_time=1 ms"]
parameter = "cfl"
from = 0.2
to = 0.3
over = "method.beta"
values = [0.9]
[[variant]]
name = "improved"
)toml";
  std::ofstream(folder / "bad.toml") << R"toml(
scene = "none"
study = "none"
[[bad]]
what = "no command"
call = "frobnicate"
message = "plumb: unknown command \"frobnicate\"<any>"
)toml";
  std::string call = GetParam();
  for (auto at = call.find("{}"); at != std::string::npos; at = call.find("{}"))
    call.replace(at, 2, folder.path().string());
  for (auto at = call.find('@'); at != std::string::npos; at = call.find('@')) call.replace(at, 1, tree);
  const auto outcome = run_plumb(call + " --quiet --threads 1 --json -");
  EXPECT_EQ(complaints(outcome.out), "") << call << '\n' << outcome.error;
  const json document = json::parse(outcome.out);
  EXPECT_EQ(document["exit_code"], outcome.code);
  EXPECT_NE(document["kind"], "error") << outcome.error;
  EXPECT_TRUE(GetParam().starts_with(document["kind"].get<std::string>())) << document["kind"];
  EXPECT_EQ(
      document["status"] == "completed" || document["status"] == "pass" || document["status"] == "undeclared",
      outcome.code == 0)
      << document["status"];
}

INSTANTIATE_TEST_SUITE_P(All, JsonShape, testing::ValuesIn(calls));

/// A subcommand without a call above would go unseen.
TEST(Json, EverySubcommandIsHeldAgainstTheSchema) {
  const json read = json::parse(test::content_of(tree + "schema/result.json"));
  const auto& kinds = read["properties"]["kind"]["enum"];
  for (const auto& command : test::commands()) {
    if (run_plumb(command + " --help").out.find("--json") == std::string::npos) continue;  // a group
    EXPECT_NE(std::find(kinds.begin(), kinds.end(), command), kinds.end())
        << command << " is not in the schema";
    EXPECT_TRUE(std::any_of(calls.begin(), calls.end(),
                            [&](const std::string& call) { return call.starts_with(command); }))
        << command << " has no call";
  }
}

/// What is said on standard error stands in the JSON too, with the place apart.
TEST(Json, ErrorsAreDocumentsWithTheirPlace) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "scene.toml") << "[scene]\nname = \"a\"\ndimension = 5\n";
  const auto outcome = run_plumb("run " + (folder / "scene.toml").string() + " --json -");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(complaints(outcome.out), "");
  const json error = json::parse(outcome.out);
  EXPECT_EQ(error["kind"], "error");
  EXPECT_EQ(error["status"], "error");
  EXPECT_EQ(error["exit_code"], 2);
  EXPECT_EQ(error["file"], (folder / "scene.toml").string());
  EXPECT_EQ(error["line"], 3);
  EXPECT_EQ(error["key"], "scene.dimension");
  for (const char* part : {"problem", "why"}) {
    if (error[part].is_null()) continue;
    // as a sentence it begins with a capital
    EXPECT_NE(outcome.error.find(error[part].get<std::string>().substr(1)), std::string::npos) << error[part];
  }
  EXPECT_EQ(error["problem"].get<std::string>().find("scene.toml"), std::string::npos) << error["problem"];
}

TEST(Json, CommandLinesThatCannotBeReadAreErrorsToo) {
  for (const char* call : {"lst --json -", "oned study --n --json=-", "list --jsno x --json -"}) {
    const auto outcome = run_plumb(call);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(complaints(outcome.out), "") << call;
    const json error = json::parse(outcome.out, nullptr, false);
    ASSERT_FALSE(error.is_discarded()) << call;
    EXPECT_EQ(error["kind"], "error");
    EXPECT_TRUE(error["file"].is_null() && error["line"].is_null() && error["key"].is_null());
  }
}

TEST(Json, ErrorsGoToTheFileThatWasNamed) {
  const test::TemporaryFolder folder;
  const auto outcome = run_plumb("run nowhere.toml --json " + (folder / "result.json").string());
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.out, "");
  const std::string text = test::content_of(folder / "result.json");
  EXPECT_EQ(complaints(text), "");
  EXPECT_EQ(json::parse(text)["file"], "nowhere.toml");
}

TEST(Json, TheSummaryInTheFolderOfARunHasTheSameShape) {
  const test::TemporaryFolder folder;
  const auto outcome =
      run_plumb("run " + tree + "scenes/free_plate.toml --set scene.max_steps=2 --quiet --out " +
                folder.path().string());
  ASSERT_EQ(outcome.code, 0) << outcome.error;
  const std::string text = test::content_of(folder / "summary.json");
  EXPECT_EQ(complaints(text), "");
  EXPECT_EQ(json::parse(text)["kind"], "run");
}

/// The names of the columns of a map.
TEST(Json, AMapSaysWhatXYAndLimitAre) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "map.toml")
      << "[stability]\nscene = \"" + tree + "scenes/free_plate.toml\"\n" +
             "set = [\"scene.end_time=1 ms\"]\nparameter = \"cfl\"\nfrom = 0.2\nto = "
             "0.3\nover = \"method.beta\"\nvalues = [0.9]\n[[variant]]\nname = "
             "\"improved\"\n";
  const auto map =
      json::parse(run_plumb("stability " + (folder / "map.toml").string() + " --cache '' --json -").out);
  EXPECT_EQ(map["x_name"], "method.beta");
  EXPECT_EQ(map["y_name"], "least unstable cfl");
  EXPECT_EQ(map["limit_name"], "largest stable cfl");
}

/// The schema refuses what it should.
TEST(Json, TheSchemaSeesAKeyThatIsExchanged) {
  json document = json::parse(run_plumb("oned response --json -").out);
  ASSERT_EQ(complaints(document.dump()), "");
  json without = document;
  without["rows"][0].erase("theta");
  EXPECT_NE(complaints(without.dump()), "");
  json other = document;
  other["kind"] = "oned gradient";
  EXPECT_NE(complaints(other.dump()), "");
  other = document;
  other["exit_code"] = 7;
  EXPECT_NE(complaints(other.dump()), "");
}

}  // namespace
}  // namespace plumb
