#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "lib/output/file.hpp"
#include "oned/explorer.hpp"
#include "oned/response.hpp"
#include "verification/plumb/commands.hpp"
#include "verification/plumb/drawing.hpp"
#include "verification/plumb/oned_account.hpp"
#include "verification/plumb/oned_options.hpp"
#include "verification/plumb/oned_page.hpp"
#include "verification/plumb/oned_pictures.hpp"
#include "verification/plumb/oned_profile.hpp"
#include "verification/plumb/oned_study.hpp"
#include "verification/plumb/optional_json.hpp"
#include "verification/plumb/row_output.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

/// What the sums of a corrected kernel are to be: 1 of V W~, 0 of V (X_j - x) W~, of gradients 0 and 1.
double target_of(const std::string& sum) {
  const bool gradient = sum.find("grad") != std::string::npos, first = sum.starts_with("VX");
  return gradient == first ? 1 : 0;
}

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
    session.text() << fmt::format("  sum {:<10} {: .12g}, to be {:g}\n", name, sum, target_of(name));
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
  draw(session, kernel_picture(d, view, gradients));
  return 0;
}

/// "standard W1".
std::string name_of_method(const oned::GradientMethod& method) {
  return method.estimator + " " + std::string(name_of(method.pair));
}

/// Says which of the methods are one operator, and where.
void tell_same(const Session& session, const OnedVariant& variant,
               const std::vector<oned::GradientMethod>& methods) {
  const oned::Discretisation& d = variant.discretisation;
  const double ratio = d.support() / d.dx();
  for (const auto& [a, b] : oned::same_operators(d.kernel, ratio, methods))
    session.text() << fmt::format("inside a lattice with R/dx = {:g}, {} and {} are the same operator\n",
                                  ratio, name_of_method(methods[a]), name_of_method(methods[b]));
}

/// The tables of all variants as one list of rows.
struct GradientTables {
  std::vector<OnedVariant> variants;
  std::vector<oned::GradientTable> tables;

  std::size_t size() const {
    std::size_t count = 0;
    for (const auto& table : tables) count += table.size();
    return count;
  }
  Json row(std::size_t k) const {
    std::size_t t = 0;
    for (; k >= tables[t].size(); ++t) k -= tables[t].size();
    const oned::GradientRow r = tables[t].row(k);
    Json row{{"estimator", r.estimator}, {"pair", name_of(r.pair)}, {"field", r.field}, {"X", r.X},
             {"exact", r.exact},         {"value", r.value},        {"error", r.error}};
    row.update(variants[t].keys);
    return row;
  }
};

/// For people: a line for each particle, the methods side by side.
void show_side_by_side(const Session& session, const OnedVariant& variant, const oned::GradientTable& table) {
  const std::size_t methods = table.columns.size() / table.fields.size(), points = table.X.size();
  for (std::size_t f = 0; f < table.fields.size(); ++f) {
    session.text() << variant.named(table.fields[f]) << '\n';
    show_rows(session, {points, [&](std::size_t i) {
                          Json row{{"X", table.X[i]}, {"exact", table.exact[f][i]}};
                          for (std::size_t m = 0; m < methods; ++m) {
                            const auto& column = table.columns[f * methods + m];
                            row[name_of_method(column.method)] = column.value[i];
                          }
                          return row;
                        }});
  }
}

/// The norms of the errors of every column, and a line about each.
Json norms_of(const Session& session, const OnedVariant& variant, const oned::GradientTable& table) {
  const Cloud<1> cloud = oned::make_cloud(variant.discretisation);
  Json all = Json::array();
  for (const auto& column : table.columns) {
    std::vector<double> error = column.value;
    for (std::size_t i = 0; i < error.size(); ++i) error[i] -= table.exact[column.field][i];
    const auto norms = oned::error_norms(cloud, variant.discretisation.support(), error);
    const std::string& field = table.fields[column.field];
    session.text() << errors_text(variant.named(name_of_method(column.method) + ", " + field), norms);
    Json row{{"estimator", column.method.estimator}, {"pair", name_of(column.method.pair)}, {"field", field}};
    row.update({{"rmse", norms.rmse},
                {"max", norms.max},
                {"interior_rmse", optional_json(norms.interior_rmse)},
                {"interior_max", optional_json(norms.interior_max)},
                {"boundary_max", optional_json(norms.boundary_max)}});
    row.update(variant.keys);
    all.push_back(std::move(row));
  }
  return all;
}

int gradient(const Session& session, const OnedOptions& options, bool errors) {
  const oned::Discretisation d = options.discretisation();
  const auto fields = options.parsed_fields();
  const auto methods = options.methods();
  GradientTables all{options.variants(), {}};
  for (const OnedVariant& variant : all.variants)
    all.tables.push_back(oned::gradient_table(variant.discretisation, fields, methods));
  Json norms = Json::array();
  for (std::size_t t = 0; t < all.tables.size(); ++t) {
    warn(session, oned::warnings(all.variants[t].discretisation, fields));
    show_side_by_side(session, all.variants[t], all.tables[t]);
    for (Json& row : norms_of(session, all.variants[t], all.tables[t])) norms.push_back(std::move(row));
    tell_same(session, all.variants[t], methods);
  }
  Json parameters = parameters_of(options);
  parameters["n"] = d.n;
  write_files(session,
              {{"parameters", parameters}, {"dx", d.dx()}, {"radius", d.support()}, {"norms", norms}},
              {all.size(), [&all](std::size_t k) { return all.row(k); }});
  if (!draws(session)) return 0;
  OfVariants<oned::GradientRow> drawn;
  for (std::size_t t = 0; t < all.tables.size(); ++t) {
    drawn.emplace_back(all.variants[t].named(""), std::vector<oned::GradientRow>());
    for (std::size_t k = 0; k < all.tables[t].size(); ++k)
      drawn.back().second.push_back(all.tables[t].row(k));
  }
  draw(session, gradient_picture(d, drawn, errors));
  return 0;
}

int response(const Session& session, const OnedOptions& options, Index points) {
  const oned::Discretisation d = options.discretisation();
  OfVariants<oned::ResponseRow> drawn;
  Json rows = Json::array(), limits = Json::array();
  for (const OnedVariant& variant : options.variants()) {
    const oned::Discretisation& v = variant.discretisation;
    const double ratio = v.support() / v.dx();
    drawn.emplace_back(variant.named(""), oned::response_rows(v.kernel, ratio, options.methods(), points));
    for (const auto& r : drawn.back().second) {
      Json row{{"theta", r.theta}, {"estimator", r.estimator}, {"pair", name_of(r.pair)}, {"value", r.value}};
      row.update(variant.keys);
      rows.push_back(std::move(row));
    }
    for (const auto& r : oned::resolutions(v.kernel, ratio, options.methods(), {0.01, 0.1})) {
      Json row{{"estimator", r.estimator}, {"pair", name_of(r.pair)}, {"error", r.error}};
      row["theta"] = optional_json(r.theta);
      row["particles_per_wave"] = optional_json(r.particles_per_wave);
      row.update(variant.keys);
      limits.push_back(std::move(row));
    }
    tell_same(session, variant, options.methods());
  }
  session.text() << "Error of the derivative of waves, and how many particles a wave needs for it:\n"
                 << plain_text(table_of(limits))
                 << fmt::format("({} rows with --csv or --json)\n", rows.size());
  session.write_csv(rows);
  session.write_json({{"parameters", parameters_of(options)},
                      {"radius_over_dx", d.support() / d.dx()},
                      {"resolution", limits},
                      {"rows", rows}});
  draw(session, response_picture(drawn));
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
  add_cloud_options(command, *options, {});
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
  add_cloud_options(command, *options, {.variants = true});
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
  add_cloud_options(command, *options, {.variants = true});
  add_method_options(command, *options);
  command.add_option("--points", *points, "number of theta = k dx, evenly up to pi")->capture_default_str();
}

}  // namespace

/// `plumb oned`: kernel corrections and gradient estimates in one dimension. Alone it makes its page.
void add_oned(CLI::App& program, Session& session) {
  const auto page = std::make_shared<std::string>("oned.html");
  const auto alone = [page] {
    replace_file(*page, explorer_page());
    std::cout << explorer_overview()
              << fmt::format("{}: the explorer, to be opened in a browser. See also: plumb oned --help\n",
                             *page);
    return 0;
  };
  CLI::App& group = add_command_group(program, session,
                                      {"oned", "gradient estimates and kernel corrections in one dimension",
                                       "plumb oned study --field poly:1,0,0,1 --n 20,40,80,160"},
                                      alone);
  group
      .add_option("--page", *page,
                  "without a command: where the explorer goes, one page with everything in it")
      ->type_name("FILE")
      ->capture_default_str();
  add_kernels(group, session);
  add_correction(group, session);
  add_function(group, session);
  add_gradient(group, session);
  add_oned_study(group, session);
  add_response(group, session);
  add_account(group, session);
}

}  // namespace plumb::app
