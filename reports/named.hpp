#pragma once
#include <fmt/format.h>

#include <string_view>

#include "reports/results.hpp"

/// Selection by name: what a section shows must not depend on the order of a list.
namespace plumb::reports {

/// The entry of a list whose `member` is `name`. @throws MissingResult if there is none.
template <class List, class Item>
Item named(const List& list, std::string_view name, std::string Item::*member) {
  for (const Item& entry : list)
    if (entry.*member == name) return entry;
  throw MissingResult(fmt::format("a list has no entry \"{}\"", name));
}

/// The variant, scheme or study of that id. @throws MissingResult if there is none.
template <class List>
auto by_id(const List& list, std::string_view id) {
  return named(list, id, &List::value_type::id);
}

/// The series of that label. @throws MissingResult if there is none.
inline Series by_label(const std::vector<Series>& list, std::string_view label) {
  return named(list, label, &Series::label);
}

/// The place of the series of that label, for a slope triangle below it. @throws MissingResult.
inline std::size_t place_of(const std::vector<Series>& list, std::string_view label) {
  for (std::size_t k = 0; k < list.size(); ++k)
    if (list[k].label == label) return k;
  throw MissingResult(fmt::format("a picture has no series \"{}\"", label));
}

/// The entry of a row of a table below the column of that name. @throws MissingResult if there is none.
inline const Entry& cell_of(const DataTable& table, const std::vector<Entry>& row, std::string_view column) {
  for (std::size_t k = 0; k < row.size() && k < table.columns.size(); ++k)
    if (table.columns[k].name == column) return row[k];
  throw MissingResult(fmt::format("a table has no column \"{}\"", column));
}

}  // namespace plumb::reports
