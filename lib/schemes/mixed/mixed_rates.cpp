#include "lib/schemes/blend.hpp"
#include "lib/schemes/blocks.hpp"
#include "lib/schemes/mixed/mixed.hpp"
#include "lib/schemes/mixed/smoothing.hpp"
#include "lib/schemes/mixed/upwind_constant.hpp"
#include "lib/schemes/mixed/upwind_reconstructed.hpp"
#include "lib/schemes/torque.hpp"
#include "lib/schemes/upwind_adjoint.hpp"

/// The right-hand side of (53) to (57) of paper 003, in three passes over the bonds: gradients, pairs, force.
namespace plumb {

template <int d>
template <int W>
bool Mixed<d>::kinematics_of_block(const State& state, const Block& block, State& rate) {
  using Real = Pack<W>;
  const bool spatial = options_.upwind == "adjoint", upwinds = options_.upwind != "none";
  const bool moved = options_.upwind == "reconstructed" && options_.option > 0;
  Real unsound(0);
  for (Index pack = block.first_pack; pack < block.end_pack; ++pack) {
    const Index i = pack * W;
    Mat<d, Real> F, G;
    if (options_.evolves_F()) {
      F = load_tensor<d, W>(state.F, i);
      G = velocity_gradient<d, W>(bonds_.table, state.v, pack);
      store_tensor<d, W>(G, rate.F, i);
    } else {
      if (upwinds)
        both_gradients<d, W>(bonds_.table, state.u, state.v, pack, F, G);
      else
        F = gradient_of_positions<d, W>(bonds_.table, state.u, pack);
      store_tensor<d, W>(F, F_, i);
    }
    unsound += not_positive(determinant<d, Real>(F));
    if (options_.evolves_HJ()) {
      const Mat<3, Real> whole = in_3d<d, Real>(F, Real(1)), change = in_3d<d, Real>(G, Real(0));
      store_tensor<3, W>(tensor_cross<Real>(whole, change), rate.H, i);
      double_dot<3, Real>(load_tensor<3, W>(state.H, i), change).store(rate.J[0] + i);
      unsound += not_positive(Real::load(state.J[0] + i));
    }
    if (!upwinds) continue;
    if (spatial || moved) {
      const Mat<d, Real> back = inverse_transpose<d, Real>(spatial ? F : load_tensor<d, W>(state.F_chi, i));
      G = times_transpose<d, Real>(G, back);
    }
    store_tensor<d, W>(G, G_, i);
    least_stretch<d, Real>(F).store(stretch_[0] + i);
  }
  double count = 0;
  for (int lane = 0; lane < W; ++lane) count += unsound[lane];
  return count == 0;
}

template <int d>
template <int W>
void Mixed<d>::upwind_block(const State& state, const Field& F, const Block& block, State& rate) {
  const bool adjoint = options_.upwind == "adjoint";
  const double fastest = adjoint ? most_speed_ratio * shear_speed_ : pressure_speed_;
  const UpwindSite<d> site{bonds_.table, bonds_.impedance, state.u,   state.v,
                           G_,           stretch_,         state.chi, std::min(pressure_speed_, fastest),
                           shear_speed_};
  using Real = Pack<W>;
  const auto take = [&](Index i, const Vec<d, Real>& f, const Real& power, const Mat<d, Real>& Q) {
    store_vector<d, W>(f, rate.v, i);
    power.store(rate.heat[0] + i);
    if (!adjoint) return;
    Mat<d, Real> stress = load_tensor<d, W>(P_, i);
    carry_by_stress<d, Real>(Q, inverse_transpose<d, Real>(load_tensor<d, W>(F, i)), stress);
    store_tensor<d, W>(stress, P_, i);
  };
  if (adjoint)
    upwind_sweep<d, W, AdjointJump<d, W>>(site, block, take);
  else if (options_.upwind == "reconstructed")
    upwind_sweep<d, W, ReconstructedJump<d, W>>(site, block, take);
  else
    upwind_sweep<d, W, ConstantJump<d, W>>(site, block, take);
}

template <int d>
template <int W>
void Mixed<d>::diffuse_block(const State& state, const Block& block, State& rate) const {
  using Real = Pack<W>;
  const BondTable<d>& t = bonds_.table;
  const auto spatial = [&](const Mat<3, Real>& H, const Vec<d, Real>& c) {
    Vec<d, Real> h = zero_vector<d, Real>();
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b) h[a] += H(a, b) * c[b];
    return h;
  };
  const Real scale(
      1 / (4 * specimen_.elastic.density * pressure_speed_));  // 2 rho c_p over the mean of two stretches
  for (Index pack = block.first_pack; pack < block.end_pack; ++pack) {
    const Index i = pack * W;
    const Mat<3, Real> H = load_tensor<3, W>(state.H, i);
    const Real own = Real::load(sigma_[0] + i), stretch = Real::load(stretch_[0] + i);
    Real sum(0);
    for_bonds<d, W>(t, pack, [&](std::int64_t n, Index j) {
      const Vec<d, Real> c = bond_vector<d, W>(t.stencil, n), a = bond_vector<d, W>(t.force_weights(), n);
      const Vec<d, Real> skew = c + a, h = spatial(H, c) + spatial(load_tensor<3, W>(state.H, j), a);
      const Real area = sqrt(dot<d, Real>(skew, skew) + Real(1e-200));  // 0 where a lane lacks the neighbour
      const Real both = stretch + Real::load(stretch_[0] + j);
      sum += dot<d, Real>(h, h) / area * both * (Real::load(sigma_[0] + j) - own);
    });
    (Real::load(rate.J[0] + i) + scale * sum).store(rate.J[0] + i);
  }
}

/// Acceleration by stress and pairs, and the rate of the positions.
template <int d>
template <int W>
void Mixed<d>::force_of_block(const State& state, const Block& block, State& rate) const {
  using Real = Pack<W>;
  const BondTable<d>& t = bonds_.table;
  const AlignedVector& weights = t.force_weights();
  const Real per_density(1 / specimen_.elastic.density);
  for (Index pack = block.first_pack; pack < block.end_pack; ++pack) {
    const Index i = pack * W;
    Vec<d, Real> f = options_.upwind == "none" ? zero_vector<d, Real>() : load_vector<d, W>(rate.v, i);
    const auto add = [&](Index j, const Vec<d, Real>& a) {
      for (int k = 0; k < d; ++k)
        for (int b = 0; b < d; ++b) f[k] += Real::load(P_[k * d + b] + j) * a[b];
    };
    add(i, bond_vector<d, W>(t.own_force, t.row[pack]));
    for_bonds<d, W>(t, pack, [&](std::int64_t n, Index j) { add(j, bond_vector<d, W>(weights, n)); });
    for (int k = 0; k < d; ++k) (f[k] * per_density).store(rate.v[k] + i);
    store_vector<d, W>(options_.smooth_positions ? smoothed_velocity<d, W>(bonds_, state.v, pack)
                                                 : load_vector<d, W>(state.v, i),
                       rate.u, i);
  }
}

template <int d>
std::optional<Trouble> Mixed<d>::evaluate(const State& state, double time, State& rate, const Arm& arm) {
  const BondTable<d>& t = bonds_.table;
  const Field& F = options_.evolves_F() ? state.F : F_;
  std::vector<char> sound(static_cast<std::size_t>(block_count(t)));
  with_width(t, [&]<int W>() {
    for_blocks(t, [&](const Block& block) {
      char& good = sound[static_cast<std::size_t>(block.begin() / block_slots)];
      good = kinematics_of_block<W>(state, block, rate);
      if (good) law_.stress(state, F, block.begin(), block.end(), P_);
      if (good && options_.diffuses_J) {
        law_.of_volume(state, F, block.begin(), block.end(), sigma_);
        for (Index i = block.begin(); i < block.end(); i += W)
          least_stretch<d, Pack<W>>(load_tensor<d, W>(F, i)).store(stretch_[0] + i);
      }
    });
  });
  if (std::find(sound.begin(), sound.end(), 0) != sound.end()) return find_trouble(state, F);
  with_width(t, [&]<int W>() {
    if (options_.upwind != "none")
      for_blocks(t, [&](const Block& block) { upwind_block<W>(state, F, block, rate); });
    if (options_.diffuses_J) for_blocks(t, [&](const Block& block) { diffuse_block<W>(state, block, rate); });
    for_blocks(t, [&](const Block& block) { force_of_block<W>(state, block, rate); });
  });
  if constexpr (d > 1)
    if (options_.projects) {
      const Arm here = [&state](Index i) { return vector_at<d>(state.u, i); };
      take_torque_off<d>(cloud(), t.slots, arm ? arm : here, turned_, rate.v);
    }
  outside_.add_loads(time, &F, rate.v);
  if (outside_.contact().empty()) return std::nullopt;
  for (Index p = 0; p < cloud().size(); ++p) {
    const Index i = t.slots.of(p);
    x_[i] = cloud().X[p] + vector_at<d>(state.u, i);
  }
  outside_.add_contact(time, x_, no_anchors_, rate.v);
  return std::nullopt;
}

template <int d>
std::optional<Trouble> Mixed<d>::rates(const State& state, double time, State& rate) {
  follow_reference(state);
  if (auto trouble = evaluate(state, time, rate)) return trouble;
  outside_.hold(time, 0, state.v, rate.v, rate.u);
  return std::nullopt;
}

template <int d>
std::optional<OpenAcceleration> Mixed<d>::open(const State& state, bool still) {
  follow_reference(state);
  State at = state;
  for (int k = 0; k < d && still; ++k) std::fill_n(at.v[k], slots(), 0.0);
  if (evaluate(at, state.time, rate_)) return std::nullopt;
  return OpenAcceleration{rate_.v, outside_.loads()};
}

template std::optional<Trouble> Mixed<1>::evaluate(const MixedState<1>&, double, MixedState<1>&, const Arm&);
template std::optional<Trouble> Mixed<2>::evaluate(const MixedState<2>&, double, MixedState<2>&, const Arm&);
template std::optional<Trouble> Mixed<3>::evaluate(const MixedState<3>&, double, MixedState<3>&, const Arm&);
template std::optional<Trouble> Mixed<1>::rates(const MixedState<1>&, double, MixedState<1>&);
template std::optional<Trouble> Mixed<2>::rates(const MixedState<2>&, double, MixedState<2>&);
template std::optional<Trouble> Mixed<3>::rates(const MixedState<3>&, double, MixedState<3>&);

template std::optional<OpenAcceleration> Mixed<1>::open(const MixedState<1>&, bool);
template std::optional<OpenAcceleration> Mixed<2>::open(const MixedState<2>&, bool);
template std::optional<OpenAcceleration> Mixed<3>::open(const MixedState<3>&, bool);

}  // namespace plumb
