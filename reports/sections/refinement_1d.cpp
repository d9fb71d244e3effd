#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "reports/checks.hpp"
#include "reports/named.hpp"
#include "reports/results.hpp"
#include "reports/section.hpp"

namespace plumb::reports::sections::refinement_1d {
namespace {

using Json = nlohmann::ordered_json;

struct Method {
  std::string estimator, pair, name;
};
const std::vector<Method> methods{{"standard", "W1", "standard, W1"},
                                  {"improved", "W1", "improved, W1"},
                                  {"improved", "W0", "improved, W0"}};
Method method(const std::string& name) {
  return named(methods, name, &Method::name);
}
const std::string cubic = "poly:1,0,0,1", sine = "sin:5";

Series errors(const Json& rows, const std::string& field, const Method& m, const std::string& x = "n",
              const std::string& norm = "rmse") {
  return series_of(rows, {{"field", field}, {"estimator", m.estimator}, {"pair", m.pair}}, x, norm, m.name);
}

Json rows_of(const Json& rows, const std::string& field, const Method& m) {
  Json out = Json::array();
  for (const auto& row : rows)
    if (text(row, "field") == field && text(row, "estimator") == m.estimator && text(row, "pair") == m.pair)
      out.push_back(row);
  return out;
}

Figure figure(const Json& rows, const std::string& job, const std::string& id, const std::string& field,
              const std::string& title, const std::string& caption, bool with_slope) {
  Picture p{title, {"number of particles N", "", Scale::log}, {"RMSE of dx/dX", "", Scale::log}};
  for (const auto& m : methods) p.series.push_back(errors(rows, field, m));
  p.x.ticks = p.series[0].x;
  if (with_slope) p.triangles = {{-1.5, place_of(p.series, "improved, W1")}};
  return {id, p, caption, {job}};
}

std::vector<Check> checks(const Json& rows) {
  std::vector<Check> out;
  const Json improved = rows_of(rows, cubic, method("improved, W1"));
  for (const auto& [n, known] : {std::pair(20, 1.130), {40, 0.4093}, {80, 0.1464}, {160, 0.05208}})
    out.push_back(
        as(CheckKind::regression,
           number_check(fmt::format("RMSE for X³ + 1, improved W1, N = {}", n),
                        number(row_at(improved, "n", n), "rmse"), known, 5e-4, "four digits known")));
  for (const auto& m : methods)
    for (const auto& [norm, order, what] :
         {std::tuple("rmse", 1.5, "RMSE over all particles"), std::tuple("interior_rmse", 2.0, "RMSE inside"),
          std::tuple("boundary_max", 1.0, "largest error at the ends")}) {
      const Series s = errors(rows, cubic, m, "dx", norm);
      out.push_back(order_check(fmt::format("X³ + 1, {}: {}", m.name, what), s.x, s.y, order));
    }
  return out;
}

DataTable fits(const Json& ratio, const Json& fixed) {
  DataTable table{"refinement-fits",
                  "Fitted orders of the RMSE",
                  {{"reading"},
                   {"field"},
                   {"estimator"},
                   {"pair"},
                   {"norm"},
                   {"order", "", 3},
                   {"95 % from", "", 3},
                   {"to", "", 3},
                   {"trend"}},
                  {},
                  {"refinement-ratio", "refinement-fixed"},
                  {}};
  for (const auto& [result, reading] : {std::pair(&ratio, "R/Δx fixed"), std::pair(&fixed, "R fixed")})
    for (const auto& fit : result->at("fits")) {
      const auto& interval = fit.at("ci95");
      const auto end = [&interval](std::size_t k) {
        return interval.at(k).is_number() ? Entry(interval.at(k).get<double>()) : Entry();
      };
      table.rows.push_back({reading, text(fit, "field"), text(fit, "estimator"), text(fit, "pair"),
                            text(fit, "norm"),
                            fit.at("order").is_number() ? Entry(number(fit, "order")) : Entry(), end(0),
                            end(1), text(fit, "verdict")});
      table.row_jobs.emplace_back(result == &ratio ? "refinement-ratio" : "refinement-fixed");
      table.figures.push_back(std::string(result == &ratio ? "fig6-ratio-" : "fig6-fixed-") +
                              (text(fit, "field") == cubic ? "cubic" : "sine"));
    }
  return table;
}

/// What the RMSE over all particles does for X^3 + 1 with W1: "asymptotic", "stalled", ..
std::string trend(const Json& result, const std::string& estimator) {
  for (const auto& fit : result.at("fits"))
    if (text(fit, "field") == cubic && text(fit, "estimator") == estimator && text(fit, "pair") == "W1" &&
        text(fit, "norm") == "rmse")
      return text(fit, "verdict");
  throw MissingResult("no fit for " + estimator);
}

Section write(const Results& results) {
  const Json ratio = results.json("refinement-ratio"), fixed = results.json("refinement-fixed");
  const Json &r = ratio.at("rows"), &f = fixed.at("rows");
  Section s;
  s.question = "How do the errors fall when particles are added, and does Figure 6 read as the text says?";
  s.checks = checks(r);
  const double last =
      errors(f, cubic, method("standard, W1")).y.back() / errors(f, cubic, method("improved, W1")).y.back();
  const Series scaled_errors = errors(r, cubic, method("improved, W1"), "dx");
  s.answer = fmt::format(
      "With R/Δx fixed the RMSE of the improved estimate falls with order {} (X³ + 1); with "
      "R fixed the standard one is {}, and the improved one ends {:.2g} times below it.",
      order_check("", scaled_errors.x, scaled_errors.y, 1.5).measured, trend(fixed, "standard"), last);
  const std::string scaled = "The support shrinks with the spacing: R = 4Δx.",
                    kept = "The support stays: R = 0.5 m.";
  s.figures = {
      figure(r, "refinement-ratio", "fig6-ratio-cubic", cubic, "Figure 6a, R/Δx fixed: X³ + 1", scaled, true),
      figure(r, "refinement-ratio", "fig6-ratio-sine", sine, "Figure 6b, R/Δx fixed: sin 5X", scaled, true),
      figure(f, "refinement-fixed", "fig6-fixed-cubic", cubic, "Figure 6a, R fixed: X³ + 1", kept, false),
      figure(f, "refinement-fixed", "fig6-fixed-sine", sine, "Figure 6b, R fixed: sin 5X", kept, false)};
  s.tables = {fits(ratio, fixed)};
  s.notes = {"The paper does not say whether R or R/Δx is kept in Figure 6, so both readings are shown.",
             "Inside means 2R from both ends. An error of order p on a number of "
             "particles that does not grow makes the RMSE over all particles of "
             "order p + 1/2: why 1.5 is expected of an error of order 1 at the ends."};
  return s;
}

}  // namespace

/// Figure 6 of paper 000, in both readings.
SectionPlan planned(Extent extent) {
  const bool long_run = extent == Extent::long_run;
  const auto with = [long_run](const char* option, const char* value) {
    return std::vector<std::string>{
        "oned",        "study",
        "--length",    "5",
        "--n",         long_run ? "20,40,80,160,320,640,1280,2560" : "20,40,80,160,320,640",
        option,        value,
        "--field",     cubic,
        "--field",     sine,
        "--estimator", "standard,improved",
        "--pair",      "W1,W0"};
  };
  return {
      130,
      "refinement",
      "Refinement in one dimension",
      {{"refinement-ratio", with("--radius-over-dx", "4")}, {"refinement-fixed", with("--radius", "0.5")}},
      write};
}

}  // namespace plumb::reports::sections::refinement_1d
