#include <utility>

#include "lib/schemes/mixed/smoothing.hpp"

/// Updates of the reference configuration: (49) to (52) of paper 003. Volumes V_chi,b = J_chi,b V_b take the
/// factors 1/J_chi,b of the kernels away, so none of them appears.
namespace plumb {
namespace {

/// One pack of a body whose reference is X + chi.
template <int d, int W>
class Update {
  using Real = Pack<W>;
  using Vector = Vec<d, Real>;
  using Tensor = Mat<d, Real>;

 public:
  Update(MixedBonds<d>& bonds, const MixedOptions& options, const Field& chi, const Field& F)
      : b_(bonds),
        t_(bonds.table),
        pulled_back_(options.option >= 3),
        mean_(options.option == 4),
        chi_(chi),
        F_(F) {}

  /// chi_b - chi_a; zero where a lane lacks the neighbour.
  Vector arm(Index pack, std::int64_t n, Index j) const {
    Vector y = bond_vector<d, W>(t_.separation, n);
    const Real there = Real(1) - not_positive(dot<d, Real>(y, y));
    for (int k = 0; k < d; ++k) y[k] += there * (Real::load(chi_[k] + j) - Real::load(chi_[k] + pack * W));
    return y;
  }

  /// (46), (47): r^ = [(F_a + F_b)/2]^-1 chi_ab, kept where the constants will stand, and h^.
  void pull_back(Index pack) {
    const Tensor own = load_tensor<d, W>(F_, pack * W);
    Real most(0);
    for_bonds<d, W>(t_, pack, [&](std::int64_t n, Index j) {
      const Vector r = transpose_times<d, Real>(inverse_transpose<d, Real>(mean(own, j)), arm(pack, n, j));
      most = -min(-most, -dot<d, Real>(r, r));
      for (int k = 0; k < d; ++k) r[k].store(t_.stencil.data() + (n * d + k) * W);
    });
    const Real volume = Real::load(b_.volume[0] + pack * W), empty = not_positive(volume);
    const Real inverse_h = (Real(1) - empty) / (Real(smoothing_factor) * sqrt(most) + empty);
    inverse_h.store(b_.inverse_h[0] + pack * W);
    Real strength = volume;
    for (int k = 0; k < d; ++k) strength *= inverse_h;
    strength.store(b_.strength[0] + pack * W);
  }

  /// (42) in the reference: M = sum V_b grad W (x) chi_ab, c_ab = F_a^T M^-1 grad W.
  void constants(Index pack) {
    const Tensor own = load_tensor<d, W>(F_, pack * W), push = inverse_transpose<d, Real>(own);
    const Real empty = not_positive(Real::load(b_.strength[0] + pack * W));
    Tensor moment = zero_tensor<d, Real>();
    for_bonds<d, W>(t_, pack, [&](std::int64_t n, Index j) {
      const Vector r = bond_vector<d, W>(pulled_back_ ? t_.stencil : t_.separation, n);
      const Real length = sqrt(dot<d, Real>(r, r) + Real(1e-200));  // 0 where a lane lacks the neighbour
      const Real slope =
          Real::load(b_.strength[0] + j) * kernel_slope<Real>(length, Real::load(b_.inverse_h[0] + j));
      const Vector g =
          times<d, Real>(mean_ ? inverse_transpose<d, Real>(mean(own, j)) : push, (slope * r).eval());
      for (int k = 0; k < d; ++k) g[k].store(t_.stencil.data() + (n * d + k) * W);
      add_outer<d, Real>(moment, g, arm(pack, n, j));
    });
    for (int k = 0; k < d; ++k) moment(k, k) += empty;
    const Tensor correction = inverse_transpose<d, Real>(moment);  // transposed
    Tensor identity = zero_tensor<d, Real>();
    Vector sum = zero_vector<d, Real>();
    for_bonds<d, W>(t_, pack, [&](std::int64_t n, Index) {
      const Vector g = bond_vector<d, W>(t_.stencil, n);
      const Vector c = transpose_times<d, Real>(own, transpose_times<d, Real>(correction, g));
      for (int k = 0; k < d; ++k) {
        c[k].store(t_.stencil.data() + (n * d + k) * W);
        sum[k] += c[k];
      }
      add_outer<d, Real>(identity, bond_vector<d, W>(t_.separation, n), c);
    });
    for (int a = 0; a < d; ++a) {
      sum[a].store(t_.own_force.data() + (pack * d + a) * W);
      identity(a, a) += empty;
      for (int b = 0; b < d; ++b) identity(a, b).store(t_.identity.data() + ((pack * d + a) * d + b) * W);
    }
  }

  /// Weights of the smoothed velocity, while r^ stands where the constants will be.
  void smoothing(Index pack) {
    const AlignedVector& seen = pulled_back_ ? t_.stencil : t_.separation;
    smoothing_of_pack<d, W>(
        b_, pack, [&](std::int64_t n, Index) { return bond_vector<d, W>(seen, n); },
        [&](std::int64_t n, Index j) { return arm(pack, n, j); });
  }

  /// rho_chi |C_chi^Skew|/(2 V_a) of (60), with V_chi g_chi = V cof(F) c.
  void impedance(Index pack, double density) {
    const Tensor own = load_tensor<d, W>(F_, pack * W), push = cofactor<d, Real>(own);
    const Real thin = Real(1) / determinant<d, Real>(own);
    for_bonds<d, W>(t_, pack, [&](std::int64_t n, Index j) {
      const Tensor other = load_tensor<d, W>(F_, j);
      const Vector skew = times<d, Real>(push, bond_vector<d, W>(t_.stencil, n)) +
                          times<d, Real>(cofactor<d, Real>(other), bond_vector<d, W>(t_.force, n));
      const Real J = determinant<d, Real>(other);  // 0 outside of the body
      const Real twice = thin + Real(1) / (J + not_positive(J));
      (Real(0.25 * density) * twice * sqrt(dot<d, Real>(skew, skew))).store(b_.impedance.data() + n * W);
    });
  }

 private:
  Tensor mean(const Tensor& own, Index j) const {
    Tensor A = load_tensor<d, W>(F_, j);
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b) A(a, b) = Real(0.5) * (A(a, b) + own(a, b));
    return A;
  }

  MixedBonds<d>& b_;
  BondTable<d>& t_;
  bool pulled_back_, mean_;
  const Field& chi_;
  const Field& F_;
};

/// a_ab = -(V_b/V_a) c_ba of the adjoint form, THEORY (5.3).
template <int d>
void adjoint_weights(MixedBonds<d>& bonds, const AlignedVector& volume, Index pack) {
  BondTable<d>& t = bonds.table;
  const Index W = t.width;
  for (std::int64_t n = t.begin[pack]; n < t.begin[pack + 1]; ++n)
    for (Index lane = 0; lane < W; ++lane) {
      const std::int64_t back = bonds.reverse[n * W + lane];
      if (back < 0) continue;
      const Index i = pack * W + lane, j = i + t.offset[n];
      const double ratio = -volume[j] / volume[i];
      for (int k = 0; k < d; ++k)
        t.force[(n * d + k) * W + lane] = ratio * t.stencil[(back / W * d + k) * W + back % W];
    }
}

}  // namespace

template <int d>
void update_reference(MixedBonds<d>& bonds, const MixedOptions& options, const AlignedVector& volume,
                      const Field& chi, const Field& F, double density) {
  const Index packs = bonds.table.slots.packs();
  const auto each = [&](auto&& use) {
#pragma omp parallel for schedule(static) if (packs > 512)
    for (Index pack = 0; pack < packs; ++pack) use(pack);
  };
  with_width(bonds.table, [&]<int W>() {
    Update<d, W> update(bonds, options, chi, F);
    if (options.option >= 3) each([&](Index pack) { update.pull_back(pack); });
    if (options.option >= 2) {
      each([&](Index pack) {
        if (options.smooth_positions) update.smoothing(pack);
        update.constants(pack);
      });
      each([&](Index pack) { adjoint_weights(bonds, volume, pack); });
    }
    if (options.upwind == "constant" || options.upwind == "reconstructed")
      each([&](Index pack) { update.impedance(pack, density); });
  });
}

template void update_reference<1>(MixedBonds<1>&, const MixedOptions&, const AlignedVector&, const Field&,
                                  const Field&, double);
template void update_reference<2>(MixedBonds<2>&, const MixedOptions&, const AlignedVector&, const Field&,
                                  const Field&, double);
template void update_reference<3>(MixedBonds<3>&, const MixedOptions&, const AlignedVector&, const Field&,
                                  const Field&, double);

}  // namespace plumb
