#pragma once
#include <cmath>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <variant>

#include "mms/c/plumbline.h"
#include "mms/exact_fields.hpp"

/// What a caller has chosen, and the fields that follow from it: they are made when first asked for.
struct plumb_solution {
  using Fields =
      std::variant<plumb::mms::ExactFields<1>, plumb::mms::ExactFields<2>, plumb::mms::ExactFields<3>>;

  plumb_solution(const plumb::mms::SolutionEntry& entry, int in_dimension)
      : name(entry.name), dimension(in_dimension), parameters(entry.parameters), elastic(entry.material) {}

  std::string name;
  int dimension;
  plumb::mms::Parameters parameters;
  plumb::Elastic elastic;
  plumb::LawChoice law{"neo-hookean"};
  int increments = 100;

  /// Calls use(fields of the dimension). Throws InputError for what was chosen and cannot be.
  template <class Use>
  void with_fields(Use&& use) const {
    std::visit(use, fields());
  }
  /// Forgets the fields, since something has been chosen anew.
  void changed() { made_.reset(); }

 private:
  const Fields& fields() const {
    const std::scoped_lock lock(making_);
    if (!made_) made_ = make();
    return *made_;
  }
  Fields make() const {
    std::map<std::string, double> values;
    for (const auto& p : parameters.all()) values[std::string(p.name)] = p.value;
    if (dimension == 1) return plumb::mms::exact_fields<1>(name, values, elastic, law, increments);
    if (dimension == 2) return plumb::mms::exact_fields<2>(name, values, elastic, law, increments);
    return plumb::mms::exact_fields<3>(name, values, elastic, law, increments);
  }

  mutable std::mutex making_;
  mutable std::optional<Fields> made_;
};
