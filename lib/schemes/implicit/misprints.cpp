#include "lib/schemes/implicit/misprints.hpp"

#include <memory>

#include "lib/material/material.hpp"

namespace plumb {
namespace {

/// J_FF : dF for dF = e_a (x) e_A, the change of the cofactor, of which the second part is of second order.
template <int d>
Mat<d> change_of_cofactor(const Mat<d>& F, int a, int A) {
  Mat<d> dF = Mat<d>::Zero();
  dF(a, A) = 1;
  if constexpr (d == 1)
    return Mat<d>::Zero();
  else if constexpr (d == 2)
    return cofactor<d, double>(dF);
  else
    return cofactor<d, double>(Mat<d>(F + dF)) - cofactor<d, double>(F) - cofactor<d, double>(dF);
}

/// (61) as it is printed: the tangent plus mu/J J_FF.
template <int d>
Tangent<d> printed_tangent(const Mat<d>& F, Tangent<d> tangent, double mu) {
  const double over_J = mu / determinant<d, double>(F);
  for (int k = 0; k < d * d; ++k) {
    const Mat<d> change = change_of_cofactor<d>(F, k / d, k % d);
    for (int m = 0; m < d * d; ++m) tangent(m, k) += over_J * change(m / d, m % d);
  }
  return tangent;
}

}  // namespace

template <int d>
StoredEnergy<d> with_misprints(StoredEnergy<d> energy, const ImplicitOptions& options) {
  if (options.misprinted("27"))
    energy.residual = [residual = energy.residual, operators = energy.operators](const Eigen::VectorXd& u) {
      auto r = residual(u);
      const Eigen::VectorXd without_stress = Eigen::VectorXd::Zero(operators->identity.size());
      if (r) *r -= 2 * operators->forces(without_stress, u);  // it has them once with the other sign
      return r;
    };
  if (options.misprinted("29")) {
    auto halved = std::make_shared<EnergyOperators<d>>(*energy.operators);
    halved->half_of_terms *= 0.5;
    energy.operators = std::move(halved);
  }
  if (options.misprinted("61"))
    energy.tangent = [tangent = energy.tangent, mu = energy.elastic.shear_modulus()](const Mat<d>& F,
                                                                                     Index place) {
      return printed_tangent<d>(F, tangent(F, place), mu);
    };
  return energy;
}

#define PLUMBLINE_INSTANTIATE(d) \
  template StoredEnergy<d> with_misprints<d>(StoredEnergy<d>, const ImplicitOptions&);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
