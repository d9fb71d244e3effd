#pragma once
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "lib/core/field.hpp"
#include "lib/core/types.hpp"

/// Histories of a law for all slots of a body, in one field: the values of History::fields() one after the
/// other, tensors row by row.
namespace plumb {

/// Describes one value of a law's history, for files: where it starts in the field, and whether it is a
/// tensor.
struct HistoryValue {
  std::string name, unit;
  int first;
  bool tensor;

  int components() const { return tensor ? 9 : 1; }
};

/// Lists the values of a history.
template <class History>
std::vector<HistoryValue> history_values() {
  std::vector<HistoryValue> values;
  int next = 0;
  History().fields([&](std::string_view name, std::string_view unit, auto& value) {
    const bool tensor = !std::is_same_v<std::decay_t<decltype(value)>, double>;
    values.push_back({std::string(name), std::string(unit), next, tensor});
    next += values.back().components();
  });
  return values;
}

/// Reads the history of one slot.
template <class History>
void load_history(History& history, const Field& from, Index slot) {
  int k = 0;
  history.fields([&](std::string_view, std::string_view, auto& value) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, double>)
      value = from[k++][slot];
    else
      for (int n = 0; n < 9; ++n) value(n / 3, n % 3) = from[k++][slot];
  });
}

/// Writes the history of one slot.
template <class History>
void store_history(History& history, Field& to, Index slot) {
  int k = 0;
  history.fields([&](std::string_view, std::string_view, auto& value) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, double>)
      to[k++][slot] = value;
    else
      for (int n = 0; n < 9; ++n) to[k++][slot] = value(n / 3, n % 3);
  });
}

}  // namespace plumb
