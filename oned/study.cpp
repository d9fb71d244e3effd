#include "oned/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <nlohmann/json.hpp>
#include <set>

namespace plumb::oned {
namespace {

/// CPU time of this process [s].
double cpu_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Norm {
  const char* name;
  std::optional<double> (*get)(const GradientErrors&);
};
constexpr std::array<Norm, 5> norms = {
    {{"rmse", [](const GradientErrors& e) { return std::optional(e.rmse); }},
     {"max", [](const GradientErrors& e) { return std::optional(e.max); }},
     {"interior_rmse", [](const GradientErrors& e) { return e.interior_rmse; }},
     {"interior_max", [](const GradientErrors& e) { return e.interior_max; }},
     {"boundary_max", [](const GradientErrors& e) { return e.boundary_max; }}}};

/// A field on one level, with the size of what rounding leaves of its differences: x_j - x_i carries an error
/// of some eps |x|, and the nearest bond divides it by dx. 8 covers the sum over the support.
struct Sampled {
  std::vector<double> x, exact;
  double floor = 0;

  Sampled(const TestField& field, const Cloud<1>& cloud)
      : x(values(field, cloud.X)), exact(derivatives(field, cloud.X)) {
    for (const double value : x) floor = std::max(floor, std::abs(value));
    floor *= 8 * std::numeric_limits<double>::epsilon() / cloud.spacing;
    if (!std::holds_alternative<Formula>(field.form)) return;
    double slope = 0;
    for (const double value : exact) slope = std::max(slope, std::abs(value));
    floor += slope_accuracy * slope;
  }
};

std::vector<Discretisation> levels(const Discretisation& base, const std::vector<Index>& cells) {
  if (cells.empty())
    throw InputError("no numbers of cells", "a study needs levels", "Give --n 20,40,80,160.");
  std::set<Index> seen;
  std::vector<Discretisation> all;
  for (const Index n : cells) {
    if (!seen.insert(n).second)
      throw InputError(fmt::format("n = {} is given twice", n), "levels must differ", "Remove one of them.");
    all.push_back(base);
    all.back().n = n;
  }
  return all;
}

/// The errors of an estimate and the CPU time that it took [s].
struct TimedErrors {
  GradientErrors norms;
  double cpu_s;

  template <class Self, class Visit>
  static void members(Self& self, Visit&& visit) {
    visit("norms", self.norms);
    visit("cpu_s", self.cpu_s);
  }
};

/// The fits of one field and method from its rows.
void fit_all(const std::vector<StudyRow>& rows, const std::vector<double>& floors,
             std::vector<StudyFit>& fits) {
  for (const Norm& norm : norms) {
    std::vector<Level> points;
    for (std::size_t k = 0; k < rows.size(); ++k)
      if (const auto error = norm.get(rows[k].norms)) points.push_back({rows[k].dx, *error, floors[k]});
    FitOptions options;
    options.round_off = 0;  // the floor of each level says it
    const OrderFit fit = fit_order(points, options);
    fits.push_back({rows[0].field, rows[0].estimator, rows[0].pair, norm.name, fit, classify(fit)});
  }
}

}  // namespace

GradientErrors error_norms(const Cloud<1>& cloud, double R, const std::vector<double>& error) {
  const double left = 2 * R * (1 - 1e-12), right = cloud.box.size[0] - left;
  double all = 0, inside = 0, inside_max = 0, outside_max = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < error.size(); ++i) {
    const double X = cloud.X[i][0], size = std::abs(error[i]);
    all += size * size;
    if (X >= left && X <= right) {
      ++count;
      inside += size * size;
      inside_max = std::max(inside_max, size);
    } else {
      outside_max = std::max(outside_max, size);
    }
  }
  GradientErrors norm{};
  norm.rmse = std::sqrt(all / static_cast<double>(error.size()));
  norm.max = std::max(inside_max, outside_max);
  if (count > 0) {
    norm.interior_rmse = std::sqrt(inside / static_cast<double>(count));
    norm.interior_max = inside_max;
  }
  if (count < error.size()) norm.boundary_max = outside_max;
  return norm;
}

RefinementStudy refine(const Discretisation& discretisation, const std::vector<Index>& cells,
                       const std::vector<TestField>& fields, const std::vector<GradientMethod>& methods,
                       Sitting& sitting) {
  const std::vector<Discretisation> all = levels(discretisation, cells);
  const RadialKernel<1> kernel = kernel_named<1>(discretisation.kernel);
  std::vector<Cloud<1>> clouds;
  for (const Discretisation& level : all) {
    clouds.push_back(make_cloud(level));
    windows(clouds.back(), level.support());
  }
  RefinementStudy study;
  for (const TestField& field : fields) {
    std::vector<Sampled> samples;
    std::vector<double> floors;
    floors.reserve(clouds.size());
    for (const Cloud<1>& cloud : clouds) floors.push_back(samples.emplace_back(field, cloud).floor);
    for (const GradientMethod& method : methods) {
      std::vector<StudyRow> rows;
      for (std::size_t k = 0; k < all.size(); ++k) {
        const double R = all[k].support();
        const auto make = [&]() -> TimedErrors {
          const double start = cpu_seconds();
          std::vector<double> error = estimate(clouds[k], kernel, R, method, samples[k].x);
          const double cpu_s = cpu_seconds() - start;
          for (std::size_t i = 0; i < error.size(); ++i) error[i] -= samples[k].exact[i];
          return {error_norms(clouds[k], R, error), cpu_s};
        };
        const auto made = sitting.value<TimedErrors>(
            fmt::format("{}, {}, {}, {}, R = {:.17g} m, jitter {:.17g}, n = {}", field.text, method.estimator,
                        name_of(method.pair), discretisation.kernel, R, discretisation.jitter, all[k].n),
            make, static_cast<double>(all[k].n));
        rows.push_back(
            {all[k].n, all[k].dx(), R, field.text, method.estimator, method.pair, made.norms, made.cpu_s});
      }
      fit_all(rows, floors, study.fits);
      study.rows.insert(study.rows.end(), rows.begin(), rows.end());
    }
  }
  return study;
}

}  // namespace plumb::oned
