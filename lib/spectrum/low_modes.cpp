#include "lib/spectrum/low_modes.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <numeric>

#include "lib/schemes/tlsph/measures/solid_measures.hpp"

namespace plumb {
namespace {

template <int d>
double unexplained_share(const LinearOperator<d>& op, const Eigen::VectorXd& motion) {
  const Solid<d>& solid = op.solid();
  const BondTable<d>& t = solid.bonds;
  State<d> state = make_state(solid);
  for (Index n = 0; n < op.size(); ++n)
    state.u[op.components()[n].axis][t.slots.of(op.components()[n].particle)] =
        motion[n] * solid.cloud.spacing;
  const State<d> rest = make_state(solid);
  std::vector<Mat<d>> H(t.slots.count(), Mat<d>::Zero());
  for (Index p = 0; p < solid.cloud.size(); ++p)
    H[t.slots.of(p)] = deformation_gradient_of(solid, state, p) - deformation_gradient_of(solid, rest, p);
  double left = 0, all = 0;
  for (Index p = 0; p < solid.cloud.size(); ++p) {
    const Index i = t.slots.of(p), row = t.row[i / t.width], lane = i % t.width;
    for (std::int64_t n = t.begin[row]; n < t.begin[row + 1]; ++n) {
      Vec<d> X;
      for (int k = 0; k < d; ++k) X[k] = t.separation[(n * d + k) * t.width + lane];
      // nearest pairs, on jittered clouds too
      if (X.norm() == 0 || X.norm() > 1.1 * solid.cloud.spacing) continue;
      const Index j = i + t.offset[n];
      const Vec<d> u = vector_at<d>(state.u, j) - vector_at<d>(state.u, i);
      left += (u - 0.5 * (H[i] + H[j]) * X).squaredNorm();
      all += u.squaredNorm();
    }
  }
  return all > 0 ? std::sqrt(left / all) : 0.0;
}

template <int d>
Mode mode_of(const LinearOperator<d>& op, std::complex<double> value, Eigen::VectorXd motion) {
  Mode mode;
  mode.value = value.real();
  mode.imaginary = value.imag();
  mode.unexplained = unexplained_share(op, motion);
  mode.kind = mode.unexplained > 0.5 ? ModeKind::spurious : ModeKind::smooth;
  mode.motion = std::move(motion);
  return mode;
}

/// Places of the pairs up to `reach`, ascending by real part.
std::vector<Index> ascending(const Eigen::VectorXcd& values, double reach) {
  std::vector<Index> order(values.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::erase_if(order, [&](Index n) { return values[n].real() > reach; });
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return values[a].real() < values[b].real(); });
  return order;
}

void count_spurious(LowModes& low, bool complete) {
  const double below = low.lowest_smooth.value_or(std::numeric_limits<double>::infinity());
  int spurious = 0, near_zero = 0;
  for (const auto& mode : low.modes) {
    if (!mode.spurious() || !(mode.value < below)) continue;
    ++spurious;
    near_zero += std::abs(mode.value) < near_zero_share * below;
  }
  low.spurious_below_smooth = {spurious, !complete};
  if (low.lowest_smooth) low.near_zero_not_rigid = Count{near_zero, !complete};
}

}  // namespace

double Mode::frequency() const {
  return std::sqrt(std::complex<double>(value, imaginary)).real() / (2 * std::numbers::pi);
}

template <int d>
LowModes low_modes(const LinearOperator<d>& op, const EigenPairs& pairs, const Eigen::VectorXd& root,
                   int wanted, double reach, bool complete) {
  LowModes low;
  for (const Index n : ascending(pairs.values, reach)) {
    if (static_cast<int>(low.modes.size()) >= wanted && low.lowest_smooth) break;
    low.modes.push_back(
        mode_of(op, pairs.values[n], root.cwiseInverse().asDiagonal() * pairs.vectors.col(n)));
    if (!low.modes.back().spurious() && !low.lowest_smooth) low.lowest_smooth = low.modes.back().value;
  }
  count_spurious(low, complete);
  return low;
}

template <int d>
std::vector<Mode> rigid_modes(const LinearOperator<d>& op, const SparseMatrix& K) {
  std::vector<Mode> modes;
  const Eigen::MatrixXd rigid = op.rigid_motions();
  for (Index n = 0; n < rigid.cols(); ++n) {
    modes.push_back(mode_of<d>(op, rigid.col(n).dot(K * rigid.col(n)), rigid.col(n)));
    modes.back().kind = ModeKind::rigid;
  }
  return modes;
}

#define PLUMB_INSTANTIATE(d)                                                                               \
  template LowModes low_modes<d>(const LinearOperator<d>&, const EigenPairs&, const Eigen::VectorXd&, int, \
                                 double, bool);                                                            \
  template std::vector<Mode> rigid_modes<d>(const LinearOperator<d>&, const SparseMatrix&);
PLUMB_INSTANTIATE(1)
PLUMB_INSTANTIATE(2)
PLUMB_INSTANTIATE(3)
#undef PLUMB_INSTANTIATE

}  // namespace plumb
