#pragma once
#include <optional>
#include <string>
#include <vector>

#include "lib/convergence/order_fit.hpp"
#include "lib/convergence/verdict.hpp"
#include "lib/output/sitting.hpp"
#include "oned/gradient.hpp"

namespace plumb::oned {

/// Norms of the error of one estimate. Interior means 2R <= X <= L - 2R: there neither the support of the
/// particle nor that of its neighbours is cut. Empty where a body is too short to have such particles.
struct GradientErrors {
  double rmse;                          ///< sqrt(mean of error^2) over all particles
  double max;                           ///< largest |error|
  std::optional<double> interior_rmse;  ///< over interior particles
  std::optional<double> interior_max;   ///< over interior particles
  std::optional<double> boundary_max;   ///< over the other particles

  template <class Self, class Visit>
  static void members(Self& self, Visit&& visit) {
    visit("rmse", self.rmse);
    visit("max", self.max);
    visit("interior_rmse", self.interior_rmse);
    visit("interior_max", self.interior_max);
    visit("boundary_max", self.boundary_max);
  }
};

/// One line of `plumb oned study`.
struct StudyRow {
  Index n;
  double dx, radius;  ///< [m]
  std::string field, estimator;
  Correction pair;
  GradientErrors norms;
  double cpu_s;  ///< CPU time of this estimate: neighbours, corrections, stencils, sums [s]
};

/// Order of one norm under refinement. The trend says what the errors do where no order can be given.
struct StudyFit {
  std::string field, estimator;
  Correction pair;
  std::string norm;  ///< "rmse", "max", "interior_rmse", "interior_max", "boundary_max"
  OrderFit fit;
  Trend trend;
};

/// Holds the errors of a refinement, with their orders.
struct RefinementStudy {
  std::vector<StudyRow> rows;
  std::vector<StudyFit> fits;
};

/// Norms of `error` (one entry per particle).
GradientErrors error_norms(const Cloud<1>& cloud, double R, const std::vector<double>& error);

/// Every field by every method on every level of `cells` (numbers of cells); `discretisation.n` is not used.
/// Everything that can be refused is refused before the first estimate. Each estimate is a part of the
/// sitting; throws SittingEnded if that ends.
RefinementStudy refine(const Discretisation& discretisation, const std::vector<Index>& cells,
                       const std::vector<TestField>& fields, const std::vector<GradientMethod>& methods,
                       Sitting& sitting);
/// Refines in one sitting.
inline RefinementStudy refine(const Discretisation& discretisation, const std::vector<Index>& cells,
                              const std::vector<TestField>& fields,
                              const std::vector<GradientMethod>& methods) {
  Sitting whole;
  return refine(discretisation, cells, fields, methods, whole);
}

}  // namespace plumb::oned
