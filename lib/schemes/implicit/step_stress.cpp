#include "lib/schemes/implicit/step_stress.hpp"

#include <gsl/gsl_integration.h>

#include <Eigen/Cholesky>
#include <vector>

#include "lib/core/error.hpp"
#include "lib/material/laws.hpp"
#include "lib/material/tangent.hpp"

namespace plumb {
namespace {

template <int d>
Mat<d> symmetric_part(const Mat<d>& A) {
  return 0.5 * (A + A.transpose());
}

template <int d>
Vec<d * d> as_column(const Mat<d>& A) {
  Vec<d * d> column;
  for (int n = 0; n < d * d; ++n) column[n] = A(n / d, n % d);
  return column;
}

template <int d>
Mat<d> as_tensor(const Vec<d * d>& column) {
  Mat<d> A;
  for (int n = 0; n < d * d; ++n) A(n / d, n % d) = column[n];
  return A;
}

/// A deformation gradient whose C is given. The law does not feel which of them it is: the triangular one.
template <int d>
Mat<d> gradient_of_stretch(const Mat<d>& C) {
  return Eigen::LLT<Mat<d>>(C).matrixU();
}

/// Points and weights of Gauss on [0, 1].
struct Gauss {
  std::vector<double> at, weight;
  explicit Gauss(std::size_t points) : at(points), weight(points) {
    gsl_integration_glfixed_table* table = gsl_integration_glfixed_table_alloc(points);
    for (std::size_t k = 0; k < points; ++k)
      gsl_integration_glfixed_point(0, 1, k, &at[k], &weight[k], table);
    gsl_integration_glfixed_table_free(table);
  }
};

/// n points leave (n!)^4 / ((2n + 1) (2n)!^2) |M|^(2n) of a law whose derivatives grow as those of 1/C, M = C_1 - C_0: 2e-21 of four at
/// |M| = 0.01, 1e-18 of ten at 0.5 and 1e-12 at 1.
const Gauss& gauss_for(double change) {
  static const Gauss few(4), many(10);
  return change <= 0.01 ? few : many;
}

/// The way of C through a step.
template <int d>
struct Way {
  Mat<d> before;  ///< C_0
  Mat<d> change;  ///< C_1 - C_0
  const Gauss& gauss;
  Way(const Mat<d>& F0, const Mat<d>& F1)
      : before(F0.transpose() * F0), change(F1.transpose() * F1 - before), gauss(gauss_for(change.norm())) {}
  Mat<d> at(std::size_t k) const { return before + gauss.at[k] * change; }
};

/// The law at one C: what S = F^-1 P needs, F being any deformation gradient with that C.
template <int d>
struct Stretched {
  Mat<d> F, inverse, S;

  Stretched(const PointLaw<d>& law, const Mat<d>& C)
      : F(gradient_of_stretch<d>(C)),
        inverse(F.inverse()),
        S(symmetric_part<d>(inverse * law.first_piola(F))) {}
  /// How S moves with C.
  Mat<d> moved(const Mat<d * d>& tangent, const Mat<d>& dC) const {
    const Mat<d> dF = 0.5 * inverse.transpose() * dC;
    return symmetric_part<d>(inverse * (as_tensor<d>(tangent * as_column<d>(dF)) - dF * S));
  }
};

/// dP/dF_m where F_m moved by D moves the end of the way of C by 2 (D^T G + G^T D).
template <int d>
Mat<d * d> tangent_with(const PointLaw<d>& law, const Way<d>& way, const Mat<d>& middle, const Mat<d>& G) {
  Mat<d* d> made = Mat<d * d>::Zero();
  for (std::size_t k = 0; k < way.gauss.at.size(); ++k) {
    const Stretched<d> here(law, way.at(k));
    const Mat<d* d> tangent = law.tangent(here.F);
    for (int n = 0; n < d * d; ++n) {
      Mat<d> D = Mat<d>::Zero();
      D(n / d, n % d) = 1;
      const Mat<d> dS = here.moved(tangent, 4 * way.gauss.at[k] * symmetric_part<d>(D.transpose() * G));
      made.col(n) += way.gauss.weight[k] * as_column<d>(D * here.S + middle * dS);
    }
  }
  return made;
}

}  // namespace

template <int d>
PointLaw<d> objective_law(const LawChoice& choice, const Elastic& elastic) {
  PointLaw<d> made;
  with_elastic_law<d>(choice, elastic, [&]<class M>(const M& law) {
    if (choice.name == "linear-elastic")
      throw InputError("dynamics = \"energy-momentum\" with model = \"linear-elastic\"",
                       "that law feels a rotation, so that its stress has a torque",
                       "use another law, or dynamics = \"midpoint\"");
    made = {[law](const Mat<d>& F) { return law.energy(F); },
            [law](const Mat<d>& F) -> Mat<d> { return law.first_piola(F); },
            [law](const Mat<d>& F) { return tangent_of<d>(law, F); }};
  });
  return made;
}

template <int d>
Mat<d> stress_of_step(const PointLaw<d>& law, const Mat<d>& before, const Mat<d>& middle) {
  const Way<d> way(before, 2 * middle - before);
  Mat<d> S = Mat<d>::Zero();
  for (std::size_t k = 0; k < way.gauss.at.size(); ++k)
    S += way.gauss.weight[k] * Stretched<d>(law, way.at(k)).S;
  return middle * S;
}

template <int d>
Mat<d * d> tangent_of_step(const PointLaw<d>& law, const Mat<d>& before, const Mat<d>& middle) {
  const Mat<d> after = 2 * middle - before;
  return tangent_with<d>(law, Way<d>(before, after), middle, after);
}

template <int d>
Mat<d * d> symmetric_tangent_of_step(const PointLaw<d>& law, const Mat<d>& before, const Mat<d>& middle) {
  return tangent_with<d>(law, Way<d>(before, 2 * middle - before), middle, middle);
}

#define PLUMBLINE_INSTANTIATE(d)                                                                          \
  template PointLaw<d> objective_law<d>(const LawChoice& law, const Elastic& elastic);                    \
  template Mat<d> stress_of_step<d>(const PointLaw<d>&, const Mat<d>& before, const Mat<d>& middle);      \
  template Mat<d * d> tangent_of_step<d>(const PointLaw<d>&, const Mat<d>& before, const Mat<d>& middle); \
  template Mat<d * d> symmetric_tangent_of_step<d>(const PointLaw<d>&, const Mat<d>& before,              \
                                                   const Mat<d>& middle);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
