// plumb schema and plumb keys: what editors and people are told of files, beside the files.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "places.hpp"
#include "tests/support/program.hpp"
#include "tests/support/schema.hpp"
#include "tests/support/toml_json.hpp"

namespace plumb {
namespace {

using nlohmann::json;
using test::run_plumb;

const std::string verification = PLUMBLINE_SOURCE_DIR "/verification/";

const json& schema_document(const std::string& kind) {
  static std::map<std::string, json> all;
  if (!all.contains(kind)) all[kind] = json::parse(run_plumb("schema " + kind).out);
  return all[kind];
}

std::string complaints_about(const std::string& kind, const TomlValue& document) {
  std::string all;
  for (const auto& one : test::Schema(schema_document(kind)).complaints(test::json_of(document)))
    all += one + '\n';
  return all;
}

/// The section of a schema that a key stands in, and the key's own part; null if there is none.
json part_of(const std::string& kind, const std::string& path) {
  json at = schema_document(kind);
  std::istringstream parts(path);
  for (std::string part; std::getline(parts, part, '.');) {
    if (at.contains("anyOf"))  // one section, or several
      for (const json& one : json(at["anyOf"]))
        if (one.value("type", "") == (part == "0" ? "array" : "object")) at = one;
    if (part == "0") {
      at = at.contains("items") ? at["items"] : json();
    } else if (at.contains("properties") && at["properties"].contains(part)) {
      at = json(at["properties"][part]);
    } else {
      return at.contains("additionalProperties") && at["additionalProperties"].is_object()
                 ? json(at["additionalProperties"])
                 : json();
    }
  }
  return at;
}

int files_that_fit(const std::string& folder, const std::string& kind, const std::string& section) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(verification + folder)) {
    const std::string file = entry.path().string();
    if (entry.path().extension() != ".toml") continue;
    const TomlValue document = parse_document(read_text(file), file);
    if (!document.find(section)) continue;
    EXPECT_EQ(complaints_about(kind, document), "") << file;
    ++count;
  }
  return count;
}

TEST(KeySchema, EverySceneStudyAndPathFits) {
  EXPECT_GE(files_that_fit("scenes", "scene", "scene"), 46);
  EXPECT_GE(files_that_fit("comparison", "scene", "scene"), 3);
  EXPECT_GE(files_that_fit("studies", "study", "study"), 18);
  EXPECT_GE(files_that_fit("stability", "stability-study", "stability"), 9);
  EXPECT_GE(files_that_fit("material", "path", "path"), 4);
}

/// The bad inputs of the table that have a key too many, a word that is none, or a value of the wrong type do
/// not fit; the file that they change does.
TEST(KeySchema, BadInputsDoNotFit) {
  const TomlValue table = parse_document(read_text(verification + "bad_inputs.toml"), "bad_inputs.toml");
  const std::map<std::string, std::string> kinds{
      {"scene", "scene"}, {"bar", "scene"}, {"study", "study"}, {"path", "path"}};
  for (const auto& [base, kind] : kinds)
    EXPECT_EQ(complaints_about(kind, parse_document(table.find(base)->text, base)), "") << base;
  int unknown = 0;
  for (const TomlValue& bad : table.find("bad")->items) {
    const std::string message = bad.find("message") ? bad.find("message")->text : "",
                      base = bad.find("base") ? bad.find("base")->text : "scene";
    const bool caught = message.find("unknown key") != std::string::npos ||
                        message.find("unknown section") != std::string::npos ||
                        message.find("wrong type") != std::string::npos;
    if (!caught || (!bad.find("line") && !bad.find("set"))) continue;
    // a key of another law or shape is known to the schema, which does not know what goes together
    std::smatch key;
    const std::regex before(R"((\S+): unknown key)");
    if (std::regex_search(message, key, before) && !part_of(kinds.at(base), key[1].str()).is_null()) continue;
    std::string text = table.find(base)->text;
    if (bad.find("line"))
      text.replace(text.find(bad.find("line")->text), bad.find("line")->text.size(),
                   bad.find("instead") ? bad.find("instead")->text : "");
    const std::vector<std::string> set =
        bad.find("set") ? std::vector{bad.find("set")->text} : std::vector<std::string>{};
    EXPECT_NE(complaints_about(kinds.at(base), parse_document(text, base, set)), "") << message;
    ++unknown;
  }
  EXPECT_GE(unknown, 15);
}

/// Names that scripts and scenes of users have: none may get lost.
TEST(KeySchema, KeysThatUsersRelyOnAreThere) {
  const std::map<std::string, std::string> promised{
      {"scene",
       "scene.name scene.dimension scene.end_time scene.max_steps body.shape body.origin body.size "
       "body.spacing body.particles body.layout body.jitter body.seed body.file material.model "
       "material.young material.poisson material.density material.ratio material.share material.yield "
       "material.hardening material.saturation material.saturation_exponent material.plane "
       "material.hardening_exponent material.rate_factor material.reference_rate "
       "material.reference_temperature material.melting_temperature material.heat_capacity "
       "method.scheme method.paper method.kernel method.beta method.pair method.gradient "
       "method.momentum method.integrator method.cfl method.time_step method.wave_speed "
       "method.support jst.eta2 jst.eta4 jst.laplacian_factor jst.outer hourglass.alpha "
       "hourglass.weight initial.velocity initial.spin initial.displacement boundary.0.face "
       "boundary.0.where boundary.0.kind boundary.0.velocity boundary.0.displacement "
       "boundary.0.traction boundary.0.pressure load.gravity load.body_force damping.rate "
       "relaxation.residual output.every output.vtk output.series output.fields output.probe.0.name "
       "output.probe.0.at implicit.steps implicit.time_step implicit.adaptive implicit.tolerance "
       "implicit.solver implicit.dynamics mixed.volumes mixed.kinematics mixed.upwind mixed.option "
       "mixed.update_every mixed.smooth_positions mixed.list updated.form updated.penalty updated.xi "
       "updated.balance updated.rotation updated.geometry updated.dissipation updated.yield_ratio "
       "eulerian.force eulerian.hourglass eulerian.xi eulerian.zeta eulerian.chi eulerian.damping "
       "contact.0.between contact.0.stiffness contact.0.friction"},
      {"study",
       "study.name study.solution study.spacings study.time study.periods study.force "
       "study.quadrature study.parameters.amplitude expect.l2 expect.h1 expect.reason body.size "
       "material.young method.scheme jst.eta4"},
      {"stability-study",
       "stability.scene stability.parameter stability.from stability.to stability.over "
       "stability.values variant.0.name variant.0.set"},
      {"path", "material.model material.young path.gradient path.deformation path.duration"}};
  for (const auto& [kind, keys] : promised) {
    std::istringstream words(keys);
    for (std::string key; words >> key;) EXPECT_FALSE(part_of(kind, key).is_null()) << kind << ": " << key;
  }
}

/// What an editor shows: the meaning with its unit, the default, and the words.
TEST(KeySchema, SaysWhatAValueIs) {
  const json young = part_of("scene", "material.young");
  EXPECT_EQ(young["description"], "Young's modulus of the reference [Pa]");
  EXPECT_EQ(young["anyOf"][0], json({{"type", "number"}, {"exclusiveMinimum", 0}}));
  EXPECT_EQ(part_of("scene", "jst.eta4")["default"], 0.015625);
  EXPECT_EQ(part_of("scene", "boundary.0.kind")["enum"][0], "clamped");
  EXPECT_EQ(part_of("scene", "output.every")["description"],
            "time from one row and frame to the next; without it the first and the last state [s]");
  EXPECT_EQ(schema_document("scene")["required"], json({"scene", "body", "material"}));
  EXPECT_EQ(schema_document("scene")["additionalProperties"], false);
}

TEST(KeySchema, PageHasEveryKeyOfTheSchema) {
  const std::string page = run_plumb("keys scene").out;
  for (const char* line :
       {"## [body] or [[body]]", "## [[boundary]]", "## [[output.probe]]",
        "| `eta4` | a number, not negative | 0.015625 | fourth-order coefficient |",
        "| `young` | a stress in Pa, positive | required | Young's modulus of the reference |"})
    EXPECT_NE(page.find(line), std::string::npos) << line;
  const json rows = json::parse(run_plumb("keys scene --json -").out)["keys"];
  EXPECT_GT(rows.size(), 150u);
  for (const json& row : rows) {
    const std::string key = row["key"];
    const json part = part_of("scene", key);
    ASSERT_FALSE(part.is_null()) << key;
    const std::string meaning = row["meaning"], said = part.value("description", "");
    EXPECT_TRUE(said.starts_with(meaning)) << key;
    EXPECT_NE(page.find(meaning), std::string::npos) << key;
  }
}

TEST(KeySchema, KindsThatAreNoneAreRefused) {
  const auto outcome = run_plumb("schema scenes");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.error.find("Did you mean \"scene\"?"), std::string::npos) << outcome.error;
  EXPECT_EQ(json::parse(run_plumb("schema result").out),
            json::parse(read_text(verification + "schema/result.json")));
}

}  // namespace
}  // namespace plumb
