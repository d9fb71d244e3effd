#include "lib/stability/stability_study.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>

#include "lib/input/explored_keys.hpp"
#include "lib/input/section.hpp"
#include "lib/scene/read_scene.hpp"

namespace plumb {
namespace {

struct Named {
  EdgeParameter parameter;
  const char* name;
  const char* key;  ///< of a scene; empty: not a plain setting
};
constexpr std::array<Named, 7> parameters{{{EdgeParameter::cfl, "cfl", "method.cfl"},
                                           {EdgeParameter::stretch, "stretch", ""},
                                           {EdgeParameter::twist, "twist", ""},
                                           {EdgeParameter::poisson, "poisson", "material.poisson"},
                                           {EdgeParameter::eta4, "eta4", "jst.eta4"},
                                           {EdgeParameter::beta, "beta", "method.beta"},
                                           {EdgeParameter::jitter, "jitter", "body.jitter"}}};

const Named& entry_of(EdgeParameter parameter) {
  return parameters[static_cast<std::size_t>(parameter)];
}

EdgeParameter read_parameter(const Section& section) {
  std::vector<std::string> names;
  names.reserve(parameters.size());
  for (const auto& one : parameters) names.emplace_back(one.name);
  const std::string name = section.choice({"parameter", "what is driven to the edge of stability"}, names);
  for (const auto& one : parameters)
    if (name == one.name) return one.parameter;
  return EdgeParameter::cfl;
}

void read_range(const Section& section, StabilityStudy& study) {
  if (study.parameter == EdgeParameter::stretch) return;
  study.from = section.number({"from", "stable end of the range in which the edge is looked for"},
                              quantity::number, Sign::not_negative);
  study.to = section.number({"to", "other end of that range"}, quantity::number, Sign::positive);
  study.tolerance = section.number_or({"tolerance", "the edge is found to this share of it"}, study.tolerance,
                                      quantity::number, Sign::positive);
  if (study.from >= study.to)
    section.fail("to", fmt::format("{:g} is not beyond from = {:g}", study.to, study.from),
                 "the edge lies between them");
}

std::vector<Variant> read_variants(const Section& root) {
  std::vector<Variant> variants;
  for (const auto& section : root.sections({"variant", "schemes that are compared, one section each"})) {
    variants.push_back({section.text({"name", "what results call it"}),
                        section.has("set")
                            ? section.texts({"set", "settings of the scene, \"section.key=value\""})
                            : std::vector<std::string>{}});
    section.reject_unknown();
  }
  return variants;
}

/// Behind those of the study, those of the list that it names: a file that several studies share.
void add_shared_variants(const std::string& list, std::vector<Variant>& variants) {
  if (!list.empty()) {
    const TomlValue document = parse_document(read_text(list), list);
    const Section shared(document, "");
    for (auto& variant : read_variants(shared)) variants.push_back(std::move(variant));
    shared.reject_unknown();
  }
  if (variants.empty()) variants.push_back({"as written", {}});
}

/// Everything that the file itself says; `list`: the file of further variants.
StabilityStudy study_of_keys(const TomlValue& document, const std::string& path, std::string& list,
                             KeyNotes* notes) {
  const Section root(document, "", notes);
  const Section head =
      root.section({"stability", "the scene, what is varied, and when a run counts as unstable"});
  StabilityStudy study;
  study.name = head.text_or({"name", "what results call it; the file's name where it is left out"},
                            std::filesystem::path(path).stem().string());
  const auto beside = [&path](const std::string& file) {
    return (std::filesystem::path(path).parent_path() / file).lexically_normal().string();
  };
  study.file = beside(head.text({"scene", "the scene, relative to this file"}));
  if (head.has("set"))
    study.set = head.texts({"set", "settings of the scene for all runs, \"section.key=value\""});
  study.parameter = read_parameter(head);
  read_range(head, study);
  study.over = head.text_or({"over", "dotted key of the second parameter"}, "");
  study.values =
      study.over.empty() ? std::vector<std::string>{""} : head.texts({"values", "of the second parameter"});
  study.bounds.energy_growth = head.optional_number(
      {"energy_growth", "growth of the energy, relative, from which a run counts as unstable"},
      quantity::number, Sign::not_negative);
  study.bounds.hourglass = head.optional_number(
      {"hourglass", "share of motion that neighbours do not explain, from which it does"}, quantity::number,
      Sign::positive);
  list = head.has("schemes")
             ? beside(head.text({"schemes", "a file of further variants, relative to this one"}))
             : "";
  head.reject_unknown();
  study.variants = read_variants(root);
  root.reject_unknown();
  return study;
}

/// Every scene of the study is read before the first one runs.
void require_scenes(const StabilityStudy& study) {
  for (const auto& variant : study.variants)
    for (const auto& value : study.values)
      for (const double at : {study.from, study.to})
        varied_scene(study, overrides_of(study, variant, value, at), at);
}

}  // namespace

std::string name_of(EdgeParameter parameter) {
  return entry_of(parameter).name;
}

std::vector<std::string> overrides_of(const StabilityStudy& study, const Variant& variant,
                                      const std::string& over_value, double value) {
  std::vector<std::string> all = study.set;
  all.insert(all.end(), variant.set.begin(), variant.set.end());
  if (!study.over.empty()) all.push_back(study.over + "=" + over_value);
  const std::string key = entry_of(study.parameter).key;
  if (!key.empty()) all.push_back(fmt::format("{}={}", key, value));
  return all;
}

Scene varied_scene(const StabilityStudy& study, const std::vector<std::string>& overrides, double value) {
  Scene scene = parse_scene(study.scene, study.file, overrides);
  if (study.parameter != EdgeParameter::twist) return scene;
  if (!scene.initial || scene.initial->velocity.empty())
    throw InputError(study.file + ": there is no initial velocity to twist with",
                     "its formulas are those for 1 rad/s", "add [initial] velocity = [..]");
  for (auto& formula : scene.initial->velocity)
    formula = Expression(fmt::format("{:.17g}*({})", value, formula.text()), scene.dimension);
  return scene;
}

StabilityStudy read_stability_study(const std::string& path, const std::vector<std::string>& overrides) {
  std::string list;
  StabilityStudy study = study_of_keys(parse_document(read_text(path), path, overrides), path, list, nullptr);
  study.scene = read_text(study.file);
  add_shared_variants(list, study.variants);
  require_scenes(study);
  return study;
}

KeyNotes keys_of_stability_studies() {
  const TomlValue first = parse_document(
      "[stability]\nscene = \"scene.toml\"\nparameter = \"cfl\"\nfrom = 0.25\nto = 2", "sample");
  return explored_keys({first}, [](const TomlValue& document, KeyNotes& notes) {
    std::string list;
    study_of_keys(document, "", list, &notes);
  });
}

}  // namespace plumb
