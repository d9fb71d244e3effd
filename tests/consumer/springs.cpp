// That scheme in the harness of the installed library: it runs, is refined, is stopped and goes on with the
// same bits, keeps its energy, and says what it is.
#include "springs.hpp"

#include <cstdio>
#include <numbers>

#include "plumbline/convergence/verdict.hpp"
#include "plumbline/run/any_scheme.hpp"
#include "plumbline/run/checkpoints.hpp"
#include "plumbline/run/recorder.hpp"

plumb::Simulation<1> bar(Index n, double yield,
                         double end) {  // u = A sin(pi X) at first: u cos(pi t) while it is elastic
  plumb::InitialMotion<1> motion;
  for (Index i = 0; i <= n; ++i)
    motion.u.emplace_back(1e-3 *
                          std::sin(std::numbers::pi * static_cast<double>(i) / static_cast<double>(n)));
  plumb::StepControl control;
  control.end_time = end;
  return plumb::as_simulation<1>(Springs{{yield}, n}, motion, control);
}

int main() {
  plumb::RunRecord none;
  std::vector<plumb::Level> levels;
  for (const Index n : {10, 20, 40, 80}) {  // a scene, refined
    auto elastic = bar(n, 1e9, 0.3);
    plumb::run<1>(elastic, {}, none = {});
    const auto shown = elastic.snapshot();
    double square = 0;
    for (std::size_t i = 0; i < shown.X.size(); ++i)
      square += shown.volume[i] * std::pow(shown.u[i][0] - 1e-3 * std::sin(std::numbers::pi * shown.X[i][0]) *
                                                               std::cos(std::numbers::pi * 0.3),
                                           2);
    levels.push_back({1.0 / static_cast<double>(n), std::sqrt(square)});
  }
  const auto fit = plumb::fit_order(levels);

  auto whole = bar(40, 2e-3, 2), first = bar(40, 2e-3, 1), second = bar(40, 2e-3, 2);  // it yields
  plumb::Output output;
  output.series = true;
  plumb::Recorder<1> recorder(output, "springs", whole);
  const double before = whole.energy().total();
  plumb::run<1>(
      whole, [&] { return recorder.observe(whole), true; }, none = {});
  recorder.finish(whole);
  auto record = plumb::RunRecord{};  // half the way, kept, and on
  plumb::run<1>(
      first, [&] { return first.steps.now().step < 60; }, record);
  second.restore(first.save());
  plumb::run<1>(second, {}, record);
  const bool same_bits = whole.save().fields.at(0).values == second.save().fields.at(0).values;
  const auto after = whole.energy();
  // velocity Verlet keeps the energy of a yielding bar to the order of its step
  const double gap = std::abs(after.total() + *after.dissipated - before) / before;
  std::printf(
      "order %.3f [%.3f, %.3f], dissipated %.2g of the energy, gap %.1g, %s bits after a restart; %s\n",
      fit.order, fit.lower, fit.upper, *after.dissipated / before, gap, same_bits ? "the same" : "other",
      whole.account().at(0).text.c_str());
  return fit.lower > 1.9 && fit.upper < 2.1 && same_bits && *after.dissipated > 0.01 * before && gap < 0.05
             ? 0
             : 1;
}
