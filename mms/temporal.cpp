#include "mms/temporal.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "mms/pace.hpp"
#include "plumbline/time/catalogue.hpp"

namespace plumb::mms {
namespace {

constexpr int halvings = 5;
constexpr std::string_view printed = "rk3, loads at t^n";

/// Holds the time that the loads see at the start of each step: (30) as printed.
template <int d>
void freeze_loads(DrivenBody<d>& body) {
  const auto start = std::make_shared<double>(0);
  Term<d>& loads = body.simulation.solid.terms.back();
  loads.second = [start, inner = loads.second](const Solid<d>& solid, const Block& block,
                                               const State<d>& state, double, BlockForce<d>& force) {
    inner(solid, block, state, *start, force);
  };
  body.stepper.step = [start, inner = body.stepper.step](Solid<d>& solid, State<d>& state, double dt) {
    *start = state.time;
    return inner(solid, state, dt);
  };
}

template <int d>
Sitting::Json json_of(const NodalValues<d>& values) {
  Sitting::Json numbers = Sitting::Json::array();
  for (const PointValue<d>& value : values) {
    for (const double u : value.u) numbers.push_back(u);
    for (const double slope : value.gradient.reshaped()) numbers.push_back(slope);
  }
  return numbers;
}

template <int d>
NodalValues<d> values_of(const Sitting::Json& numbers) {
  NodalValues<d> values(numbers.size() / (d + d * d));
  auto next = numbers.begin();
  for (PointValue<d>& value : values) {
    for (double& u : value.u) u = *next++;
    for (double& slope : value.gradient.reshaped()) slope = *next++;
  }
  return values;
}

/// Work of so many steps, relative.
double work_of(std::string_view integrator, long steps) {
  double evaluations = 3;  // of the scheme as printed too
  for_each_type(IntegratorCatalogue{}, [&]<class T>(Type<T>) {
    if (T::name == integrator) evaluations = T::template Stepper<2>::evaluations_per_step;
  });
  return evaluations * static_cast<double>(steps);
}

/// Work of the whole study: of every integrator, of (30) as printed, and of the reference.
double work_of(const Study& study, long first_steps, long reference_steps) {
  const long steps = first_steps * ((2L << halvings) - 1);  // 1 + 2 + 4 ..
  double work = work_of("rk3", reference_steps);
  for_each_type(IntegratorCatalogue{}, [&]<class T>(Type<T>) { work += work_of(T::name, steps); });
  return study.force == "finite-strain" ? work + work_of(printed, steps) : work;
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
      driven_body<d>(study, solution, study.spacings.front(), study.force == "finite-strain");
  if (as_printed) freeze_loads(body);
  Simulation<d>& simulation = body.simulation;
  const auto make = [&] {
    const Pace<d> pace(sitting, simulation);
    const RunResult result = run<d>(simulation.solid, simulation.state, body.stepper, simulation.control,
                                    [&](const Solid<d>&, const State<d>&) { return pace.tell(), true; });
    if (!result.completed())
      throw InputError(
          "the run with steps of " + std::to_string(*study.method.time_step) + " s became unstable",
          std::string(name_of(result.failure->cause)), "Choose a stable scheme or a shorter time.");
    return json_of<d>(nodal_values<d>(simulation.solid, simulation.state, solution.first_piola));
  };
  LevelRun<d> out;
  out.values = values_of<d>(
      sitting.part(fmt::format("{}, {} steps", integrator, steps), make, work_of(integrator, steps)));
  out.cloud = std::move(simulation.solid.cloud);
  return out;
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
  options.round_off *= size;
  out.fit = fit_order(out.levels, options);
  out.verdict = name_of(judge(out.fit, declared));
  return out;
}

template <int d>
TemporalResult run_in(const Study& study, const StudyProgress& progress, Sitting& sitting) {
  const Manufactured<d> solution = solution_of<d>(study);
  const Elastic elastic = in_dimension(d, study.material.elastic(), study.material.plane);
  const double end = end_time(study);
  const auto first_steps =
      static_cast<long>(std::ceil(2 * end * elastic.wave_speed() / study.spacings.front()));
  const long reference_steps = first_steps << (halvings + 2);
  sitting.tell(work_of(study, first_steps, reference_steps), progress, "pair evaluations");
  const LevelRun<d> reference = field_after<d>(study, solution, "rk3", reference_steps, sitting);
  const ExactField<d> exact = exact_field<d>(solution, end),
                      zero = [](const Vec<d>&) { return PointValue<d>{}; };
  TemporalResult result;
  result.d = study.spacings.front();
  result.n = reference.cloud.size();
  result.reference_step = end / static_cast<double>(reference_steps);
  result.spatial_error = nodal_norms<d>(reference.cloud, reference.values, exact).l2;
  const double size = nodal_norms<d>(reference.cloud, reference.values, zero).l2;
  const auto add = [&](std::string_view name, double declared) {
    result.orders.push_back(
        order_of<d>(study, solution, name, declared, first_steps, reference, size, sitting));
  };
  for_each_type(IntegratorCatalogue{},
                [&]<class T>(Type<T>) { add(T::name, T::template Stepper<d>::order); });
  if (study.force == "finite-strain") add(printed, 1);
  result.status = "pass";
  for (const auto& order : result.orders)
    if (order.verdict != name_of(Verdict::pass))
      result.status = order.verdict == "fail" ? "fail" : "inconclusive";
  return result;
}

}  // namespace

TemporalResult run_temporal(const Study& study, const StudyProgress& progress, Sitting& sitting) {
  if (study.dimension() == 2) return run_in<2>(study, progress, sitting);
  if (study.dimension() == 3) return run_in<3>(study, progress, sitting);
  throw InputError("a study of the time step in one dimension", "solutions exist in 2D and 3D",
                   "Give body.size two or three entries.");
}

}  // namespace plumb::mms
