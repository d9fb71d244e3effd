#include "plumb/run/frame.hpp"

#include <array>
#include <cmath>

#include "plumbline/diagnostics/measures.hpp"
#include "plumbline/material/point.hpp"

namespace plumb {
namespace {

template <int d>
void put(std::vector<double>& values, Index particle, const Vec<d>& v) {
  for (int k = 0; k < d; ++k) values[particle * d + k] = v[k];
}

}  // namespace

template <int d>
Frame<d>::Frame(const Solid<d>& solid, const State<d>& state, const MaterialChoice& material)
    : time_(state.time) {
  const Index count = solid.cloud.size();
  const MaterialPoint point = make_point(material.law(), material.elastic());
  for (auto* vectors : {&position_, &displacement_, &velocity_}) vectors->resize(count * d);
  for (auto* scalars : {&determinant_, &pressure_, &von_mises_}) scalars->resize(count);
#pragma omp parallel for schedule(static)
  for (Index i = 0; i < count; ++i) {
    const Index slot = solid.bonds.slots.of(i);
    put<d>(position_, i, position_of(solid, state, i));
    put<d>(displacement_, i, vector_at<d>(state.u, slot));
    put<d>(velocity_, i, vector_at<d>(state.v, slot));
    Mat<3> F = Mat<3>::Identity();
    F.template topLeftCorner<d, d>() = deformation_gradient_of(solid, state, i);
    const PointState at = point(F);
    determinant_[i] = determinant<3, double>(at.F);
    pressure_[i] = -at.cauchy.trace() / 3;
    von_mises_[i] = von_mises(at.cauchy);
  }
}

template <int d>
void Frame<d>::write(ParticleSeries& series) const {
  const std::array<PointField, 5> fields{{{"displacement [m]", d, displacement_},
                                          {"velocity [m/s]", d, velocity_},
                                          {"J", 1, determinant_},
                                          {"pressure [Pa]", 1, pressure_},
                                          {"von Mises stress [Pa]", 1, von_mises_}}};
  series.write({time_, d, position_, fields});
}

template <int d>
Table Frame<d>::table() const {
  Table table;
  for (const char* quantity : {"position", "displacement", "velocity"})
    for (int k = 0; k < d; ++k)
      table.columns.push_back(std::string(quantity) + " " + "xyz"[k] +
                              (quantity[0] == 'v' ? " [m/s]" : " [m]"));
  table.columns.insert(table.columns.end(), {"J", "pressure [Pa]", "von Mises stress [Pa]"});
  for (std::size_t i = 0; i < determinant_.size(); ++i) {
    std::vector<Cell> row;
    for (const auto* vectors : {&position_, &displacement_, &velocity_})
      row.insert(row.end(), vectors->begin() + static_cast<long>(i) * d,
                 vectors->begin() + static_cast<long>(i + 1) * d);
    row.insert(row.end(), {determinant_[i], pressure_[i], von_mises_[i]});
    table.rows.push_back(std::move(row));
  }
  return table;
}

template class Frame<2>;
template class Frame<3>;

}  // namespace plumb
