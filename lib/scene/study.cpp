#include "lib/scene/study.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "lib/scene/readers.hpp"
#include "lib/scene/unused_keys.hpp"

namespace plumb {
namespace {

void read_times(const Section& head, Study& study) {
  study.time = head.optional_number({"time", "end of the runs"}, quantity::time, Sign::positive);
  study.periods = head.optional_number({"periods", "end of the runs as a multiple of the solution's period"},
                                       quantity::number, Sign::positive);
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
  const auto section = head.optional_section({"parameters", "of the solution"});
  if (!section) return parameters;
  for (const auto& key : section->all_keys())
    parameters[key] = section->any_number({key, "a parameter of the solution (plumb mms --list)"});
  return parameters;
}

std::optional<Expect> read_expect(const Section& root) {
  const auto section = root.optional_section({"expect", "orders that are declared before the runs"});
  if (!section) return std::nullopt;
  Expect expect;
  expect.l2 = section->optional_number({"l2", "order of the displacement's error in L2"}, quantity::number);
  expect.h1 = section->optional_number({"h1", "order of its gradient's error"}, quantity::number);
  expect.velocity_l2 =
      section->optional_number({"velocity_l2", "order of the velocity's error"}, quantity::number);
  expect.stress_l2 = section->optional_number({"stress_l2", "order of the stress's error"}, quantity::number);
  expect.reason = section->text({"reason", "why these orders are expected"});
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
  return study_of(parse_document(text, file_name, overrides, scene_alternatives()), file_name, solutions,
                  use);
}

Study study_of(const TomlValue& document, const std::string& file_name,
               const std::vector<std::string>& solutions, StudyOf use, KeyNotes* notes) {
  const Section root(document, "", notes);
  root.mark_known({"study", "expect", "body", "material"});
  root.mark_known(method_sections());
  if (!document.find("study") && document.find("scene"))
    root.fail("scene", "this file is a scene", "a study has [study]", "plumb run is for scenes");
  root.reject_unknown();
  Study study;
  const Section head = root.section({"study", "the solution and the sequence of spacings"});
  study.name = head.text_or({"name", "what results call it; the file's name where it is left out"},
                            std::filesystem::path(file_name).stem().string());
  study.solution =
      head.choice({"solution", "the manufactured or exact solution (plumb mms --list)"}, solutions);
  study.spacings = head.numbers({"spacings", "from coarse to fine; each divides the body"}, 0,
                                quantity::length, Sign::positive);
  read_times(head, study);
  study.force = head.choice_or(
      {"force", "none: the field as printed; finite-strain: with the body force that makes it exact"},
      study.force, {"none", "finite-strain"});
  study.quadrature =
      head.choice_or({"quadrature", "of the error norms: the paper's Gauss points, the particles, or both"},
                     study.quadrature, {"gauss", "nodal", "both"});
  study.held_band = head.optional_number(
      {"held_band", "particles no farther than this from the boundary follow the solution"}, quantity::length,
      Sign::not_negative);
  study.surface = head.choice_or(
      {"surface",
       "curved surfaces of the body follow the solution (displaced), or its tractions act on them (pulled)"},
      study.surface, {"displaced", "pulled"});
  study.parameters = read_parameters(head);
  head.reject_unknown();
  study.expect = read_expect(root);
  study.body = read_body(root.section({"body", "the domain of the solution, without spacing"}), 0, false);
  if (head.has("surface") && study.body.shape == "box" && study.body.holes.empty())
    head.fail("surface", "for a box without holes", "its faces have the conditions of the solution",
              "leave it out, or give the body another shape or [[body.hole]]");
  study.material = read_material(root.section({"material", "the law and its numbers"}), study.dimension());
  study.method = read_method(root, study.body);
  refuse_history(root, study.material, study.method);
  refuse_misprints(root, study.material, study.method);
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
