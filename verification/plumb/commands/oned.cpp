#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "oned/explorer.hpp"
#include "oned/response.hpp"
#include "verification/plumb/commands.hpp"
#include "verification/plumb/drawing.hpp"
#include "verification/plumb/oned_account.hpp"
#include "verification/plumb/oned_options.hpp"
#include "verification/plumb/oned_pictures.hpp"
#include "verification/plumb/oned_study.hpp"
#include "verification/plumb/row_output.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;
using Options = std::shared_ptr<OnedOptions>;

int kernels(const Session& session, const OnedOptions& options, double at, bool gradients) {
  const oned::Discretisation d = options.discretisation();
  const oned::KernelView view = oned::explore(d, at);
  warn(session, oned::warnings(d, {}));
  const auto row = [&view](std::size_t k) -> Json {
    const auto& r = view.rows[k];
    return {{"x", r.x},          {"W", r.W},           {"W0", r.W0},         {"W1", r.W1},
            {"gradW", r.gradW},  {"LgradW", r.LgradW}, {"gradW0", r.gradW0}, {"LgradW0", r.LgradW0},
            {"gradW1", r.gradW1}};
  };
  Json sums = Json::object();
  for (const auto& [name, sum] : view.sums) sums[name] = sum;
  session.text() << fmt::format("x = {:g} m, R = {:g} m, h = {:g} m, alpha = {:.12g}, beta = {:.12g} 1/m\n",
                                view.at, view.R, view.h, view.alpha, view.beta);
  for (const auto& [name, sum] : view.sums)
    session.text() << fmt::format("  sum {:<10} {: .12g}\n", name, sum);
  Json parameters = parameters_of(options);
  parameters["n"] = d.n;
  write_rows(session,
             {{"parameters", parameters},
              {"at", view.at},
              {"dx", view.dx},
              {"radius", view.R},
              {"h", view.h},
              {"alpha", view.alpha},
              {"beta", view.beta},
              {"sums", sums}},
             {view.rows.size(), row});
  draw(session, kernel_picture(view, gradients));
  return 0;
}

int gradient(const Session& session, const OnedOptions& options, bool errors) {
  const oned::Discretisation d = options.discretisation();
  const auto fields = options.parsed_fields();
  const auto table = oned::gradient_table(d, fields, options.methods());
  warn(session, oned::warnings(d, fields));
  const auto row = [&table](std::size_t k) -> Json {
    const oned::GradientRow r = table.row(k);
    return {{"estimator", r.estimator}, {"pair", name_of(r.pair)}, {"field", r.field}, {"X", r.X},
            {"exact", r.exact},         {"value", r.value},        {"error", r.error}};
  };
  Json parameters = parameters_of(options);
  parameters["n"] = d.n;
  write_rows(session, {{"parameters", parameters}, {"dx", d.dx()}, {"radius", d.support()}},
             {table.size(), row});
  if (session.plot.empty()) return 0;
  std::vector<oned::GradientRow> drawn;
  for (std::size_t k = 0; k < table.size(); ++k) drawn.push_back(table.row(k));
  draw(session, gradient_picture(drawn, errors));
  return 0;
}

int response(const Session& session, const OnedOptions& options, Index points) {
  const oned::Discretisation d = options.discretisation();
  const auto result = oned::response_rows(d.kernel, d.support() / d.dx(), options.methods(), points);
  const auto row = [&result](std::size_t k) -> Json {
    const auto& r = result[k];
    return {{"theta", r.theta}, {"estimator", r.estimator}, {"pair", name_of(r.pair)}, {"value", r.value}};
  };
  write_rows(session, {{"parameters", parameters_of(options)}, {"radius_over_dx", d.support() / d.dx()}},
             {result.size(), row});
  draw(session, response_picture(result));
  return 0;
}

void add_kernels(CLI::App& group, Session& session) {
  const auto options = std::make_shared<OnedOptions>();
  const auto at = std::make_shared<double>(0);
  const auto gradients = std::make_shared<bool>(false);
  CLI::App& command = add_command(group, session,
                                  {"kernels", "kernels and gradients as seen from one point",
                                   "plumb oned kernels --at 0 --length 2 --n 200 --radius 1"},
                                  {.table = true, .plot = true}, [&session, options, at, gradients] {
                                    return kernels(session, *options, *at, *gradients);
                                  });
  command.add_option("--at", *at, "the evaluation point x in [0, L], a particle or not [m]")->required();
  command.add_flag("--gradients", *gradients, "--plot draws the gradients instead of the kernels");
  add_cloud_options(command, *options, false);
}

void add_gradient(CLI::App& group, Session& session) {
  const auto options = std::make_shared<OnedOptions>();
  const auto errors = std::make_shared<bool>(false);
  CLI::App& command = add_command(group, session,
                                  {"gradient", "estimates of a gradient at every particle",
                                   "plumb oned gradient --field poly:1,1 --estimator standard,bond,improved"},
                                  {.table = true, .plot = true}, [&session, options, errors] {
                                    return gradient(session, *options, *errors);
                                  });
  command.add_flag("--errors", *errors, "--plot draws the errors instead of the estimates");
  add_cloud_options(command, *options, false);
  add_field_option(command, *options);
  add_method_options(command, *options);
}

void add_response(CLI::App& group, Session& session) {
  const auto options = std::make_shared<OnedOptions>();
  const auto points = std::make_shared<Index>(100);
  CLI::App& command =
      add_command(group, session,
                  {"response", "response inside a uniform lattice to exp(ikX)",
                   "plumb oned response --estimator standard,bond,improved --radius-over-dx 4"},
                  {.table = true, .plot = true},
                  [&session, options, points] { return response(session, *options, *points); });
  add_cloud_options(command, *options, false);
  add_method_options(command, *options);
  command.add_option("--points", *points, "number of theta = k dx, evenly up to pi")->capture_default_str();
}

}  // namespace

/// `plumb oned`: the one-dimensional study of gradient estimates.
void add_oned(CLI::App& program, Session& session) {
  CLI::App& group = add_command_group(
      program, session,
      {"oned", "gradient estimates in one dimension: kernels, gradient, study, response, account",
       "plumb oned study --field poly:1,0,0,1 --n 20,40,80,160"});
  add_kernels(group, session);
  add_gradient(group, session);
  add_oned_study(group, session);
  add_response(group, session);
  add_account(group, session);
}

}  // namespace plumb::app
