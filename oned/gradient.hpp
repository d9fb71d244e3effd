#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "lib/kernel/correction.hpp"
#include "lib/schemes/tlsph/bonds/estimator.hpp"
#include "oned/cloud.hpp"

namespace plumb::oned {

/// How the sum of (33) is formed. Both are the same wherever the gradients of a particle sum to zero (9a), as
/// they do for every corrected pair: those always use the difference form, which loses no digits. For the
/// pair `none` they are two estimators.
enum class Form {
  printed,    ///< sum_j V_j grad W_ij x_j, as (33) is printed: diverges at a boundary
  difference  ///< sum_j V_j grad W_ij (x_j - x_i): exact for constants everywhere
};
Form form_named(std::string_view name);

/// A way to estimate a gradient: estimator (standard, bond, improved, ..) and corrected kernel pair.
struct GradientMethod {
  std::string estimator = "improved";
  Correction pair = Correction::W1;
  Form form = Form::printed;  ///< matters for the pair `none` only
};

/// All particles of a window as seen from x, into `neighbourhood` (cleared first).
void see(const Cloud<1>& cloud, Window window, double x, std::vector<Neighbour<1>>& neighbourhood);

/// dx/dX at every particle from the values at the particles: F_i = sum_j (x_j - x_i) c_ij, with c from the
/// correction and estimator catalogues of lib/schemes/tlsph/bonds. `values` has one entry per particle. Time and memory:
/// linear in particles times neighbours, and in particles. InputError as windows() and estimator_named().
std::vector<double> estimate(const Cloud<1>& cloud, const RadialKernel<1>& kernel, double R,
                             const GradientMethod& method, const std::vector<double>& values);

/// One line of `plumb oned gradient`.
struct GradientRow {
  std::string estimator;
  Correction pair;
  std::string field;
  double X;      ///< [m]
  double exact;  ///< dx/dX
  double value;  ///< its estimate
  double error;  ///< value - exact
};

/// Every field by every method at every particle, each number held once.
struct GradientTable {
  struct Column {
    GradientMethod method;
    std::size_t field;          ///< of `fields`
    std::vector<double> value;  ///< the estimate at every particle
  };
  std::vector<double> X;                   ///< [m]
  std::vector<std::string> fields;         ///< as typed
  std::vector<std::vector<double>> exact;  ///< dx/dX of every field at every particle
  std::vector<Column> columns;             ///< field by field, the methods within

  std::size_t size() const { return columns.size() * X.size(); }
  /// Row k: column by column, the particles within.
  GradientRow row(std::size_t k) const;
};
GradientTable gradient_table(const Discretisation& discretisation, const std::vector<TestField>& fields,
                             const std::vector<GradientMethod>& methods);

/// Computes the table as rows.
std::vector<GradientRow> gradient_rows(const Discretisation& discretisation,
                                       const std::vector<TestField>& fields,
                                       const std::vector<GradientMethod>& methods);

}  // namespace plumb::oned
