#include <fmt/format.h>

#include <array>

#include "lib/schemes/point_fields.hpp"
#include "lib/schemes/updated/updated.hpp"

/// What the scheme shows of its state: of the end of the step, to which the conservative balance moves stress
/// and density from the middle of it.
namespace plumb {

template <int d>
typename Updated<d>::Moved Updated<d>::at_end_of_step(const State& state, Index i) const {
  if (options_.conservative()) return moved(state, i, 0.5 * state.last_step);
  return {point_of(state, i), state.density[0][i], tensor_at<d>(state.F, i)};
}

template <int d>
Snapshot<d> Updated<d>::snapshot(const State& state) {
  Snapshot<d> shown;
  shown.time = state.time;
  shown.step = state.step;
  shown.X = specimen_.cloud.X;
  const bool heat = state.heat.components() > 0;
  for (const auto& [kept, unit] : law_.kept()) shown.more.push_back({kept, unit, {}});
  if (heat) shown.more.push_back({"heat", "J", {}});
  for (Index i = 0; i < count(); ++i) {
    const Moved now = at_end_of_step(state, i);
    shown.u.push_back(vector_at<d>(state.u, i));
    shown.x.push_back(shown.X[i] + shown.u.back());
    shown.v.push_back(vector_at<d>(state.v, i));
    shown.mass.push_back(mass_[i]);
    shown.volume.push_back(mass_[i] / now.density);
    Mat<3> F = Mat<3>::Identity(), stress = -law_.pressure(now.density) * Mat<3>::Identity();
    F.template topLeftCorner<d, d>() = now.F;
    stress.template topLeftCorner<d, d>() += now.point.s;
    // the deviator has no trace: what is left out of d dimensions has the rest of it
    for (int k = d; k < 3; ++k) stress(k, k) -= now.point.s.trace() / (3 - d);
    shown.F.push_back(F);
    shown.cauchy.push_back(stress);
    const std::array<double, 4> values{now.point.plastic, now.point.work, now.point.temperature,
                                       now.point.damage};
    for (std::size_t k = 0; k < law_.kept().size(); ++k) shown.more[k].values.push_back(values[k]);
    if (heat) shown.more.back().values.push_back(state.heat[0][i]);
  }
  return shown;
}

template <int d>
Energy Updated<d>::energy(const State& state) {
  Energy energy;
  double bonds = 0, plastic = 0, heat = 0;
  const bool stored = options_.conservative() && bond_modulus() > 0;
  load(state);
  for (Index i = 0; i < count(); ++i) {
    const Moved now = at_end_of_step(state, i);
    V_[i] = mass_[i] / now.density;
    yield_ratio_[i] = now.point.yield_ratio;
    energy.kinetic += 0.5 * mass_[i] * v_[i].squaredNorm();
    energy.strain += mass_[i] * law_.compression_energy(now.density);
    if (options_.form != "eno") energy.strain += V_[i] * law_.square(now.point.s) / (4 * law_.shear);
    plastic += V_[i] * now.point.work;
    if (state.heat.components() > 0) heat += state.heat[0][i];
  }
  if (stored) bonds = bond_energy(state);
  if (stored) energy.more.push_back({"bonds", bonds});
  if (law_.yields()) energy.more.push_back({"plastic work", plastic});
  if (state.heat.components() > 0) energy.dissipated = heat;
  return energy;
}

/// Last sum of THEORY (17.9), of the stretch that pairs have at the end of the step, with V_ and yield_ratio_
/// of that time.
template <int d>
double Updated<d>::bond_energy(const State& state) {
  if (!state.bonds.list) return 0;
  neighbours_.update(x_);
  PairHistory kept = state.bonds;
  kept.move_to(neighbours_.list());
  stretch_bonds(state, kept, 0.5 * state.last_step);
  std::vector<double> parts(static_cast<std::size_t>(count()));
  for_particles(count(), [&](Index i) {
    double sum = 0;
    for (auto n = kept.list->begin[i]; n < kept.list->begin[i + 1]; ++n) {
      const Index j = kept.list->other[n];
      sum -= slope_((x_[i] - x_[j]).norm()) * V_[j] * next_.bonds.value[n] * next_.bonds.value[n];
    }
    parts[i] = 0.25 * bond_modulus() * V_[i] * sum;  // half of a square, half of a pair
  });
  double energy = 0;
  for (const double part : parts) energy += part;
  return energy;
}

template <int d>
std::vector<Statement> Updated<d>::account() const {
  std::vector<Statement> said;
  said.push_back({"scheme", "the system of paper 002: " + options_.in_words(), "002 (15) to (21)"});
  said.push_back(
      {"stress",
       fmt::format("by rates, with K = {:.6g} Pa and G = {:.6g} Pa{}", law_.bulk, law_.shear,
                   law_.yields() ? ", and radial return to the yield stress of its elastic trial" : ""),
       "002 (4), (8), (14)"});
  if (options_.has_bonds())
    said.push_back({"bonds",
                    fmt::format("{}, xi = {:g}",
                                options_.form == "eno" ? "pairs carry the shear force"
                                                       : "pairs resist what their velocity gradients miss",
                                options_.strength(d) / (options_.form == "eno" ? 2 : 1)),
                    options_.form == "eno"         ? "002 (25)"
                    : options_.penalty == "vector" ? "002 (43)"
                                                   : "002 (46)"});
  said.push_back({"neighbours",
                  fmt::format("at most {} now; they change, and the list looks {:g} dp farther", counts_.most,
                              options_.skin),
                  ""});
  said.push_back(
      {"step", fmt::format("{:g} h/c with c = {:.6g} m/s", options_.cfl, wave_speed()), "002 (23)"});
  if (options_.geometry == "advection")
    said.push_back({"geometry",
                    fmt::format("frozen for {:g} h/v, v at least {:g} m/s", options_.advection_cfl,
                                *options_.reference_speed),
                    "002 (22)"});
  return said;
}

#define PLUMBLINE_INSTANTIATE(d)                                                              \
  template Updated<d>::Moved Updated<d>::at_end_of_step(const UpdatedState<d>&, Index) const; \
  template Snapshot<d> Updated<d>::snapshot(const UpdatedState<d>&);                          \
  template Energy Updated<d>::energy(const UpdatedState<d>&);                                 \
  template std::vector<Statement> Updated<d>::account() const;
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
