#include "lib/schemes/mixed/mixed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "lib/schemes/blend.hpp"
#include "lib/schemes/blocks.hpp"
#include "lib/schemes/tensors.hpp"

namespace plumb {

template <int d>
Mixed<d>::Mixed(Specimen<d> specimen, MixedOptions options, const Actions<d>& actions, double damping,
                std::vector<RigidWall<d>> walls, const std::optional<Surface<d>>& surface)
    : specimen_(std::move(specimen)), options_(std::move(options)) {
  const Elastic elastic = in_dimension(d, specimen_.elastic, specimen_.law.plane);
  law_ = block_law<d>(specimen_.law, specimen_.elastic, options_.evolves_HJ());
  bonds_ = make_mixed_bonds<d>(specimen_.cloud, options_, elastic.density, surface);
  const Slots& all = bonds_.table.slots;
  outside_ = OutsideForces<d>(actions, specimen_.cloud, all, {specimen_.elastic.density, damping});
  volume_.assign(static_cast<std::size_t>(all.count()), 0.0);
  for (Index p = 0; p < cloud().size(); ++p) volume_[all.of(p)] = cloud().V[p];
  loaded_ = actions.has_loads() || !walls.empty();
  if (options_.diffuses_J) sigma_ = make_field(1);
  if (options_.projects) turned_.resize(cloud().X.size());
  if (!walls.empty()) meet(std::move(walls));
  shear_speed_ = elastic.shear_wave_speed();
  pressure_speed_ = elastic.wave_speed();
  F_ = make_field(d * d);
  P_ = make_field(d * d);
  G_ = make_field(d * d);
  stretch_ = make_field(1);
  before_ = make_state();
  rate_ = make_state();
}

/// Slots without a particle are of a body that no wall knows.
template <int d>
void Mixed<d>::meet(std::vector<RigidWall<d>> walls) {
  const auto count = static_cast<std::size_t>(slots());
  x_.assign(count, Vec<d>::Zero());
  std::vector<double> mass(count, std::numeric_limits<double>::infinity());
  std::vector<int> body(count, 1);
  for (Index p = 0; p < cloud().size(); ++p) {
    const Index i = bonds_.table.slots.of(p);
    x_[i] = cloud().X[p];
    mass[i] = specimen_.elastic.density * cloud().V[p];
    body[i] = 0;
  }
  for (RigidWall<d>& wall : walls) wall.body = 0;
  Contact<d> contact(std::move(walls), x_, std::move(mass), cloud().spacing / 2);
  contact.meet(std::move(body), std::numeric_limits<double>::infinity());
  outside_.touch(std::move(contact));
}

template <int d>
typename Mixed<d>::Arm Mixed<d>::arm_of(int stage, double dt, const State& now) const {
  if (!options_.projects) return {};
  const auto at = [](const Field& field, Index i) { return vector_at<d>(field, i); };
  if (stage == 0) return [&now, at, dt](Index i) -> Vec<d> { return at(now.u, i) - dt * at(now.v, i); };
  if (stage == 1)
    return [this, &now, at, dt](Index i) -> Vec<d> {
      return at(before_.u, i) + dt / 6 * (at(now.v, i) - at(before_.v, i));
    };
  return [this, &now, at, dt](Index i) -> Vec<d> {
    return 1.0 / 3 * at(before_.u, i) + 2.0 / 3 * (at(now.u, i) + dt * at(now.v, i));
  };
}

template <int d>
std::vector<std::string> Mixed<d>::warnings() const {
  std::vector<std::string> found = options_.warnings();
  if (options_.diffuses_J && loaded_)
    found.emplace_back(
        "diffuses_J with loads or walls: its only state of rest has one Sigma_J everywhere, so that no body can bear a load at rest");
  // neighbours on a lattice: integer vectors within the list
  const int reach = static_cast<int>(options_.list);
  Index lattice = 0;
  for (int n = 0, all = static_cast<int>(std::pow(2 * reach + 1, d)); n < all; ++n) {
    double square = 0;
    for (int k = 0, rest = n; k < d; ++k, rest /= 2 * reach + 1)
      square += std::pow(rest % (2 * reach + 1) - reach, 2);
    lattice += square > 0 && square < options_.list * options_.list;
  }
  // half as many again: layers that are 1.5 times as dense. Clouds of even layers have fewer
  if (const Index most = bonds_.table.most_neighbours; 2 * most > 3 * lattice)
    found.push_back(fmt::format(
        "one search radius for a graded cloud: particles have up to {} neighbours, {:.3g} in the mean, where a lattice has {}; "
        "where they are dense the upwinding hardly sees alternating motion, and large strains end early: use even layers",
        most, static_cast<double>(bonds_.table.pairs) / static_cast<double>(cloud().size()), lattice));
  return found;
}

template <int d>
MixedState<d> Mixed<d>::make_state() const {
  State state;
  state.v = make_field(d);
  state.u = make_field(d);
  if (options_.evolves_F()) state.F = make_field(d * d);
  if (options_.evolves_HJ()) {
    state.H = make_field(9);
    state.J = make_field(1);
  }
  if (options_.upwind != "none") state.heat = make_field(1);
  if (options_.option > 0) {
    state.chi = make_field(d);
    state.F_chi = make_field(d * d);
  }
  if (law_.history_components > 0) state.history = make_field(law_.history_components);
  return state;
}

template <int d>
MixedState<d> Mixed<d>::start(const InitialMotion<d>& motion) {
  State state = make_state();
  const Slots& all = bonds_.table.slots;
  for (std::size_t p = 0; p < motion.u.size(); ++p) set_vector<d>(state.u, all.of(p), motion.u[p]);
  for (std::size_t p = 0; p < motion.v.size(); ++p) set_vector<d>(state.v, all.of(p), motion.v[p]);
  outside_.start(state.u, state.v);
  for (Index i = 0; i < slots() && options_.option > 0; ++i)
    for (int a = 0; a < d; ++a) state.F_chi[a * (d + 1)][i] = 1;
  if (law_.history_components > 0) start_history<d>(specimen_.law, state, slots());
  if (!options_.evolves_F()) return state;
  follow_reference(state);
  gradients_of_positions(bonds_.table, state.u, state.F);
  if (options_.evolves_HJ()) tie(state.F, state.H, state.J, slots(), d);
  return state;
}

template <int d>
void Mixed<d>::follow_reference(const State& state) {
  if (options_.option == 0) return;
  if (same_values(state.chi, seen_chi_, slots()) && same_values(state.F_chi, seen_F_, slots())) return;
  update_reference<d>(bonds_, options_, volume_, state.chi, state.F_chi, specimen_.elastic.density);
  seen_chi_ = state.chi;
  seen_F_ = state.F_chi;
}

template <int d>
const Field& Mixed<d>::gradients(const State& state) {
  if (options_.evolves_F()) return state.F;
  gradients_of_positions(bonds_.table, state.u, F_);
  return F_;
}

template <int d>
double Mixed<d>::step_limit(const State& state) {
  follow_reference(state);
  const Field& F = gradients(state);
  const double by_waves =
      options_.cfl * crossing_time_of(bonds_.table, state.u, F, stretch_) / pressure_speed_;
  return outside_.contact().empty() ? by_waves : std::min(by_waves, outside_.contact().step_limit());
}

template <int d>
std::optional<Trouble> Mixed<d>::advance(State& state, double dt) {
  follow_reference(state);
  const double time = state.time;
  const OutsideWork work = state.outside;
  const Field v = outside_.damps() ? state.v : Field();
  const auto give_back = [&] {
    if (outside_.damps()) state.v = v;
    state.outside = work;
  };
  outside_.begin_step(dt, state.v, state.outside);
  int stage = 0;
  auto trouble = ssp_rk3_step(state, before_, rate_, slots(), dt,
                              [&](const State& now, double t, State& rate) -> std::optional<Trouble> {
                                const Arm arm = arm_of(stage, dt, now);
                                if (auto wrong = evaluate(now, t, rate, arm)) return wrong;
                                const double weight = ssp_rk3_weights[static_cast<std::size_t>(stage++)];
                                outside_.hold(t, weight * dt, now.v, rate.v, rate.u);
                                return std::nullopt;
                              });
  if (!trouble) {
    outside_.end_step(state.time, dt, state.u, state.v, state.outside);
    trouble = end_of_step(state);
    if (!trouble) return trouble;
    copy_evolving(before_, state);
    state.time = time;
    --state.step;
  }
  give_back();
  return trouble;
}

/// What belongs to whole steps: history and reference.
template <int d>
std::optional<Trouble> Mixed<d>::end_of_step(State& state) {
  const bool updates = options_.option > 0 && state.step % options_.update_every == 0;
  if (!updates && !law_.commit) return std::nullopt;
  const Field& F = gradients(state);
  if (auto trouble = find_trouble(state, F)) return trouble;
  if (law_.commit)
    for_blocks(bonds_.table, [&](const Block& block) { law_.commit(state, F, block.begin(), block.end()); });
  if (!updates) return std::nullopt;
  if (options_.evolves_HJ()) tie(state.F, state.H, state.J, slots(), d);
  state.chi = state.u;
  state.F_chi = F;
  return std::nullopt;
}

template <int d>
std::optional<Trouble> Mixed<d>::find_trouble(const State& state, const Field& F) const {
  for (Index p = 0; p < cloud().size(); ++p) {
    const Index i = bonds_.table.slots.of(p);
    Mat<d> at;
    for (int n = 0; n < d * d; ++n) at(n / d, n % d) = F[n][i];
    if (const double J = determinant<d, double>(at); !(J > 0)) return Trouble{p, "determinant of F", J};
    if (options_.evolves_HJ() && !(state.J[0][i] > 0)) return Trouble{p, "J", state.J[0][i]};
  }
  return std::nullopt;
}

template <int d>
Snapshot<d> Mixed<d>::snapshot(const State& state) {
  follow_reference(state);
  const Field& F = gradients(state);
  Snapshot<d> shown;
  shown.time = state.time;
  shown.step = state.step;
  shown.X = cloud().X;
  const bool heat = state.heat.components() > 0;
  if (heat) shown.more.push_back({"heat", "J/m^3", {}});
  for (const HistoryValue& value : law_.history)
    if (!value.tensor) shown.more.push_back({value.name, value.unit, {}});
  for (Index p = 0; p < cloud().size(); ++p) {
    const Index i = bonds_.table.slots.of(p);
    const WholePoint point = law_.whole(state, F, i);
    const double J = point.F.determinant();
    shown.u.push_back(vector_at<d>(state.u, i));
    shown.x.push_back(cloud().X[p] + shown.u.back());
    shown.v.push_back(vector_at<d>(state.v, i));
    shown.mass.push_back(specimen_.elastic.density * cloud().V[p]);
    shown.volume.push_back(J * cloud().V[p]);
    shown.F.push_back(point.F);
    shown.cauchy.push_back(point.P * point.F.transpose() / J);
    std::size_t n = 0;
    if (heat) shown.more[n++].values.push_back(state.heat[0][i]);
    for (const HistoryValue& value : law_.history)
      if (!value.tensor) shown.more[n++].values.push_back(state.history[value.first][i]);
  }
  return shown;
}

template <int d>
Energy Mixed<d>::energy(const State& state) {
  follow_reference(state);
  const Field& F = gradients(state);
  Energy energy;
  const auto total = [&](const Field& density, int component) {  // in the order of the slots
    double sum = 0;
    for (Index i = 0; i < slots(); ++i) sum += volume_[i] * density[component][i];
    return sum;
  };
  std::vector<std::array<double, 2>> parts(static_cast<std::size_t>(block_count(bonds_.table)));
  for_blocks(bonds_.table, [&](const Block& block) {
    auto& [kinetic, strain] = parts[static_cast<std::size_t>(block.begin() / block_slots)];
    kinetic = 0;
    for (Index i = block.begin(); i < block.end(); ++i)
      kinetic += volume_[i] * vector_at<d>(state.v, i).squaredNorm();
    strain = law_.energy(state, F, volume_.data(), block.begin(), block.end());
  });
  for (const auto& [kinetic, strain] : parts) {
    energy.kinetic += 0.5 * specimen_.elastic.density * kinetic;
    energy.strain += strain;
  }
  if (law_.plastic_work) energy.more.push_back({"plastic work", total(state.history, *law_.plastic_work)});
  if (state.heat.components() > 0) energy.dissipated = total(state.heat, 0);
  return energy;
}

template <int d>
std::vector<Statement> Mixed<d>::account() const {
  std::vector<Statement> said;
  said.push_back({"scheme", "the system of paper 003: " + options_.in_words(), "003 (53) to (57)"});
  said.push_back({"bonds",
                  fmt::format("each particle has at most {} neighbours; its constants serve F and the force",
                              bonds_.table.most_neighbours),
                  options_.gradient == "compatible" ? "THEORY (11.4)" : "003 (41), (42)"});
  if (options_.upwind != "none")
    said.push_back({"upwinding",
                    options_.upwind == "adjoint"
                        ? "pairs dissipate by the form R^T S R, which keeps both momenta"
                        : "pairs dissipate; angular momentum is not kept",
                    "003 (59), (60)"});
  if (options_.projects)
    said.push_back(
        {"projection", "internal forces lose their torque by the least change", "003 (64) to (67)"});
  if (options_.option > 0)
    said.push_back(
        {"reference", fmt::format("moves every {} steps", options_.update_every), "003 (49) to (52)"});
  return said;
}

template class Mixed<1>;
template class Mixed<2>;
template class Mixed<3>;

}  // namespace plumb
