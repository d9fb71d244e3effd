#include "verification/plumb/oned_page.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "lib/core/type_list.hpp"
#include "lib/kernel/catalogue.hpp"
#include "oned/explorer.hpp"
#include "oned/gradient.hpp"
#include "oned/profile.hpp"
#include "oned/response.hpp"
#include "reports/assets.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

const std::vector<double> radii{1.8, 2, 2.2, 2.5, 3, 4, 5};
const std::vector<double> jitters{0, 0.1, 0.3};
const std::vector<std::string> fields{"X^2", "X^3", "sin(10*X)"};
const std::vector<std::string> estimators{"standard", "bond", "improved"};
const std::vector<Correction> pairs{Correction::W1, Correction::W0, Correction::none};
constexpr Index places = 41, waves = 60;

oned::Discretisation discretisation(const std::string& kernel, double radius, double jitter) {
  oned::Discretisation d;
  d.length = 1;
  d.n = 20;
  d.kernel = kernel;
  d.radius = {radius, false};
  d.jitter = jitter;
  return d;
}

std::vector<oned::GradientMethod> methods() {
  std::vector<oned::GradientMethod> all;
  for (const auto& estimator : estimators)
    for (const Correction pair : pairs) all.push_back({estimator, pair, oned::Form::difference});
  return all;
}

Json seen_from(const oned::Discretisation& d, double x) {
  Json rows = Json::array();
  for (const oned::KernelRow& r : oned::explore(d, x).rows)
    rows.push_back({{"x", r.x}, {"W", r.W}, {"W0", r.W0}, {"W1", r.W1}});
  return rows;
}

Json cloud_of(const oned::Discretisation& d) {
  const std::vector<double> at = oned::even_points(d.length, places);
  Json seen = Json::array(), correction = Json::array(), gradients = Json::array(), exact = Json::object();
  for (const double x : at) seen.push_back(seen_from(d, x));
  for (const oned::ProfileRow& r : oned::correction_profile(d, at))
    correction.push_back({{"alpha", r.alpha},
                          {"beta", r.beta},
                          {"VW", r.VW},
                          {"condition", r.condition},
                          {"negative", r.negative}});
  std::vector<oned::TestField> parsed;
  for (const auto& field : fields) parsed.push_back(oned::parse_field(field));
  const oned::GradientTable table = oned::gradient_table(d, parsed, methods());
  for (std::size_t f = 0; f < fields.size(); ++f) exact[fields[f]] = table.exact[f];
  for (const auto& column : table.columns)
    gradients.push_back({{"field", table.fields[column.field]},
                         {"estimator", column.method.estimator},
                         {"pair", name_of(column.method.pair)},
                         {"value", column.value}});
  return {{"kernel", d.kernel}, {"radius_over_dx", d.radius.value},
          {"jitter", d.jitter}, {"X", table.X},
          {"seen", seen},       {"correction", correction},
          {"exact", exact},     {"gradients", gradients}};
}

Json responses_of(const std::string& kernel, double radius) {
  Json all = Json::array();
  for (const auto& method : methods()) {
    std::vector<double> thetas, values;
    for (const auto& row : oned::response_rows(kernel, radius, {method}, waves)) {
      thetas.push_back(row.theta);
      values.push_back(row.value);
    }
    all.push_back({{"kernel", kernel},
                   {"radius_over_dx", radius},
                   {"estimator", method.estimator},
                   {"pair", name_of(method.pair)},
                   {"theta", thetas},
                   {"value", values}});
  }
  return all;
}

}  // namespace

std::string explorer_page() {
  Json clouds = Json::array(), responses = Json::array(), names = Json::array();
  for (const auto& kernel : names_of(KernelCatalogue{}))
    for (const double radius : radii) {
      for (const double jitter : jitters) clouds.push_back(cloud_of(discretisation(kernel, radius, jitter)));
      for (Json& response : responses_of(kernel, radius)) responses.push_back(std::move(response));
    }
  for (const Correction pair : pairs) names.push_back(name_of(pair));
  const Json data{{"kernels", names_of(KernelCatalogue{})},
                  {"radii", radii},
                  {"jitters", jitters},
                  {"places", oned::even_points(1, places)},
                  {"dx", discretisation("cubic", 1, 0).dx()},
                  {"fields", fields},
                  {"estimators", estimators},
                  {"pairs", names},
                  {"clouds", clouds},
                  {"responses", responses}};
  std::string page(reports::assets::explorer_html);
  const std::string mark = "%DATA%";
  return page.replace(page.find(mark), mark.size(), data.dump());
}

std::string explorer_overview() {
  const oned::Discretisation d;
  const auto profile = oned::correction_profile(d, {0, d.length / 2});
  std::string text = fmt::format(
      "A body of {:g} m, {} particles, cubic kernel, R = {:g} dx.\n"
      "At the wall the plain kernel sums up to {:.4g}. The first-order correction has alpha = {:.4g} and\n"
      "beta = {:.4g} 1/m there, and {:.1f} % of its weights are negative; inside they are {:.4g} and {:.4g} 1/m.\n",
      d.length, d.n, d.radius.value, profile[0].VW, profile[0].alpha, profile[0].beta,
      100 * profile[0].negative, profile[1].alpha, std::abs(profile[1].beta) < 1e-12 ? 0 : profile[1].beta);
  for (const auto& r : oned::resolutions(
           d.kernel, d.radius.value, {{"standard", Correction::W1}, {"improved", Correction::W1}}, {0.01}))
    if (r.particles_per_wave)
      text += fmt::format("Waves need {:.3g} particles for a derivative within 1 % by the {} estimate.\n",
                          *r.particles_per_wave, r.estimator);
  return text;
}

}  // namespace plumb::app
