#include "lib/run/frame.hpp"

#include "lib/material/material.hpp"
#include "lib/material/point.hpp"

namespace plumb {
namespace {

template <int d>
std::vector<double> numbers_of(const std::vector<Vec<d>>& vectors) {
  std::vector<double> values;
  values.reserve(vectors.size() * d);
  for (const auto& v : vectors) values.insert(values.end(), v.data(), v.data() + d);
  return values;
}

/// Of a bar in 1D as vectors in space: one number each would be read as a scalar.
template <int d>
std::vector<double> vectors_for_file(const std::vector<double>& values) {
  return d == 1 ? padded_to_three(values, d) : values;
}

}  // namespace

template <int d>
Frame<d>::Frame(const Snapshot<d>& shown, const std::vector<std::string>& fields)
    : time_(shown.time),
      position_(numbers_of<d>(shown.x)),
      displacement_(numbers_of<d>(shown.u)),
      velocity_(numbers_of<d>(shown.v)),
      more_(shown.more) {
  for (const auto& name : fields) fields_.push_back(shown_field(name, shown));
  for (const auto& F : shown.F) determinant_.push_back(determinant<3, double>(F));
  for (const auto& cauchy : shown.cauchy) {
    pressure_.push_back(-cauchy.trace() / 3);
    von_mises_.push_back(von_mises(cauchy));
  }
}

template <int d>
void Frame<d>::write(ParticleSeries& series) const {
  constexpr int components = d == 1 ? 3 : d;
  const auto displacement = vectors_for_file<d>(displacement_), velocity = vectors_for_file<d>(velocity_);
  std::vector<PointField> fields{{"displacement [m]", components, displacement},
                                 {"velocity [m/s]", components, velocity}};
  if (!determinant_.empty()) fields.push_back({"J", 1, determinant_});
  fields.push_back({"pressure [Pa]", 1, pressure_});
  fields.push_back({"von Mises stress [Pa]", 1, von_mises_});
  for (const auto& more : more_) fields.push_back({more.name + " [" + more.unit + "]", 1, more.values});
  for (const auto& shown : fields_)
    fields.push_back({shown.title(), static_cast<int>(shown.components.size()), shown.values});
  series.write({time_, d, position_, fields});
}

template <int d>
Table Frame<d>::table() const {
  Table table;
  for (const char* quantity : {"position", "displacement", "velocity"})
    for (int k = 0; k < d; ++k)
      table.columns.push_back(std::string(quantity) + " " + "xyz"[k] +
                              (quantity[0] == 'v' ? " [m/s]" : " [m]"));
  if (!determinant_.empty()) table.columns.emplace_back("J");
  table.columns.insert(table.columns.end(), {"pressure [Pa]", "von Mises stress [Pa]"});
  for (const auto& more : more_) table.columns.push_back(more.name + " [" + more.unit + "]");
  for (const auto& shown : fields_)
    for (const auto& column : shown.columns()) table.columns.push_back(column);
  for (std::size_t i = 0; i < pressure_.size(); ++i) {
    std::vector<Cell> row;
    for (const auto* vectors : {&position_, &displacement_, &velocity_})
      row.insert(row.end(), vectors->begin() + static_cast<long>(i) * d,
                 vectors->begin() + static_cast<long>(i + 1) * d);
    if (!determinant_.empty()) row.emplace_back(determinant_[i]);
    row.insert(row.end(), {pressure_[i], von_mises_[i]});
    for (const auto& more : more_) row.emplace_back(more.values[i]);
    for (const auto& shown : fields_)
      for (const double value : shown.of(i)) row.emplace_back(value);
    table.rows.push_back(std::move(row));
  }
  return table;
}

template class Frame<1>;
template class Frame<2>;
template class Frame<3>;

}  // namespace plumb
