#include "mms/temporal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>

#include "lib/convergence/status.hpp"
#include "lib/core/dimension.hpp"
#include "lib/schemes/tlsph/time/catalogue.hpp"
#include "mms/level.hpp"
#include "mms/pace.hpp"

namespace plumb::mms {
namespace {

constexpr int halvings = 5;
constexpr std::string_view printed = "rk3, loads at t^n";

/// The field at the end of a run: u and its gradient, particle after particle.
struct EndField {
  std::vector<double> numbers;

  template <class Self, class Visit>
  static void members(Self& self, Visit&& visit) {
    visit("numbers", self.numbers);
  }
};

template <int d>
EndField end_field(const NodalValues<d>& values) {
  EndField field;
  for (const PointValue<d>& value : values) {
    for (const double u : value.u) field.numbers.push_back(u);
    for (const double slope : value.gradient.reshaped()) field.numbers.push_back(slope);
  }
  return field;
}

template <int d>
NodalValues<d> values_of(const EndField& field) {
  NodalValues<d> values(field.numbers.size() / (d + d * d));
  auto next = field.numbers.begin();
  for (PointValue<d>& value : values) {
    for (double& u : value.u) u = *next++;
    for (double& slope : value.gradient.reshaped()) slope = *next++;
  }
  return values;
}

/// Work of so many steps, relative.
double steps_work_of(std::string_view integrator, long steps) {
  double evaluations = 3;  // of the scheme as printed too
  for_each_type(IntegratorCatalogue{}, [&]<class T>(Type<T>) {
    if (T::name == integrator) evaluations = T::template Integrator<2>::evaluations_per_step;
  });
  return evaluations * static_cast<double>(steps);
}

/// Work of the whole study: of every integrator, of (30) as printed, and of the reference.
double steps_work_of(const Study& study, long first_steps, long reference_steps) {
  const long steps = first_steps * ((2L << halvings) - 1);  // 1 + 2 + 4 ..
  double work = steps_work_of("rk3", reference_steps);
  for_each_type(IntegratorCatalogue{}, [&]<class T>(Type<T>) { work += steps_work_of(T::name, steps); });
  return loading_of(study).body_force ? work + steps_work_of(printed, steps) : work;
}

/// The field after so many steps of the integrator of that name.
template <int d>
LevelRun<d> field_after(Study study, const Manufactured<d>& solution, std::string_view integrator, long steps,
                        Sitting& sitting) {
  const bool as_printed = integrator == printed;
  study.method.integrator = as_printed ? "rk3" : integrator;
  study.method.cfl.reset();
  study.method.time_step = end_time(study) / static_cast<double>(steps);
  DrivenBody<d> body =
      driven_body<d>(study, solution, study.spacings.front(),
                     {.body_force = loading_of(study).body_force, .at_step_start = as_printed});
  TlsphBody<d>& simulation = body.simulation;
  const auto make = [&] {
    const Pace<d> pace(sitting, simulation);
    const RunResult result = run<d>(simulation.solid, simulation.state, body.integrator, simulation.control,
                                    [&](const Solid<d>&, const State<d>&) { return pace.tell(), true; });
    if (!result.completed())
      throw InputError(
          "the run with steps of " + std::to_string(*study.method.time_step) + " s became unstable",
          std::string(name_of(result.failure->cause)), "Choose a stable scheme or a shorter time.");
    return end_field<d>(values_of_body<d>(study, simulation.solid, simulation.state, solution));
  };
  LevelRun<d> out;
  out.values = values_of<d>(sitting.value<EndField>(fmt::format("{}, {} steps", integrator, steps), make,
                                                    steps_work_of(integrator, steps)));
  out.cloud = std::move(simulation.solid.cloud);
  return out;
}

/// Round-off of the L2 norm of a field of that size after so many steps: each rounds displacements and
/// velocities, and the roundings add up. Measured on a standing wave: 8 to 24 sqrt(steps) eps of its size
/// after 25600 and 51200 steps; levels below ten times this are not fitted.
double rounding(double size, long steps) {
  return std::numeric_limits<double>::epsilon() * size *
         std::max(64.0, 10 * std::sqrt(static_cast<double>(steps)));
}

template <int d>
TemporalOrder order_of(const Study& study, const Manufactured<d>& solution, std::string_view integrator,
                       double declared, long first_steps, const LevelRun<d>& reference, double size,
                       Sitting& sitting) {
  TemporalOrder out{std::string(integrator), declared, {}, {}, {}};
  const ExactField<d> zero = [](const Vec<d>&) { return PointValue<d>{}; };
  for (int k = 0; k <= halvings; ++k) {
    const long steps = first_steps << k;
    const LevelRun<d> run = field_after<d>(study, solution, integrator, steps, sitting);
    const NodalValues<d> error = difference<d>(run.values, reference.values);
    out.levels.push_back(
        {end_time(study) / static_cast<double>(steps), nodal_norms<d>(run.cloud, error, zero).l2});
  }
  FitOptions options;
  options.round_off = rounding(size, first_steps << (halvings + 2));
  out.fit = fit_order(out.levels, options);
  out.verdict = name_of(judge(out.fit, declared));
  return out;
}

template <int d>
TemporalResult run_temporal_in(const Study& study, const StudyProgress& progress, Sitting& sitting) {
  const Manufactured<d> solution = solution_of<d>(study);
  const Elastic elastic = in_dimension(d, study.material.elastic(), study.material.plane);
  const double end = end_time(study);
  const double first_step = study.method.time_step.value_or(study.method.cfl.value_or(0) *
                                                            study.spacings.front() / elastic.wave_speed());
  const auto first_steps = static_cast<long>(std::ceil(end / first_step * (1 - 1e-12)));
  const long reference_steps = first_steps << (halvings + 2);
  sitting.tell(steps_work_of(study, first_steps, reference_steps), progress, "pair evaluations");
  const LevelRun<d> reference = field_after<d>(study, solution, "rk3", reference_steps, sitting);
  const ExactField<d> exact = exact_field<d>(solution, end),
                      zero = [](const Vec<d>&) { return PointValue<d>{}; };
  TemporalResult result;
  result.spacing = study.spacings.front();
  result.n = reference.cloud.size();
  result.reference_step = end / static_cast<double>(reference_steps);
  result.spatial_error = nodal_norms<d>(reference.cloud, reference.values, exact).l2;
  double size = nodal_norms<d>(reference.cloud, reference.values, zero).l2;
  for (const double share : {0.0, 0.25, 0.5, 0.75})  // at the end the displacement may just pass through zero
    size = std::max(size, nodal_size<d>(reference.cloud, exact_field<d>(solution, share * end)).l2);
  const auto add = [&](std::string_view name, double declared) {
    result.orders.push_back(
        order_of<d>(study, solution, name, declared, first_steps, reference, size, sitting));
  };
  for_each_type(IntegratorCatalogue{},
                [&]<class T>(Type<T>) { add(T::name, T::template Integrator<d>::order); });
  if (loading_of(study).body_force) add(printed, 1);
  std::vector<Judged> judged;
  for (const auto& order : result.orders) judged.push_back({order.verdict});
  result.status = plumb::status_of(judged);
  return result;
}

}  // namespace

bool at_floor(const TemporalOrder& order, std::size_t level) {
  const auto& fitted = order.fit.levels;
  const auto is_this = [&](double step) { return step == order.levels[level].spacing; };
  return std::isfinite(order.levels[level].error) && std::none_of(fitted.begin(), fitted.end(), is_this);
}

TemporalResult run_temporal(const Study& study, const StudyProgress& progress, Sitting& sitting) {
  return with_dimension(study.dimension(),
                        [&]<int d>() { return run_temporal_in<d>(study, progress, sitting); });
}

}  // namespace plumb::mms
