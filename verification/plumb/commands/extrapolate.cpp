#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "lib/convergence/richardson.hpp"
#include "lib/convergence/status.hpp"
#include "lib/convergence/verdict.hpp"
#include "lib/core/error.hpp"
#include "verification/plumb/commands.hpp"
#include "verification/plumb/extrapolation_output.hpp"
#include "verification/plumb/fit_text.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

/// What the error of a reference is estimated with if no order is declared.
constexpr double assumed_order = 2;

struct ExtrapolateOptions {
  std::vector<double> spacings, values, reference;
  std::optional<double> order;
  double safety = 1.25;
};

std::vector<Sample> samples_of(const ExtrapolateOptions& options) {
  if (options.spacings.size() != options.values.size())
    throw InputError(fmt::format("{} spacings and {} values", options.spacings.size(), options.values.size()),
                     "each value belongs to a spacing", "Give as many of one as of the other.");
  std::vector<Sample> samples;
  for (std::size_t k = 0; k < options.spacings.size(); ++k)
    samples.push_back({options.spacings[k], options.values[k]});
  return samples;
}

/// Order against a value from a much finer grid. A reference among the grids, or not fine enough, is refused,
/// and so is a value that is not a number.
int against_reference(const Session& session, const ExtrapolateOptions& options) {
  if (options.reference.size() != 2)
    throw InputError("--reference takes a spacing and a value", "", "Write --reference 0.001,2.4049.");
  const std::vector<Sample> samples = samples_of(options);
  for (const Sample& sample : samples)
    if (!std::isfinite(sample.value) || !std::isfinite(options.reference[1]))
      throw InputError(fmt::format("the value {} at spacing {:g} against the reference {}", sample.value,
                                   sample.spacing, options.reference[1]),
                       "an order needs finite numbers", "Leave broken runs out.");
  const OrderFit fit = fit_order(errors_against(samples, {options.reference[0], options.reference[1]},
                                                options.order.value_or(assumed_order)));
  const std::string verdict(options.order ? name_of(judge(fit, *options.order)) : name_of(classify(fit)));
  const std::string_view status = plumb::status_of({{verdict, options.order.has_value()}});
  session.text() << fits_text({{"error", fit, options.order, verdict}}) << "status: " << status << '\n';
  session.write_json({{"order", fit.order},
                      {"ci95", {fit.lower, fit.upper}},
                      {"pairwise", fit.pairwise},
                      {"levels", fit.levels.size()},
                      {"declared", options.order ? Json(*options.order) : Json()},
                      {"verdict", verdict},
                      {"status", status}});
  return exit_code_of(status);
}

int extrapolate_action(const Session& session, const ExtrapolateOptions& options) {
  if (!options.reference.empty()) return against_reference(session, options);
  const Extrapolated found = extrapolated(samples_of(options), options.safety, options.order);
  session.text() << found.text;
  session.write_json(found.json);
  return exit_code_of(found.status);
}

}  // namespace

/// `plumb extrapolate`: what three grids and more say where no exact solution is known.
void add_extrapolate(CLI::App& program, Session& session) {
  const auto options = std::make_shared<ExtrapolateOptions>();
  CLI::App& command =
      add_command(program, session,
                  {"extrapolate",
                   "Richardson extrapolation and grid convergence index from values on three grids or more",
                   "plumb extrapolate --spacings 0.4,0.2,0.1 --values 1.16,1.04,1.01"},
                  {}, [&session, options] { return extrapolate_action(session, *options); });
  command.add_option("--spacings", options->spacings, "spacing of each grid [m]")->delimiter(',')->required();
  command.add_option("--values", options->values, "the computed quantity on each grid")
      ->delimiter(',')
      ->required();
  command
      .add_option("--safety", options->safety, "safety factor of the index (Roache: 1.25 from three grids)")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  command
      .add_option("--reference", options->reference,
                  "SPACING,VALUE of a much finer grid: order of the "
                  "differences to it; refused if its own error counts")
      ->delimiter(',');
  command
      .add_option("--order", options->order,
                  "the order that is declared: with --reference it is "
                  "judged, else the asymptotic ratio is formed with it")
      ->check(CLI::PositiveNumber);
  point_to_verdicts(command);
}

}  // namespace plumb::app
