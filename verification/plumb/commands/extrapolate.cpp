#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "plumb/commands.hpp"
#include "plumb/session.hpp"
#include "plumbline/convergence/richardson.hpp"
#include "plumbline/convergence/verdict.hpp"
#include "plumbline/core/error.hpp"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

struct ExtrapolateOptions {
  std::vector<double> spacings, values, reference;
  double order = 2, safety = 1.25;
};

std::string_view name_of(Extrapolation::Behaviour behaviour) {
  switch (behaviour) {
    case Extrapolation::Behaviour::monotone:
      return "monotone";
    case Extrapolation::Behaviour::oscillatory:
      return "oscillatory";
    case Extrapolation::Behaviour::divergent:
      return "divergent";
    case Extrapolation::Behaviour::converged:
      break;
  }
  return "converged";
}

std::vector<Sample> samples_of(const ExtrapolateOptions& options) {
  if (options.spacings.size() != options.values.size())
    throw InputError(fmt::format("{} spacings and {} values", options.spacings.size(), options.values.size()),
                     "each value belongs to a spacing", "Give as many of one as of the other.");
  std::vector<Sample> samples;
  for (std::size_t k = 0; k < options.spacings.size(); ++k)
    samples.push_back({options.spacings[k], options.values[k]});
  return samples;
}

/// Order against a value from a much finer grid. A reference among the grids, or not fine enough, is refused.
int against_reference(const Session& session, const ExtrapolateOptions& options) {
  if (options.reference.size() != 2)
    throw InputError("--reference takes a spacing and a value", "", "Write --reference 0.001,2.4049.");
  const OrderFit fit = fit_order(
      errors_against(samples_of(options), {options.reference[0], options.reference[1]}, options.order));
  session.text() << fmt::format("order {:.3f} [{:.3f}, {:.3f}] from {} levels: {}\n", fit.order, fit.lower,
                                fit.upper, fit.levels.size(), name_of(classify(fit)));
  session.write_json({{"order", fit.order},
                      {"ci95", {fit.lower, fit.upper}},
                      {"pairwise", fit.pairwise},
                      {"levels", fit.levels.size()},
                      {"verdict", name_of(classify(fit))}});
  return 0;
}

int extrapolate_action(const Session& session, const ExtrapolateOptions& options) {
  if (!options.reference.empty()) return against_reference(session, options);
  const Extrapolation found = richardson(samples_of(options), options.safety);
  const bool monotone = found.behaviour == Extrapolation::Behaviour::monotone;
  if (monotone)
    session.text() << fmt::format(
        "observed order {:.4f}\nvalue at spacing 0: {:.10g}\ngrid convergence index {:.4g} (finest), {:.4g} "
        "(next)\n"
        "asymptotic ratio {:.4f}\n",
        found.order, found.limit, found.gci_fine, found.gci_coarse, found.asymptotic_ratio);
  else
    session.text() << fmt::format("{}: no order and no limit can be read off\n", name_of(found.behaviour));
  session.write_json({{"behaviour", name_of(found.behaviour)},
                      {"order", found.order},
                      {"limit", found.limit},
                      {"gci_fine", found.gci_fine},
                      {"gci_coarse", found.gci_coarse},
                      {"asymptotic_ratio", found.asymptotic_ratio},
                      {"safety", options.safety}});
  return monotone || found.behaviour == Extrapolation::Behaviour::converged ? 0 : 1;
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
                  "SPACING,VALUE of a much finer grid: order of the differences to it; refused if its own "
                  "error counts")
      ->delimiter(',');
  command.add_option("--order", options->order, "with --reference: the order that is expected")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
}

}  // namespace plumb
