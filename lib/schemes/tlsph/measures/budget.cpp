#include "lib/schemes/tlsph/measures/budget.hpp"

#include <Eigen/Geometry>  // cross
#include <algorithm>
#include <cmath>

#include "lib/core/error.hpp"
#include "lib/core/in_space.hpp"
#include "lib/schemes/tlsph/loops/step_weights.hpp"
#include "lib/schemes/tlsph/loops/sweeps.hpp"
#include "lib/schemes/tlsph/measures/solid_measures.hpp"

namespace plumb {
namespace {

/// Power of the stress on the rate of the deformation gradient, sum V P : F(v), of one block [W].
template <int d, int W>
double stress_power(const Solid<d>& solid, const StressWindow& P, const Block& block, const State<d>& state) {
  Pack<W> sum(0);
  for (Index pack = block.first_pack; pack < block.end_pack; ++pack) {
    Mat<d, Pack<W>> F = deformation_gradient<d, W>(solid.bonds, state.v, pack);
    if (solid.bonds.mirror)
      add_image_gradient<d, W>(*solid.bonds.mirror, solid.bonds.row[pack], state.v, pack, F);
    const double* identity = solid.bonds.identity.data() + solid.bonds.row[pack] * Index{d * d * W};
    const Index place = P.place(pack * W);
    Pack<W> power(0);
    for (int n = 0; n < d * d; ++n)
      power += Pack<W>::load(P[n] + place) * (F(n / d, n % d) - Pack<W>::load(identity + Index{n} * W));
    sum += power * Pack<W>::load(solid.volume.data() + pack * W);
  }
  double total = 0;
  for (int lane = 0; lane < W; ++lane) total += sum[lane];
  return total;
}

/// sum V v . f of one block [W].
template <int d>
double force_power(const Solid<d>& solid, const Block& block, const State<d>& state, BlockForce<d>& force) {
  double power = 0;
  for (int k = 0; k < d; ++k)
    for (Index i = block.begin(); i < block.end(); ++i)
      power += solid.volume[i] * state.v[k][i] * force(k, i);
  return power;
}

/// The particle at a slot that has one.
template <int d>
Index particle_of(const Solid<d>& solid, Index slot) {
  const Slots& slots = solid.bonds.slots;
  return slots.line == 0 ? slot : slot / slots.stride * slots.line + slot % slots.stride;
}

/// Strain energy and that of the terms [J].
template <int d>
double potential_energy(const Solid<d>& solid, const State<d>& state) {
  const Energy energy = energy_of(solid, state);
  return energy.strain + energy.elsewhere();
}

}  // namespace

/// What the probes and the budget share.
template <int d>
struct Budget<d>::Account {
  StepWeights weights;
  std::vector<char> has_energy;  ///< per force: it belongs to a potential energy
  std::vector<std::pair<std::size_t, std::pair<Index, int>>>
      held;                       ///< part, and slot and component that it holds
  std::size_t last_internal = 0;  ///< the force after which all of the internal force is there
  /// Per force, the sum of it and of those before it, times the weights [N/m^d]: of this step so far, and of
  /// its last evaluation.
  std::vector<Field> impulse, last;
  /// Per block, power of internal force and stress together, times the weights [W]; likewise.
  std::vector<double> defect, last_defect;
  std::vector<double> power;  ///< per block, of the stress alone, at this evaluation [W]
  State<d> before;
  double potential_before;  ///< [J]

  void add_defect(const Block& block, double power_of_force) {
    const Index b = block.begin() / block_slots;
    last_defect[b] = weights.of(block) * (power[b] + power_of_force);
    defect[b] += last_defect[b];
  }
  void add_force(std::size_t part, const Block& block, BlockForce<d>& force) {
    const double weight = weights.of(block);
    for (int k = 0; k < d; ++k)
      for (Index i = block.begin(); i < block.end(); ++i) {
        last[part][k][i] = weight * force(k, i);
        impulse[part][k][i] += last[part][k][i];
      }
  }
  void start_step(const Solid<d>& solid, const State<d>& state) {
    weights.start_step();
    for (std::size_t part = 0; part < impulse.size(); ++part)
      impulse[part] = weights.carries() ? last[part] : solid.make_field(d);
    defect = weights.carries() ? last_defect : std::vector<double>(defect.size(), 0.0);
    before = state;
    potential_before = potential_energy(solid, state);
  }
};

namespace {

/// A term that adds nothing: it reads the force as the terms before it have left it.
template <int d, class Account>
Term<d> probe(const std::shared_ptr<Account>& account, std::size_t part) {
  Term<d> term;
  term.name = "budget";
  term.bytes = account->impulse[part].bytes() + account->last[part].bytes();
  term.second = [account, part](const Solid<d>& solid, const Block& block, const Instant<d>& now,
                                BlockForce<d>& force) {
    if (part == 0) account->weights.count(block);
    account->add_force(part, block, force);
    if (part == account->last_internal)
      account->add_defect(block, force_power(solid, block, now.state, force));
  };
  return term;
}

}  // namespace

template <int d>
Budget<d>::Budget(Solid<d>& solid, const State<d>& state, const std::vector<double>& weights)
    : account_(std::make_shared<Account>()) {
  if (weights.empty())
    throw InputError("the integrator has no budget", "it does not say how it weighs the forces of a step",
                     "use rk3 or verlet, or leave out budget");
  account_->weights = StepWeights(weights, solid.blocks());
  account_->defect.assign(solid.blocks(), 0.0);
  account_->last_defect = account_->power = account_->defect;
  std::vector<Term<d>> terms;
  const auto add_probe = [&](const std::string& name, bool energy) {
    account_->impulse.push_back(solid.make_field(d));
    account_->last.push_back(solid.make_field(d));
    account_->has_energy.push_back(energy);
    terms.push_back(probe<d>(account_, step_.parts.size()));
    step_.parts.push_back({name});
  };
  add_probe("internal force", true);
  for (auto& term : solid.terms) {
    const std::string name = term.name;
    const bool energy = term.energy || term.internal;
    if (term.internal) account_->last_internal = step_.parts.size();
    for (const auto& place : term.held) account_->held.push_back({step_.parts.size(), place});
    terms.push_back(std::move(term));
    add_probe(name, energy);
  }
  Term<d> power;  // the last one, so that the terms have added to the stress
  power.name = "budget";
  power.stress = [account = account_](const Solid<d>& body, const Block& block, const Instant<d>& now,
                                      StressWindow& P) {
    const double sum = body.bonds.width == 1 ? stress_power<d, 1>(body, P, block, now.state)
                                             : stress_power<d, native_width>(body, P, block, now.state);
    account->power[block.begin() / block_slots] = sum;
  };
  terms.push_back(std::move(power));
  solid.terms = std::move(terms);
  step_.parts.push_back({"integrator"});
  total_ = step_;
  account_->start_step(solid, state);
}

template <int d>
void Budget<d>::close_step(const Solid<d>& solid, const State<d>& state) {
  const Account& a = *account_;
  const double dt = state.time - a.before.time;
  const std::size_t forces = a.impulse.size();
  for (auto& part : step_.parts) part = {part.name};
  BudgetPart& integrator = step_.parts.back();
  StateChange moved;
  for (Index p = 0; p < solid.cloud.size(); ++p) {
    const Index i = solid.bonds.slots.of(p);
    const double m = solid.elastic.density * solid.cloud.V[p];
    const Vec<3> v0 = in_space<d>(vector_at<d>(a.before.v, i)), v1 = in_space<d>(vector_at<d>(state.v, i));
    const Vec<3> x0 = in_space<d>(position_of(solid, a.before, p)),
                 x1 = in_space<d>(position_of(solid, state, p));
    const Vec<3> v = 0.5 * (v0 + v1), x = 0.5 * (x0 + x1);
    Vec<3> so_far = Vec<3>::Zero();
    for (std::size_t k = 0; k < forces; ++k) {
      const Vec<3> sum = in_space<d>(vector_at<d>(a.impulse[k], i));
      const Vec<3> impulse = dt * solid.cloud.V[p] * (sum - so_far);
      so_far = sum;
      push(impulse, x, step_.parts[k]);
      step_.parts[k].energy += v.dot(impulse);
    }
    integrator.angular += m * (x1 - x0).cross(v);
    moved.add(m, x0, x1, v0, v1, v);
  }
  // supports set velocities at the end of the step: what no force has done is theirs
  for (const auto& [part, place] : a.held) {
    const auto [i, k] = place;
    const double v0 = a.before.v[k][i], v1 = state.v[k][i];
    const double rest = solid.volume[i] * (solid.elastic.density * (v1 - v0) - dt * a.impulse.back()[k][i]);
    if (rest == 0) continue;
    const Index p = particle_of(solid, i);
    const Vec<3> x =
        in_space<d>(Vec<d>(0.5 * (position_of(solid, a.before, p) + position_of(solid, state, p))));
    const Vec<3> impulse = rest * Vec<3>::Unit(k);
    push(impulse, x, step_.parts[part]);
    step_.parts[part].energy += 0.5 * (v0 + v1) * rest;
  }
  set_gaps(sum_of(step_.parts), moved, step_);

  // the work of forces that have a potential goes into it; what is left is the integrator's
  double conserved = potential_energy(solid, state) - a.potential_before;
  for (std::size_t k = 0; k < forces; ++k) {
    if (!a.has_energy[k]) continue;
    conserved += step_.parts[k].energy;
    step_.parts[k].energy = 0;
  }
  for (const double defect : a.defect) step_.parts.front().energy += dt * defect;
  integrator.energy = conserved - step_.parts.front().energy;

  add_step(step_, total_);
  account_->start_step(solid, state);
}

template class Budget<1>;
template class Budget<2>;
template class Budget<3>;

}  // namespace plumb
