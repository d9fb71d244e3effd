#include "lib/stability/stability_study.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>

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
  const std::string name = section.text("parameter");
  section.choice_or("parameter", name, names);
  for (const auto& one : parameters)
    if (name == one.name) return one.parameter;
  return EdgeParameter::cfl;
}

void read_range(const Section& section, StabilityStudy& study) {
  if (study.parameter == EdgeParameter::stretch) return;
  study.from = section.number("from", quantity::number, Sign::not_negative);
  study.to = section.number("to", quantity::number, Sign::positive);
  study.tolerance = section.number_or("tolerance", study.tolerance, quantity::number, Sign::positive);
  if (study.from >= study.to)
    section.fail("to", fmt::format("{:g} is not beyond from = {:g}", study.to, study.from),
                 "the edge lies between them");
}

std::vector<Variant> read_variants(const Section& root) {
  std::vector<Variant> variants;
  for (const auto& section : root.sections("variant")) {
    variants.push_back(
        {section.text("name"), section.has("set") ? section.texts("set") : std::vector<std::string>{}});
    section.reject_unknown();
  }
  return variants;
}

/// Those of the study itself, then those of the list that it names: a file that several studies share.
std::vector<Variant> all_variants(const Section& root, const std::string& list) {
  std::vector<Variant> variants = read_variants(root);
  if (!list.empty()) {
    const TomlValue document = parse_document(read_text(list), list);
    const Section shared(document, "");
    for (auto& variant : read_variants(shared)) variants.push_back(std::move(variant));
    shared.reject_unknown();
  }
  if (variants.empty()) variants.push_back({"as written", {}});
  return variants;
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
  const TomlValue document = parse_document(read_text(path), path, overrides);
  const Section root(document, "");
  const Section head = root.section("stability");
  StabilityStudy study;
  study.name = head.text_or("name", std::filesystem::path(path).stem().string());
  const auto beside = [&path](const std::string& file) {
    return (std::filesystem::path(path).parent_path() / file).lexically_normal().string();
  };
  study.file = beside(head.text("scene"));
  study.scene = read_text(study.file);
  if (head.has("set")) study.set = head.texts("set");
  study.parameter = read_parameter(head);
  read_range(head, study);
  study.over = head.text_or("over", "");
  study.values = study.over.empty() ? std::vector<std::string>{""} : head.texts("values");
  study.bounds.energy_growth = head.optional_number("energy_growth", quantity::number, Sign::not_negative);
  study.bounds.hourglass = head.optional_number("hourglass", quantity::number, Sign::positive);
  const std::string list = head.has("schemes") ? beside(head.text("schemes")) : "";
  head.reject_unknown();
  study.variants = all_variants(root, list);
  root.reject_unknown();
  require_scenes(study);
  return study;
}

}  // namespace plumb
