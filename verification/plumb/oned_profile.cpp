#include "verification/plumb/oned_profile.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "oned/function.hpp"
#include "oned/profile.hpp"
#include "oned/study.hpp"
#include "verification/plumb/drawing.hpp"
#include "verification/plumb/oned_options.hpp"
#include "verification/plumb/oned_pictures.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

/// "R/dx = 2: alpha is 6.6 at most, .."
std::string summary_of(const OnedVariant& variant, const std::vector<oned::ProfileRow>& rows) {
  const auto largest = [&](double oned::ProfileRow::*member) {
    return *std::max_element(rows.begin(), rows.end(), [member](const auto& a, const auto& b) {
      return std::abs(a.*member) < std::abs(b.*member);
    });
  };
  const auto alpha = largest(&oned::ProfileRow::alpha), beta = largest(&oned::ProfileRow::beta),
             condition = largest(&oned::ProfileRow::condition),
             negative = largest(&oned::ProfileRow::negative);
  const std::string name = variant.named("");
  return fmt::format(
      "{}largest alpha {:.4g} (x = {:.4g} m), beta {:.4g} 1/m ({:.4g} m), condition {:.4g} ({:.4g} m); {}\n",
      name.empty() ? "" : name + ": ", alpha.alpha, alpha.x, beta.beta, beta.x, condition.condition,
      condition.x,
      negative.negative > 0 ? fmt::format("negative weights up to {:.3g} of the sum at x = {:.4g} m",
                                          negative.negative, negative.x)
                            : "no negative weight");
}

int correction(const Session& session, const OnedOptions& options, const std::vector<double>& at,
               Index count) {
  Json rows = Json::array();
  std::vector<std::pair<std::string, std::vector<oned::ProfileRow>>> drawn;
  std::string text;
  for (const OnedVariant& variant : options.variants()) {
    const auto& d = variant.discretisation;
    warn(session, oned::warnings(d, {}));
    auto profile = oned::correction_profile(d, at.empty() ? oned::even_points(d.length, count) : at);
    for (const oned::ProfileRow& r : profile) {
      Json row{{"x", r.x},     {"alpha", r.alpha}, {"beta", r.beta},           {"VW", r.VW},
               {"VW0", r.VW0}, {"VW1", r.VW1},     {"condition", r.condition}, {"negative", r.negative}};
      row.update(variant.keys);
      rows.push_back(std::move(row));
    }
    text += summary_of(variant, profile);
    drawn.emplace_back(variant.named(""), std::move(profile));
  }
  session.write_table(rows);
  session.text() << text;
  Json parameters = parameters_of(options);
  parameters["n"] = options.discretisation().n;
  session.write_json({{"parameters", parameters}, {"rows", rows}});
  draw(session, correction_picture(options.discretisation(), drawn));
  return 0;
}

int function(const Session& session, const OnedOptions& options) {
  const auto fields = options.parsed_fields();
  std::vector<Correction> pairs;
  for (const oned::GradientMethod& method : options.methods()) pairs.push_back(method.pair);
  Json rows = Json::array();
  std::vector<std::pair<std::string, std::vector<oned::FunctionRow>>> drawn;
  std::string text;
  for (const OnedVariant& variant : options.variants()) {
    const auto& d = variant.discretisation;
    warn(session, oned::warnings(d, fields));
    const auto estimates = oned::function_rows(d, fields, pairs);
    for (const oned::FunctionRow& r : estimates) {
      Json row{{"pair", name_of(r.pair)}, {"field", r.field}, {"X", r.X},
               {"exact", r.exact},        {"value", r.value}, {"error", r.error}};
      row.update(variant.keys);
      rows.push_back(std::move(row));
    }
    const Cloud<1> cloud = oned::make_cloud(d);
    for (std::size_t from = 0; from < estimates.size(); from += cloud.X.size()) {
      std::vector<double> error;
      for (std::size_t i = 0; i < cloud.X.size(); ++i) error.push_back(estimates[from + i].error);
      text += errors_text(
          variant.named(fmt::format("{}, {}", name_of(estimates[from].pair), estimates[from].field)),
          oned::error_norms(cloud, d.support(), error));
    }
    drawn.emplace_back(variant.named(""), estimates);
  }
  session.write_table(rows);
  session.text() << text;
  Json parameters = parameters_of(options);
  parameters["n"] = options.discretisation().n;
  session.write_json({{"parameters", parameters}, {"rows", rows}});
  draw(session, function_picture(options.discretisation(), drawn));
  return 0;
}

}  // namespace

void add_correction(CLI::App& group, Session& session) {
  const auto options = std::make_shared<OnedOptions>();
  const auto at = std::make_shared<std::vector<double>>();
  const auto count = std::make_shared<Index>(41);
  CLI::App& command = add_command(
      group, session,
      {"correction", "what a correction does along the body: alpha, beta, sums, condition, negative weights",
       "plumb oned correction --radius-over-dx 1.8,4 --points 11"},
      {.table = true, .plot = true},
      [&session, options, at, count] { return correction(session, *options, *at, *count); });
  command.add_option("--at", *at, "evaluation points in [0, L], particles or not, as a list [m]")
      ->delimiter(',')
      ->allow_extra_args(false);
  command.add_option("--points", *count, "so many points from 0 to L instead")->capture_default_str();
  add_cloud_options(command, *options, {.variants = true});
}

void add_function(CLI::App& group, Session& session) {
  const auto options = std::make_shared<OnedOptions>();
  options->pairs = {"none", "W0", "W1"};
  options->estimators = {"standard"};
  CLI::App& command =
      add_command(group, session,
                  {"function", "the function itself as corrected kernels estimate it",
                   "plumb oned function --field \"poly:1,1\" --n 10"},
                  {.table = true, .plot = true}, [&session, options] { return function(session, *options); });
  add_cloud_options(command, *options, {.variants = true});
  add_field_option(command, *options);
  command.add_option("--pair", options->pairs, "none, W0, W1; several: a,b or repeated")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->capture_default_str();
}

}  // namespace plumb::app
