#include "mms/manufactured.hpp"

#include "lib/material/laws.hpp"
#include "mms/catalogue.hpp"

namespace plumb::mms {
namespace {

template <class S>
SolutionEntry entry_of() {
  SolutionEntry entry{std::string(S::name), std::string(S::summary), {}, S::defaults(), S::material()};
  if constexpr (S::template in_dimension<1>) entry.dimensions.push_back(1);
  if constexpr (S::template in_dimension<2>) entry.dimensions.push_back(2);
  if constexpr (S::template in_dimension<3>) entry.dimensions.push_back(3);
  return entry;
}

template <int d, class S>
void fill_motion(const S& solution, Manufactured<d>& out) {
  static_assert(Solution<S, d>);
  out.name = S::name;
  out.period = solution.period();
  out.domain = solution.template domain<d>();
  if constexpr (requires { S::still; }) out.still = S::still;
  out.motion = [solution](const Vec<d>& X, double t) { return motion_of<d>(solution, X, t); };
}

template <int d, class M>
void fill_stress(const M& material, Manufactured<d>& out) {
  out.first_piola = [material](const Mat<d>& F) -> Mat<d> { return material.first_piola(F); };
  out.stress_divergence = [material](const Motion<d>& m) { return stress_divergence<d>(material, m); };
}

}  // namespace

std::vector<SolutionEntry> solution_list() {
  std::vector<SolutionEntry> entries;
  for_each_type(SolutionCatalogue{}, [&]<class S>(Type<S>) { entries.push_back(entry_of<S>()); });
  return entries;
}

std::vector<std::string> solution_names() {
  std::vector<std::string> names;
  for (const SolutionEntry& entry : solution_list()) names.push_back(entry.name);
  return names;
}

SolutionEntry solution_entry(std::string_view name) {
  for (SolutionEntry& entry : solution_list())
    if (entry.name == name) return entry;
  throw unknown_name("manufactured solution", name, names_of(SolutionCatalogue{}));
}

template <int d>
Manufactured<d> manufactured(std::string_view name, const std::map<std::string, double>& parameters,
                             const Elastic& elastic, const LawChoice& law) {
  Manufactured<d> out;
  out.density = elastic.density;
  Parameters values = solution_entry(name).parameters;
  for (const auto& entry : parameters) values.set(entry.first, entry.second);
  with_named(SolutionCatalogue{}, name, [&]<class S>(Type<S>) {
    if constexpr (S::template in_dimension<d>)
      fill_motion<d>(S(values, in_dimension(d, elastic, law.plane)), out);
    else
      throw InputError("the solution " + std::string(name) + " does not exist in " + std::to_string(d) + "D",
                       "", "See `plumb mms --list`.");
  });
  with_elastic_law<d>(law, elastic, [&](const auto& material) { fill_stress<d>(material, out); });
  return out;
}

template Manufactured<1> manufactured<1>(std::string_view, const std::map<std::string, double>&,
                                         const Elastic&, const LawChoice&);
template Manufactured<2> manufactured<2>(std::string_view, const std::map<std::string, double>&,
                                         const Elastic&, const LawChoice&);
template Manufactured<3> manufactured<3>(std::string_view, const std::map<std::string, double>&,
                                         const Elastic&, const LawChoice&);

}  // namespace plumb::mms
