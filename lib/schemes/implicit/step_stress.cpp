#include "lib/schemes/implicit/step_stress.hpp"

#include "lib/core/error.hpp"
#include "lib/material/laws.hpp"
#include "lib/material/tangent.hpp"

namespace plumb {
namespace {

template <int d>
Mat<d> symmetric_part(const Mat<d>& A) {
  return 0.5 * (A + A.transpose());
}

/// What (15.13) is made of at one point.
template <int d>
struct Step {
  Mat<d> inverse, P;  ///< of the middle
  Mat<d> after;       ///< F_1
  Mat<d> S;           ///< S_m
  Mat<d> change;      ///< C_1 - C_0
  double bracket;     ///< over |C_1 - C_0|^2
  bool corrected;     ///< C_1 - C_0 is something
};

template <int d>
Step<d> step_at(const PointLaw<d>& law, const Mat<d>& before, const Mat<d>& middle) {
  Step<d> step;
  step.inverse = middle.inverse();
  step.P = law.first_piola(middle);
  step.after = 2 * middle - before;
  step.S = symmetric_part<d>(step.inverse * step.P);
  step.change = change_of_stretch<d>(before, middle);
  const double size = step.change.squaredNorm();
  step.corrected = size > no_change * no_change;
  step.bracket =
      step.corrected
          ? (2 * (law.energy(step.after) - law.energy(before)) - step.S.cwiseProduct(step.change).sum()) /
                size
          : 0;
  return step;
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
Mat<d> change_of_stretch(const Mat<d>& before, const Mat<d>& middle) {
  const Mat<d> after = 2 * middle - before;
  return after.transpose() * after - before.transpose() * before;
}

template <int d>
Mat<d> stress_of_step(const PointLaw<d>& law, const Mat<d>& before, const Mat<d>& middle) {
  const Step<d> step = step_at<d>(law, before, middle);
  return middle * (step.S + step.bracket * step.change);
}

template <int d>
Mat<d * d> tangent_of_step(const PointLaw<d>& law, const Mat<d>& before, const Mat<d>& middle) {
  const Step<d> step = step_at<d>(law, before, middle);
  const Mat<d> S = step.S + step.bracket * step.change;
  const Mat<d* d> of_middle = law.tangent(middle);
  const Mat<d> P_after = step.corrected ? law.first_piola(step.after) : Mat<d>::Zero();
  Mat<d * d> made;
  for (int n = 0; n < d * d; ++n) {
    Mat<d> dF = Mat<d>::Zero(), dP;
    dF(n / d, n % d) = 1;
    for (int m = 0; m < d * d; ++m) dP(m / d, m % d) = of_middle(m, n);
    Mat<d> dS = symmetric_part<d>(step.inverse * (dP - dF * step.inverse * step.P));
    if (step.corrected) {
      const Mat<d> d_change = 4 * symmetric_part<d>(dF.transpose() * step.after);  // F_1 moves by 2 dF
      const double d_bracket = (4 * P_after(n / d, n % d) - dS.cwiseProduct(step.change).sum() -
                                (step.S + 2 * step.bracket * step.change).cwiseProduct(d_change).sum()) /
                               step.change.squaredNorm();
      dS += d_bracket * step.change + step.bracket * d_change;
    }
    const Mat<d> column = dF * S + middle * dS;
    for (int m = 0; m < d * d; ++m) made(m, n) = column(m / d, m % d);
  }
  return made;
}

#define PLUMBLINE_INSTANTIATE(d)                                                                     \
  template PointLaw<d> objective_law<d>(const LawChoice& law, const Elastic& elastic);               \
  template Mat<d> change_of_stretch<d>(const Mat<d>& before, const Mat<d>& middle);                  \
  template Mat<d> stress_of_step<d>(const PointLaw<d>&, const Mat<d>& before, const Mat<d>& middle); \
  template Mat<d * d> tangent_of_step<d>(const PointLaw<d>&, const Mat<d>& before, const Mat<d>& middle);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
