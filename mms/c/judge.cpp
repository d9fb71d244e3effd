// Norms, orders, verdicts and extrapolation in C's words.
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "lib/convergence/least_squares.hpp"
#include "lib/convergence/richardson.hpp"
#include "lib/convergence/verdict.hpp"
#include "lib/convergence/words.hpp"
#include "lib/core/error.hpp"
#include "mms/c/chosen.hpp"
#include "mms/c/guard.hpp"
#include "mms/c/values.hpp"

namespace plumb::c {
namespace {

plumb_norms norms_of(std::size_t points, std::size_t components, const double* values, const double* exact,
                     const double* weights) {
  if (points == 0 || components == 0) throw InputError("a field without numbers has no norm", "", "");
  require(values, "values");
  plumb_norms norms{0, -1, 0, none, 0};
  for (std::size_t k = 0; k < points; ++k) {
    const double weight = weights != nullptr ? weights[k] : 1.0 / static_cast<double>(points);
    if (!(weight >= 0) || !std::isfinite(weight))
      throw InputError("the weight of point " + std::to_string(k) + " is negative or not finite", "", "");
    double error = 0, size = 0;
    for (std::size_t c = 0; c < components; ++c) {
      const double right = exact != nullptr ? exact[k * components + c] : 0;
      const double off = values[k * components + c] - right;
      error += off * off;
      size += right * right;
    }
    if (!std::isfinite(error) || !std::isfinite(size))
      throw InputError("the field is not finite at point " + std::to_string(k), "a broken run has no norm",
                       "");
    norms.l2 += weight * error;
    norms.exact_l2 += weight * size;
    if (std::sqrt(error) > norms.linf) norms.linf = std::sqrt(error), norms.worst = k;
  }
  norms.l2 = std::sqrt(norms.l2);
  norms.exact_l2 = std::sqrt(norms.exact_l2);
  if (norms.exact_l2 > 0) norms.relative_l2 = norms.l2 / norms.exact_l2;
  return norms;
}

std::optional<double> optional_of(const double* value) {
  return value != nullptr ? std::optional(*value) : std::nullopt;
}

std::vector<Sample> samples_of(std::size_t grids, const double* spacings, const double* values) {
  require(spacings, "spacings");
  require(values, "values");
  std::vector<Sample> samples;
  for (std::size_t k = 0; k < grids; ++k) samples.push_back({spacings[k], values[k]});
  return samples;
}

}  // namespace
}  // namespace plumb::c

using namespace plumb;
using namespace plumb::c;

extern "C" {
plumb_status plumb_error(const plumb_solution* solution, plumb_quantity quantity, size_t points,
                         const double* X, double time, const double* values, const double* weights,
                         plumb_norms* norms) {
  return guarded([&] {
    require(solution, "solution");
    require(norms, "norms");
    const std::vector<double> exact = values_of(*solution, quantity, points, X, time);
    *norms = norms_of(points, plumb_components(solution, quantity), values, exact.data(), weights);
  });
}
plumb_status plumb_field_error(size_t points, size_t components, const double* values, const double* exact,
                               const double* weights, plumb_norms* norms) {
  return guarded([&] {
    require(norms, "norms");
    *norms = norms_of(points, components, values, exact, weights);
  });
}

plumb_status plumb_fit_order(size_t levels, const double* spacings, const double* errors, double round_off,
                             const double* declared, plumb_fit* fit, double* pairwise) {
  return guarded([&] {
    require(spacings, "spacings");
    require(errors, "errors");
    require(fit, "fit");
    if (!(round_off >= 0)) throw InputError("round_off is negative or not a number", "0 if not known", "");
    if (declared != nullptr && !std::isfinite(*declared))
      throw InputError("the declared order is not finite", "", "give NULL if none is declared");
    std::vector<Level> all;
    for (std::size_t k = 0; k < levels; ++k) all.push_back({spacings[k], errors[k]});
    FitOptions options;
    options.round_off = round_off;
    const OrderFit found = fit_order(all, options);
    const std::string_view verdict =
        declared != nullptr ? name_of(judge(found, *declared)) : name_of(classify(found));
    *fit = {found.order, found.lower,         found.upper,   std::exp(found.log_constant),
            found.drift, found.levels.size(), verdict.data()};
    if (pairwise != nullptr) std::copy(found.pairwise.begin(), found.pairwise.end(), pairwise);
  });
}
const char* plumb_meaning(const char* verdict) {
  return verdict != nullptr && !meaning_of(verdict).empty() ? meaning_of(verdict).data() : "";
}

plumb_status plumb_extrapolate(size_t grids, const double* spacings, const double* values, double safety,
                               const double* declared, plumb_extrapolation* result, double* gci,
                               double* gci_absolute) {
  return guarded([&] {
    require(result, "result");
    const Extrapolation found =
        richardson(samples_of(grids, spacings, values), safety, optional_of(declared));
    *result = {name_of(found.behaviour).data(), found.order, found.limit,
               found.asymptotic_ratio.value_or(none)};
    for (std::size_t k = 0; k + 1 < grids; ++k) {  // no index exists unless the values are monotone
      const bool there = k < found.gci.size();
      if (gci != nullptr) gci[k] = there ? found.gci[k].relative.value_or(none) : none;
      if (gci_absolute != nullptr) gci_absolute[k] = there ? found.gci[k].absolute : none;
    }
  });
}
plumb_status plumb_fit_grids(size_t grids, const double* spacings, const double* values,
                             plumb_grid_fit* result, double* uncertainties) {
  return guarded([&] {
    require(result, "result");
    const GridFit found = fit_grids(samples_of(grids, spacings, values));
    *result = {name_of(found.expansion).data(),
               found.weighted ? 1 : 0,
               found.order.value_or(none),
               found.limit,
               found.deviation,
               found.range,
               found.safety,
               found.grids.front().uncertainty};
    for (std::size_t k = 0; uncertainties != nullptr && k < found.grids.size(); ++k)
      uncertainties[k] = found.grids[k].uncertainty;
  });
}
}
