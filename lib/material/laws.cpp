#include "lib/material/laws.hpp"

namespace plumb {
namespace {

/// Calls use(Type<M>) for the law of that name.
template <class Use>
void with_law(std::string_view name, Use&& use) {
  if (!with_named(MaterialCatalogue{}, name, use))
    throw unknown_name("material model", name, names_of(MaterialCatalogue{}));
}

}  // namespace

std::vector<LawParameter> parameters_of_law(std::string_view name) {
  std::vector<LawParameter> all;
  with_law(name, [&]<class M>(Type<M>) {
    ParametersOf<M>().fields([&](const LawParameter& about, auto&) { all.push_back(about); });
  });
  return all;
}

bool has_history(std::string_view name) {
  bool history = false;
  with_law(name, [&]<class M>(Type<M>) { history = HistoryLaw<M>; });
  return history;
}

void require_law(const LawChoice& choice, const Elastic& elastic) {
  with_law(choice.name, [&]<class M>(Type<M>) { make_law<M>(elastic, choice); });
}

}  // namespace plumb
