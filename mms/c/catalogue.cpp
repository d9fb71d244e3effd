// The catalogues of solutions and laws in C's words.
#include <limits>
#include <optional>
#include <vector>

#include "lib/material/laws.hpp"
#include "mms/c/guard.hpp"
#include "mms/c/values.hpp"
#include "mms/manufactured.hpp"

namespace plumb::c {
namespace {

/// A parameter whose words live as long as the library.
struct OwnParameter {
  std::string name, unit, meaning;
  double value, least, most;
};

struct Entry {
  std::string name, summary;
  std::vector<int> dimensions;
  bool history = false;
  std::vector<OwnParameter> parameters;
};

double default_of(double value) {
  return value;
}
double default_of(const std::optional<double>& value) {
  return value.value_or(none);
}

template <class M>
Entry law_entry() {
  Entry entry{std::string(M::name), "", {1, 2, 3}, HistoryLaw<M>, {}};
  ParametersOf<M> defaults;
  defaults.fields([&](const LawParameter& about, const auto& value) {
    const double least = about.sign == Sign::any ? -std::numeric_limits<double>::infinity() : 0;
    entry.parameters.push_back({std::string(about.name), std::string(about.quantity.unit),
                                std::string(about.meaning), about.required ? none : default_of(value), least,
                                about.most});
  });
  return entry;
}

const std::vector<Entry>& laws() {
  static const std::vector<Entry> all = [] {
    std::vector<Entry> entries;
    for_each_type(MaterialCatalogue{}, [&]<class M>(Type<M>) { entries.push_back(law_entry<M>()); });
    return entries;
  }();
  return all;
}

const std::vector<Entry>& solutions() {
  static const std::vector<Entry> all = [] {
    std::vector<Entry> entries;
    for (const auto& solution : mms::solution_list()) {
      Entry entry{solution.name, solution.summary, solution.dimensions, false, {}};
      for (const auto& p : solution.parameters.all())
        entry.parameters.push_back({std::string(p.name), p.unit == "1" ? "" : std::string(p.unit),
                                    std::string(p.meaning), p.value, p.least, p.most});
      entries.push_back(entry);
    }
    return entries;
  }();
  return all;
}

using Catalogue = const std::vector<Entry>& (*)();

/// The entry, or null beyond the last one. Nothing is thrown.
const Entry* entry_of(Catalogue catalogue, std::size_t at) noexcept {
  const Entry* found = nullptr;
  guarded([&] {
    if (at < catalogue().size()) found = &catalogue()[at];
  });
  return found;
}

std::size_t size_of(Catalogue catalogue) noexcept {
  std::size_t size = 0;
  guarded([&] { size = catalogue().size(); });
  return size;
}

plumb_status parameter_of(Catalogue catalogue, std::size_t at, std::size_t k, plumb_parameter* out) {
  return guarded([&] {
    require(out, "parameter");
    const Entry* entry = entry_of(catalogue, at);
    if (entry == nullptr || k >= entry->parameters.size())
      throw InputError("there is no such parameter", "numbers count from 0", "ask for the count first");
    const OwnParameter& p = entry->parameters[k];
    *out = {p.name.c_str(), p.unit.c_str(), p.meaning.c_str(), p.value, p.least, p.most};
  });
}

}  // namespace
}  // namespace plumb::c

using namespace plumb::c;

extern "C" {
size_t plumb_solution_count(void) {
  return size_of(solutions);
}
const char* plumb_solution_name(size_t solution) {
  const Entry* entry = entry_of(solutions, solution);
  return entry != nullptr ? entry->name.c_str() : nullptr;
}
const char* plumb_solution_summary(size_t solution) {
  const Entry* entry = entry_of(solutions, solution);
  return entry != nullptr ? entry->summary.c_str() : nullptr;
}
int plumb_solution_exists_in(size_t solution, int dimension) {
  const Entry* entry = entry_of(solutions, solution);
  if (entry == nullptr) return 0;
  for (const int d : entry->dimensions)
    if (d == dimension) return 1;
  return 0;
}
size_t plumb_solution_parameter_count(size_t solution) {
  const Entry* entry = entry_of(solutions, solution);
  return entry != nullptr ? entry->parameters.size() : 0;
}
plumb_status plumb_solution_parameter(size_t solution, size_t k, plumb_parameter* parameter) {
  return parameter_of(solutions, solution, k, parameter);
}

size_t plumb_law_count(void) {
  return size_of(laws);
}
const char* plumb_law_name(size_t law) {
  const Entry* entry = entry_of(laws, law);
  return entry != nullptr ? entry->name.c_str() : nullptr;
}
int plumb_law_has_history(size_t law) {
  const Entry* entry = entry_of(laws, law);
  return entry != nullptr && entry->history ? 1 : 0;
}
size_t plumb_law_parameter_count(size_t law) {
  const Entry* entry = entry_of(laws, law);
  return entry != nullptr ? entry->parameters.size() : 0;
}
plumb_status plumb_law_parameter(size_t law, size_t k, plumb_parameter* parameter) {
  return parameter_of(laws, law, k, parameter);
}
}
