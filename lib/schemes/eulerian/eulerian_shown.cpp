#include <fmt/format.h>

#include "lib/schemes/eulerian/eulerian.hpp"
#include "lib/schemes/point_fields.hpp"

/// What the scheme shows of its state.
namespace plumb {

template <int d>
Snapshot<d> Eulerian<d>::snapshot(const State& state) {
  follow_reference(state);
  Snapshot<d> shown;
  shown.time = state.time;
  shown.step = state.step;
  shown.X = specimen_.cloud.X;
  shown.mass = mass_;
  shown.more.push_back({"density drift", "", {}});
  for (const auto& [kept, unit] : law_.kept()) shown.more.push_back({kept, unit, {}});
  for (Index i = 0; i < count(); ++i) {
    shown.u.push_back(vector_at<d>(state.u, i));
    shown.x.push_back(shown.X[i] + shown.u.back());
    shown.v.push_back(vector_at<d>(state.v, i));
  }
  for (Index i = 0; i < count(); ++i) {
    const Mat<d> own = keeps_F() ? tensor_at<d>(state.F, i)
                                 : Mat<d>(reference_->gradient(shown.x, i) * tensor_at<d>(state.before, i));
    const double density = state.density[0][i], J = own.determinant();
    const Mat<d> s = tensor_at<d>(state.stress, i);
    Mat<3> F = Mat<3>::Identity(), stress = -pressure_of(state, i) * Mat<3>::Identity();
    F.template topLeftCorner<d, d>() = own;
    stress.template topLeftCorner<d, d>() += s;
    // the deviator has no trace: what is left out of d dimensions has the rest of it
    for (int k = d; k < 3; ++k) stress(k, k) -= s.trace() / (3 - d);
    shown.F.push_back(F);
    shown.cauchy.push_back(stress);
    shown.volume.push_back(specimen_.cloud.V[i] * J);
    shown.more[0].values.push_back(density * J / law_.density - 1);
    for (int k = 0; k < state.plastic.components(); ++k)
      shown.more[1 + k].values.push_back(state.plastic[k][i]);
  }
  return shown;
}

/// The strain energy is that of density and deviator, of which a path of rates has no potential. What the
/// stress force took and neither stress nor damping received has a line of its own.
template <int d>
Energy Eulerian<d>::energy(const State& state) {
  Energy energy;
  double plastic = 0;
  for (Index i = 0; i < count(); ++i) {
    const double V = mass_[i] / state.density[0][i];
    energy.kinetic += 0.5 * mass_[i] * vector_at<d>(state.v, i).squaredNorm();
    energy.strain += mass_[i] * law_.compression_energy(state.density[0][i]) +
                     V * law_.square(tensor_at<d>(state.stress, i)) / (4 * law_.shear);
    if (law_.yields()) plastic += V * state.plastic[1][i];
  }
  const WorkByCause& work = state.work;
  if (options_.controls_hourglass()) energy.more.push_back({"hourglass", -work.hourglass});
  if (law_.yields()) energy.more.push_back({"plastic work", plastic});
  energy.more.push_back({"force less stress", -work.force - work.stress - work.damping});
  if (options_.has_viscosity() || options_.damping == "objective")
    energy.dissipated = work.damping - work.viscosity;
  return energy;
}

template <int d>
std::vector<std::string> Eulerian<d>::warnings() const {
  std::vector<std::string> found = options_.warnings();
  for (auto& of_law : law_.warnings()) found.push_back(std::move(of_law));
  return found;
}

template <int d>
std::vector<Statement> Eulerian<d>::account() const {
  std::vector<Statement> said;
  const auto add = [&](const char* topic, std::string text, const char* where) {
    said.push_back({topic, std::move(text), where});
  };
  add("scheme", "the system of paper 001: " + options_.in_words(), "THEORY (18.1)-(18.6)");
  add("stress",
      fmt::format(
          "by Jaumann's rate, half of each increment before its turn, with K = {:.6g} Pa and G = {:.6g} Pa{}",
          law_.bulk, law_.shear,
          law_.yields() ? ", and radial return to the yield stress of its elastic trial" : ""),
      "THEORY (18.3), (18.4)");
  if (options_.printed())
    add("force", "stresses over the Shepard sums, as printed: its power is not that of the stress",
        "001 (10), (11)");
  else if (!options_.adjoint())
    add("force", "stresses with the plain gradient of the kernel: its power is not that of the stress",
        "001 (11)");
  else
    add("force", "adjoint: its power is minus that of the stress, and its torque is 0", "THEORY (18.7)");
  if (options_.damping == "objective")
    add("damping",
        "half of what each step adds to the stress, less what yielding takes: of first order in the step",
        "THEORY (18.8)");
  if (options_.damping == "extrapolated")
    add("damping", "rates by the velocity that is extrapolated to the end of the step", "THEORY (18.8)");
  if (options_.stiffness() > 0)
    add("hourglass", fmt::format("springs with xi = {:g} and E = {:.6g} Pa", options_.stiffness(), young()),
        "THEORY (18.9)");
  if (options_.stiffness_share() > 0 && options_.xi_tension > 0)
    add("hourglass",
        fmt::format("xi grows by {:g} (s/E)^2 with the largest tension s",
                    options_.stiffness_share() * options_.xi_tension),
        "THEORY (18.11)");
  if (options_.viscous() > 0)
    add("hourglass", fmt::format("dampers with zeta = {:g} where the error grows", options_.viscous()),
        "THEORY (18.10)");
  if (options_.has_viscosity()) add("viscosity", "between pairs that approach", "001 (17), (18)");
  if (options_.artificial_stress > 0)
    add("artificial stress", "of tension, between near pairs", "001 (19), (20)");
  if (options_.diffusion > 0) add("diffusion", "of density, between pairs", "001 (21)");
  add("neighbours",
      fmt::format("at most {} now; they change, and the list looks {:g} dp farther", counts_.most,
                  options_.skin),
      "");
  add("step", fmt::format("{:g} h/c with c = {:.6g} m/s", options_.cfl, wave_speed()), "");
  return said;
}

#define PLUMBLINE_INSTANTIATE(d)                                       \
  template Snapshot<d> Eulerian<d>::snapshot(const EulerianState<d>&); \
  template Energy Eulerian<d>::energy(const EulerianState<d>&);        \
  template std::vector<std::string> Eulerian<d>::warnings() const;     \
  template std::vector<Statement> Eulerian<d>::account() const;
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
