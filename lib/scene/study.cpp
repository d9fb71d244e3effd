#include "lib/scene/study.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "lib/scene/readers.hpp"
#include "lib/scene/unused_keys.hpp"

namespace plumb {
namespace {

void read_times(const Section& head, Study& study) {
  study.time = head.optional_number("time", quantity::time, Sign::positive);
  study.periods = head.optional_number("periods", quantity::number, Sign::positive);
  if (study.time && study.periods)
    head.fail("periods", "contradicts time", "the end is given by one of them", "leave one of them out");
  if (!study.time && !study.periods)
    head.fail("time", "missing key", "neither time nor periods says when to stop", "add periods = 1.125");
}

void check_spacings(const Section& head, const Study& study) {
  for (std::size_t i = 0; i < study.spacings.size(); ++i) {
    if (i > 0 && study.spacings[i] >= study.spacings[i - 1])
      head.fail("spacings", fmt::format("{} follows {}", study.spacings[i], study.spacings[i - 1]),
                "they must go from coarse to fine, each once");
    try {
      with_spacing(study.body, study.spacings[i]);
    } catch (const InputError& error) {
      head.fail("spacings", error.problem(), error.why(), error.suggestion());
    }
  }
}

std::map<std::string, double> read_parameters(const Section& head) {
  std::map<std::string, double> parameters;
  const auto section = head.optional_section("parameters");
  if (!section) return parameters;
  for (const auto& key : section->all_keys()) parameters[key] = section->any_number(key);
  return parameters;
}

std::optional<Expect> read_expect(const Section& root) {
  const auto section = root.optional_section("expect");
  if (!section) return std::nullopt;
  Expect expect;
  expect.l2 = section->optional_number("l2", quantity::number);
  expect.h1 = section->optional_number("h1", quantity::number);
  expect.velocity_l2 = section->optional_number("velocity_l2", quantity::number);
  expect.stress_l2 = section->optional_number("stress_l2", quantity::number);
  expect.reason = section->text("reason");
  section->reject_unknown();
  if (!expect.l2 && !expect.h1 && !expect.velocity_l2 && !expect.stress_l2)
    section->fail("l2", "missing key", "neither l2 nor h1, velocity_l2 or stress_l2 declares an order",
                  "leave out [expect] to report only");
  return expect;
}

}  // namespace

Study parse_study(const std::string& text, const std::string& file_name,
                  const std::vector<std::string>& overrides, const std::vector<std::string>& solutions,
                  StudyOf use) {
  const TomlValue document = parse_document(text, file_name, overrides, scene_alternatives());
  const Section root(document, "");
  for (const char* name : {"study", "expect", "body", "material"}) root.has(name);
  for (const auto& name : method_sections()) root.has(name);
  if (!root.has("study") && root.has("scene"))
    root.fail("scene", "this file is a scene", "a study has [study]", "plumb run is for scenes");
  root.reject_unknown();
  Study study;
  const Section head = root.section("study");
  study.name = head.text_or("name", std::filesystem::path(file_name).stem().string());
  study.solution = head.text("solution");
  if (!solutions.empty()) head.choice_or("solution", study.solution, solutions);
  study.spacings = head.numbers("spacings", 0, quantity::length, Sign::positive);
  read_times(head, study);
  study.force = head.choice_or("force", study.force, {"none", "finite-strain"});
  study.quadrature = head.choice_or("quadrature", study.quadrature, {"gauss", "nodal", "both"});
  study.held_band = head.optional_number("held_band", quantity::length, Sign::not_negative);
  study.parameters = read_parameters(head);
  head.reject_unknown();
  study.expect = read_expect(root);
  study.body = read_body(root.section("body"), 0, false);
  study.material = read_material(root.section("material"), study.dimension());
  study.method = read_method(root, study.body);
  refuse_history(root, study.material, study.method);
  refuse_on_a_line(root, study.dimension(), study.method);
  refuse_beside_mirror(root, study.body.layout, study.method);
  check_spacings(head, study);
  study.unused = refuse_unused(root, keys_unused_by(use));
  if (use == StudyOf::time && study.spacings.size() > 1)
    head.fail("spacings", fmt::format("{} spacings for a refinement of the time step", study.spacings.size()),
              "all steps are taken on one cloud",
              fmt::format("write spacings = [{}]", study.spacings.front()));
  return study;
}

Study read_study(const std::string& path, const std::vector<std::string>& overrides,
                 const std::vector<std::string>& solutions, StudyOf use) {
  return parse_study(read_text(path), path, overrides, solutions, use);
}

}  // namespace plumb
