#include "lib/material/laws.hpp"

#include "lib/material/rate_models.hpp"

namespace plumb {
namespace {

/// Calls use(Type<M>) for the law of that name.
template <class Use>
void with_law(std::string_view name, Use&& use) {
  if (!with_named(MaterialCatalogue{}, name, use) && !with_named(RateModels{}, name, use))
    throw unknown_name("material model", name, law_names());
}

}  // namespace

std::vector<std::string> law_names() {
  std::vector<std::string> names = names_of(MaterialCatalogue{});
  for (const auto& name : names_of(RateModels{})) names.emplace_back(name);
  return names;
}

bool has_temperature(std::string_view name) {
  bool found = false;
  with_named(RateModels{}, name, [&]<class M>(Type<M>) {
    found = requires(typename M::History & history) {
      history.temperature;
    };
  });
  return found;
}

bool needs_rates(std::string_view name) {
  return with_named(RateModels{}, name, [](auto) {});
}

std::vector<LawParameter> parameters_of_law(std::string_view name) {
  std::vector<LawParameter> all;
  with_law(name, [&]<class M>(Type<M>) {
    ParametersOf<M>().fields([&](const LawParameter& about, auto&) { all.push_back(about); });
  });
  return all;
}

bool has_history(std::string_view name) {
  if (needs_rates(name)) return true;
  bool history = false;
  with_law(name, [&]<class M>(Type<M>) { history = HistoryLaw<M>; });
  return history;
}

void require_law(const LawChoice& choice, const Elastic& elastic) {
  with_law(choice.name, [&]<class M>(Type<M>) { make_law<M>(elastic, choice); });
}

}  // namespace plumb
