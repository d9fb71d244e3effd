#include "lib/schemes/tlsph/parts/pair_upwind.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "lib/core/error.hpp"
#include "lib/schemes/blocks.hpp"
#include "lib/schemes/upwind_adjoint.hpp"

namespace plumb {
namespace {

/// Of one evaluation, by slot.
struct PairArrays {
  AlignedVector impedance;  ///< of the bonds
  Field gradient;           ///< l: spatial velocity gradient [1/s]
  Field stretch;            ///< least principal stretch
  Field stress;             ///< F^-T, then -Q F^-T/2 of THEORY (16.3) [Pa]
  Field pairs;              ///< sum of q [N/m^d]

  std::size_t bytes() const {
    return impedance.size() * sizeof(double) + gradient.bytes() + stretch.bytes() + stress.bytes() +
           pairs.bytes();
  }
};

template <int d, int W>
void reconstruct_pairs(const BondTable<d>& t, const State<d>& state, const Block& block, PairArrays& a) {
  using Real = Pack<W>;
  for (Index pack = block.first_pack; pack < block.end_pack; ++pack) {
    Mat<d, Real> F, G;
    both_gradients<d, W>(t, state.u, state.v, pack, F, G);
    const Mat<d, Real> push = inverse_transpose<d, Real>(F);
    store_tensor<d, W>(times_transpose<d, Real>(G, push), a.gradient, pack * W);
    store_tensor<d, W>(push, a.stress, pack * W);
    least_stretch<d, Real>(F).store(a.stretch[0] + pack * W);
  }
}

template <int d, int W>
void sweep_pairs(const Solid<d>& solid, const State<d>& state, const Block& block, PairArrays& a) {
  using Real = Pack<W>;
  const Field none;
  const UpwindSite<d> site{solid.bonds,
                           a.impedance,
                           state.u,
                           state.v,
                           a.gradient,
                           a.stretch,
                           none,
                           followed_pressure_speed(solid.elastic),
                           solid.elastic.shear_wave_speed()};
  upwind_sweep<d, W, AdjointJump<d, W>>(
      site, block, [&](Index i, const Vec<d, Real>& f, const Real&, const Mat<d, Real>& Q) {
        store_vector<d, W>(f, a.pairs, i);
        Mat<d, Real> stress = zero_tensor<d, Real>();
        carry_by_stress<d, Real>(Q, load_tensor<d, W>(a.stress, i), stress);
        store_tensor<d, W>(stress, a.stress, i);
      });
}

/// Pairs, and the transpose of the gradients in their jumps by the loop of the internal force: THEORY (16.4).
template <int d, int W>
void add_pair_forces(const BondTable<d>& t, const Block& block, const PairArrays& a, BlockForce<d>& force) {
  using Real = Pack<W>;
  const AlignedVector& weights = t.force_weights();
  for (Index pack = block.first_pack; pack < block.end_pack; ++pack) {
    const Index i = pack * W;
    Vec<d, Real> f = load_vector<d, W>(a.pairs, i);
    const auto add = [&](Index j, const Vec<d, Real>& c) {
      for (int k = 0; k < d; ++k)
        for (int b = 0; b < d; ++b) f[k] += Real::load(a.stress[k * d + b] + j) * c[b];
    };
    add(i, bond_vector<d, W>(t.own_force, t.row[pack]));
    for_bonds<d, W>(t, pack, [&](std::int64_t n, Index j) { add(j, bond_vector<d, W>(weights, n)); });
    for (int k = 0; k < d; ++k) (Real::load(force.at(k, i)) + f[k]).store(force.at(k, i));
  }
}

/// Constants of rows of their own are read three times, gradients written and read.
template <int d>
double pair_bytes_moved(const Solid<d>& solid) {
  constexpr double real = sizeof(double), offset = sizeof(std::int32_t);
  const double neighbours = static_cast<double>(solid.bonds.pairs) / static_cast<double>(solid.cloud.size());
  return real * (8 * d * d + 6 * d + 2) +
         (solid.bonds.width == 1 ? neighbours * (real * (3 * d + 1) + 3 * offset) : 0.0);
}

}  // namespace

template <int d>
Term<d> pair_upwind_term(const Solid<d>& solid) {
  if (solid.bonds.mirror)
    throw InputError("[dissipation] beside mirror images", "its pairs have no images behind a roller",
                     "use layout = \"node\", or [jst]");
  const auto arrays = std::make_shared<PairArrays>();
  arrays->impedance = pair_impedance(solid.bonds, solid.elastic.density);
  arrays->gradient = arrays->stress = solid.make_field(d * d);
  arrays->stretch = solid.make_field(1);
  arrays->pairs = solid.make_field(d);
  Term<d> term;
  term.name = "dissipation";
  term.bytes = arrays->bytes();
  term.bytes_per_update = pair_bytes_moved(solid);
  term.before = [arrays](const Solid<d>& body, const Block& block, const Instant<d>& now) {
    with_width(body.bonds, [&]<int W>() { reconstruct_pairs<d, W>(body.bonds, now.state, block, *arrays); });
  };
  term.first = [arrays](const Solid<d>& body, const Block& block, const Instant<d>& now) {
    with_width(body.bonds, [&]<int W>() { sweep_pairs<d, W>(body, now.state, block, *arrays); });
  };
  term.second = [arrays](const Solid<d>& body, const Block& block, const Instant<d>&, BlockForce<d>& force) {
    with_width(body.bonds, [&]<int W>() { add_pair_forces<d, W>(body.bonds, block, *arrays, force); });
  };
  return term;
}

template <int d>
double pair_upwind_step_limit(const Solid<d>& solid, double limit) {
  const std::vector<Term<d>> terms{pair_upwind_term(solid)};
  const Workspace<d> workspace;
  State<d> state = make_state(solid);
  const Instant<d> now{state, 0, workspace, terms};
  const auto for_each = [&](auto&& use) {
#pragma omp parallel for schedule(static) if (solid.blocks() >= blocks_for_threads)
    for (Index b = 0; b < solid.blocks(); ++b) use(solid.block(b));
  };
  Field force = solid.make_field(d);
  const auto size_of = [&](const Field& v) {
    double sum = 0;
    for (int k = 0; k < d; ++k)
      for (Index i = 0; i < solid.bonds.slots.count(); ++i) sum += solid.volume[i] * v[k][i] * v[k][i];
    return std::sqrt(sum);
  };
  // a start that holds every mode; its numbers do not matter
  for (Index i = 0; i < solid.cloud.size(); ++i)
    for (int k = 0; k < d; ++k)
      state.v[k][solid.bonds.slots.of(i)] = std::sin(12.9898 * static_cast<double>(i + 1) + 78.233 * k);
  double rate = 0;
  // 30 steps give two digits, from below
  for (int step = 0; step < 30; ++step) {
    const double before = size_of(state.v);
    for_each([&](const Block& block) { terms[0].before(solid, block, now); });
    for_each([&](const Block& block) { terms[0].first(solid, block, now); });
    for_each([&](const Block& block) {
      BlockForce<d> of_block(block);
      const Index count = block.end() - block.begin();
      for (int k = 0; k < d; ++k) std::fill_n(of_block.at(k, block.begin()), count, 0.0);
      terms[0].second(solid, block, now, of_block);
      for (int k = 0; k < d; ++k) std::copy_n(of_block.at(k, block.begin()), count, force[k] + block.begin());
    });
    const double after = size_of(force);
    rate = after / (before * solid.elastic.density);
    if (after == 0) break;
    for (int k = 0; k < d; ++k)
      for (Index i = 0; i < solid.bonds.slots.count(); ++i) state.v[k][i] = force[k][i] / after;
  }
  return rate > 0 ? limit / rate : std::numeric_limits<double>::max();
}

template Term<1> pair_upwind_term<1>(const Solid<1>&);
template Term<2> pair_upwind_term<2>(const Solid<2>&);
template Term<3> pair_upwind_term<3>(const Solid<3>&);
template double pair_upwind_step_limit<1>(const Solid<1>&, double);
template double pair_upwind_step_limit<2>(const Solid<2>&, double);
template double pair_upwind_step_limit<3>(const Solid<3>&, double);

}  // namespace plumb
