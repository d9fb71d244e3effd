#include "lib/scene/unused_keys.hpp"

#include <fmt/format.h>

#include <optional>

namespace plumb {
namespace {

constexpr const char* no_steps = "nothing is stepped in time";
constexpr const char* judged_in_space = "it declares orders in space";

/// Keys that say how time is stepped.
void add_steps(std::vector<UnusedKey>& keys, const std::string& why) {
  for (const char* key : {"cfl", "time_step", "wave_speed"}) keys.push_back({"method", key, why});
}

/// "[jst]" or "method.cfl".
std::string name_of(const UnusedKey& unused) {
  return unused.key.empty() ? "[" + unused.section + "]" : unused.section + "." + unused.key;
}

/// The key, or the first one of the section if none is named, that comes from the command line.
std::optional<std::string> set_by_call(const Section& section, const std::string& key) {
  for (const auto& name : key.empty() ? section.all_keys() : std::vector{key})
    if (section.where(name).line == 0) return name;
  return std::nullopt;
}

[[noreturn]] void refuse(const Section& section, const std::string& key, const UnusedKey& unused) {
  section.fail(key, "not used by this command", unused.why, "leave it out");
}

}  // namespace

std::vector<UnusedKey> keys_unused_by(StudyOf use) {
  std::vector<UnusedKey> keys;
  if (use == StudyOf::space) return keys;
  if (use == StudyOf::cost)
    return {{"expect", "", "methods are compared by their errors, and no order is judged"},
            {"study", "quadrature", "errors are those of the particles"}};
  if (use == StudyOf::time)
    return {
        {"expect", "", std::string(judged_in_space) + ", and an integrator declares its own in time", true},
        {"method", "integrator", "every integrator is run, each against its own order in time", true},
        {"method", "wave_speed", "every step is fixed; the first follows from cfl and the linear wave speed",
         true},
        {"study", "quadrature", "runs are compared at the particles", true}};
  keys = {{"study", "quadrature", "errors are those of the particles"},
          {"study", "held_band", "nothing moves along the solution"},
          {"study", "force", "the loads are those of the exact field"},
          {"method", "integrator", no_steps},
          {"damping", "", "nothing moves"}};
  add_steps(keys, no_steps);
  if (use == StudyOf::equilibrium) {
    keys.push_back(
        {"expect", "velocity_l2", "nothing moves, so that this order would never be judged", true});
    keys.push_back({"jst", "", "nothing moves"});
    keys.push_back({"dissipation", "", "nothing moves"});
  } else {
    keys.push_back({"expect", "", "it declares orders of a displacement, and no order is judged here"});
    keys.push_back({"study", "surface", "nothing acts on the surface"});
    for (const char* key : {"eta2", "eta4", "outer"})
      keys.push_back({"jst", key, "only the weights of the Laplacian are looked at"});
  }
  return keys;
}

std::vector<UnusedKey> keys_unused_by_spectrum() {
  const char* about_reference = "the equations are linearised about the reference state";
  std::vector<UnusedKey> keys{{"scene", "end_time", no_steps},
                              {"scene", "max_steps", no_steps},
                              {"initial", "", about_reference},
                              {"relaxation", "", no_steps},
                              {"output", "", "no run writes anything"}};
  add_steps(keys, no_steps);
  return keys;
}

std::vector<UnusedKey> keys_unused_by_newton() {
  const char* no_limit = "Newton's method has no stability limit";
  return {{"method", "cfl", no_limit},
          {"method", "wave_speed", no_limit},
          {"method", "integrator", "[implicit] says how steps are made"},
          {"jst", "", "a dissipation has no energy"},
          {"damping", "", "a damping has no energy"}};
}

std::vector<std::string> unused_by_scheme(const Section& root, const std::string& scheme,
                                          const std::vector<UnusedKey>& keys) {
  std::vector<std::string> unused;
  for (const UnusedKey& one : keys)
    if (root.has(one.section) && (one.key.empty() || root.section(one.section).has(one.key)))
      unused.push_back(fmt::format("{} is not used by scheme = \"{}\": {}", name_of(one), scheme, one.why));
  return unused;
}

std::vector<std::string> refuse_unused(const Section& root, const std::vector<UnusedKey>& keys) {
  std::vector<UnusedKey> in_file;
  for (const UnusedKey& one : keys) {
    if (!root.has(one.section)) continue;
    const Section section = root.section(one.section);
    if (!one.key.empty() && !section.has(one.key)) continue;
    if (const auto set = set_by_call(section, one.key)) refuse(section, *set, one);
    in_file.push_back(one);
  }
  std::vector<std::string> unused;
  for (const UnusedKey& one : in_file) {
    if (one.also_in_files) refuse(root.section(one.section), one.key, one);
    unused.push_back(name_of(one) + " is not used by this command: " + one.why);
  }
  return unused;
}

}  // namespace plumb
