#include "lib/run/output_fields.hpp"

#include <fmt/format.h>

#include "lib/core/error.hpp"
#include "lib/material/material.hpp"

namespace plumb {
namespace {

/// What one particle is asked for. Tensors may be missing.
template <int d>
struct Asked {
  Vec<d> X;
  const Mat<3>* F;
  const Mat<3>* cauchy;
  double volume;  ///< current [m^d]
};

struct FieldKind {
  const char* name;
  const char* unit;
};

constexpr FieldKind kinds[] = {
    {"F", ""}, {"stress", "Pa"}, {"strain", ""}, {"volume", "m^"}, {"reference_position", "m"}};

const FieldKind& kind_named(const std::string& name) {
  for (const auto& kind : kinds)
    if (name == kind.name) return kind;
  throw unknown_name("field", name, output_field_names());
}

std::vector<std::string> tensor_components() {
  std::vector<std::string> names;
  for (const char row : {'x', 'y', 'z'})
    for (const char column : {'x', 'y', 'z'}) names.push_back({row, column});
  return names;
}

/// Titles without numbers.
template <int d>
ShownField titles_of(const std::string& name) {
  const FieldKind& kind = kind_named(name);
  ShownField field{kind.name, kind.unit, {}, {}};
  if (field.unit == "m^") field.unit += std::to_string(d);
  if (name == "volume")
    field.components = {""};
  else if (name == "reference_position")
    for (int k = 0; k < d; ++k) field.components.push_back({"xyz"[k]});
  else
    field.components = tensor_components();
  return field;
}

[[noreturn]] void missing(const std::string& name) {
  throw InputError(fmt::format("the scheme has no field \"{}\"", name),
                   "it shows no deformation gradient or no stress", "leave it out of [output] fields");
}

template <int d>
void append(const std::string& name, const Asked<d>& asked, std::vector<double>& values) {
  const auto add_tensor = [&](const Mat<3>& T) {
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) values.push_back(T(a, b));
  };
  if (name == "volume") return values.push_back(asked.volume);
  if (name == "reference_position")
    return static_cast<void>(values.insert(values.end(), asked.X.data(), asked.X.data() + d));
  if (name == "stress") {
    if (!asked.cauchy) missing(name);
    return add_tensor(*asked.cauchy);
  }
  if (!asked.F) missing(name);
  if (name == "F") return add_tensor(*asked.F);
  add_tensor((asked.F->transpose() * *asked.F - Mat<3>::Identity()) / 2);  // Green-Lagrange
}

}  // namespace

std::vector<std::string> output_field_names() {
  std::vector<std::string> names;
  for (const auto& kind : kinds) names.emplace_back(kind.name);
  return names;
}

std::string ShownField::title() const {
  return unit.empty() ? name : fmt::format("{} [{}]", name, unit);
}

std::vector<std::string> ShownField::columns() const {
  std::vector<std::string> all;
  for (const auto& component : components) {
    std::string column = name;
    if (!component.empty()) column += " " + component;
    if (!unit.empty()) column += " [" + unit + "]";
    all.push_back(column);
  }
  return all;
}

std::vector<double> ShownField::of(std::size_t particle) const {
  const auto first = values.begin() + static_cast<long>(particle * components.size());
  return {first, first + static_cast<long>(components.size())};
}

template <int d>
ShownField shown_field(const std::string& name, const Snapshot<d>& shown) {
  ShownField field = titles_of<d>(name);
  for (std::size_t i = 0; i < shown.X.size(); ++i)
    append<d>(name,
              {shown.X[i], shown.F.empty() ? nullptr : &shown.F[i],
               shown.cauchy.empty() ? nullptr : &shown.cauchy[i], shown.volume[i]},
              field.values);
  return field;
}

template <int d>
std::vector<std::string> probe_columns(const std::string& name) {
  return titles_of<d>(name).columns();
}

template <int d>
std::vector<double> probe_values(const std::string& name, const PointView<d>& at) {
  std::vector<double> values;
  append<d>(name, {at.X, at.F ? &*at.F : nullptr, at.cauchy ? &*at.cauchy : nullptr, at.volume}, values);
  return values;
}

#define PLUMBLINE_INSTANTIATE(d)                                              \
  template ShownField shown_field<d>(const std::string&, const Snapshot<d>&); \
  template std::vector<std::string> probe_columns<d>(const std::string&);     \
  template std::vector<double> probe_values<d>(const std::string&, const PointView<d>&);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
