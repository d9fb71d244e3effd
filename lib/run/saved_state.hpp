#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "lib/particles/work.hpp"

namespace plumb {

/// Where a run stands.
struct Moment {
  double time = 0;  ///< [s]
  long step = 0;
};

/// Says what the numbers of a kept field belong to.
enum class KeptFor {
  particles,  ///< particle after particle
  points,     ///< places that are no particles, component after component
  pairs,      ///< particle, particle, number; pair after pair
  body        ///< the whole body
};

/// One field of a state as it is kept in a file: particle after particle, so that it is the same for any
/// number of threads and any order in memory. A field with `components` numbers in all belongs to the whole
/// body.
struct SavedField {
  std::string name;
  int components = 1;               ///< numbers of one particle
  std::vector<double> values;       ///< SI units
  std::string unit = {};            ///< as FieldInfo has it; not in the file
  KeptFor of = KeptFor::particles;  ///< likewise
};

/// All that a body needs to go on bit for bit.
struct SavedState {
  Moment now;
  Work work;
  std::vector<SavedField> fields;
};

/// The field of that name; null if there is none.
inline const SavedField* field_named(const std::vector<SavedField>& fields, std::string_view name) {
  for (const auto& field : fields)
    if (field.name == name) return &field;
  return nullptr;
}

}  // namespace plumb
