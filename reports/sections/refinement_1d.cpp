#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "reports/checks.hpp"
#include "reports/results.hpp"
#include "reports/section.hpp"

namespace plumb::reports::sections {
namespace {

using Json = nlohmann::ordered_json;

struct Method {
  std::string estimator, pair, name;
};
const std::vector<Method> methods{{"standard", "W1", "standard, W1"},
                                  {"improved", "W1", "improved, W1"},
                                  {"improved", "W0", "improved, W0"}};
const std::string cubic = "poly:1,0,0,1", sine = "sin:5";

Series errors(const Json& rows, const std::string& field, const Method& m, const std::string& x = "n",
              const std::string& norm = "rmse") {
  return series_of(rows, {{"field", field}, {"estimator", m.estimator}, {"pair", m.pair}}, x, norm, m.name);
}

Figure figure(const Json& rows, const std::string& job, const std::string& id, const std::string& field,
              const std::string& title, const std::string& caption, bool with_slope) {
  Picture p{title, {"number of particles N", "", Scale::log}, {"RMSE of dx/dX", "", Scale::log}};
  for (const auto& m : methods) p.series.push_back(errors(rows, field, m));
  p.x.ticks = p.series[0].x;
  if (with_slope) p.triangles = {{-1.5, 1}};
  return {id, p, caption, {job}};
}

/// RMSE of the last level over that of the first.
double fall(const Series& s) {
  return s.y.back() / s.y.front();
}

std::vector<Check> checks(const Json& rows) {
  std::vector<Check> out;
  const double known[] = {1.130, 0.4093, 0.1464, 0.05208};
  const Series improved = errors(rows, cubic, methods[1]);
  for (std::size_t k = 0; k < 4; ++k)
    out.push_back(number_check(fmt::format("RMSE for X³ + 1, improved W1, N = {:g}", improved.x[k]),
                               improved.y[k], known[k], 5e-4, "four digits known"));
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
      table.figures.push_back(std::string(result == &ratio ? "fig6-ratio-" : "fig6-fixed-") +
                              (text(fit, "field") == cubic ? "cubic" : "sine"));
    }
  return table;
}

DataTable sentences(const Json& ratio, const Json& fixed) {
  const auto both = [&](const std::string& field, const Method& m) {
    return fmt::format(
        "from N = {:g} to {:g} it falls to {:.2g} of itself with R/Δx fixed, to {:.2g} with R fixed",
        errors(ratio, field, m).x.front(), errors(ratio, field, m).x.back(), fall(errors(ratio, field, m)),
        fall(errors(fixed, field, m)));
  };
  // A fall to more than half over five doublings is called a plateau: order below 0.2.
  const auto plateau = [](const Series& s) { return fall(s) > 0.5 * std::pow(0.5, 0.0); };
  const auto status = [](bool with_ratio, bool with_fixed) {
    return with_ratio == with_fixed ? (with_ratio ? "reproduced" : "contradicted") : "ambiguous";
  };
  const bool better = fall(errors(ratio, cubic, methods[2])) < fall(errors(ratio, cubic, methods[1])) ||
                      errors(ratio, cubic, methods[2]).y.back() < errors(ratio, cubic, methods[1]).y.back() ||
                      errors(fixed, cubic, methods[2]).y.back() < errors(fixed, cubic, methods[1]).y.back();
  return account(
      "account-6", "What section 4.1 says about Figure 6",
      {{"Fig. 6", "the RMSE of classical SPH does not decrease as more particles are used",
        status(plateau(errors(ratio, cubic, methods[0])), plateau(errors(fixed, cubic, methods[0]))),
        "X³ + 1, standard W1: " + both(cubic, methods[0])},
       {"Fig. 6", "the RMSE of the proposed estimate decreases",
        status(!plateau(errors(ratio, cubic, methods[1])), !plateau(errors(fixed, cubic, methods[1]))),
        "X³ + 1, improved W1: " + both(cubic, methods[1])},
       {"Fig. 6b", "for the sine the RMSE plateaus, because its Taylor series does not end",
        status(plateau(errors(ratio, sine, methods[1])), plateau(errors(fixed, sine, methods[1]))),
        "sin 5X, improved W1: " + both(sine, methods[1])},
       {"Fig. 6", "among the proposed variants the one with W0 does best",
        better ? "reproduced" : "contradicted",
        fmt::format("at the largest N, X³ + 1: W0 {:.3g} against W1 {:.3g} (R/Δx fixed), {:.3g} against "
                    "{:.3g} (R fixed)",
                    errors(ratio, cubic, methods[2]).y.back(), errors(ratio, cubic, methods[1]).y.back(),
                    errors(fixed, cubic, methods[2]).y.back(), errors(fixed, cubic, methods[1]).y.back())}},
      {"refinement-ratio", "refinement-fixed"});
}

Section write(const Results& results) {
  const Json ratio = results.json("refinement-ratio"), fixed = results.json("refinement-fixed");
  const Json &r = ratio.at("rows"), &f = fixed.at("rows");
  Section s;
  s.question = "How do the errors fall when particles are added, and does Figure 6 read as the text says?";
  s.checks = checks(r);
  const double last = errors(f, cubic, methods[0]).y.back() / errors(f, cubic, methods[1]).y.back();
  s.answer = fmt::format(
      "With R/Δx fixed every estimate converges (X³ + 1: {} for the improved one over all particles); only "
      "with R fixed "
      "does the standard one stall, and there the improved one ends {:.2g} times below it.",
      order_check("", errors(r, cubic, methods[1], "dx").x, errors(r, cubic, methods[1], "dx").y, 1.5)
          .measured,
      last);
  const std::string scaled = "The support shrinks with the spacing: R = 4Δx.",
                    kept = "The support stays: R = 0.5 m.";
  s.figures = {
      figure(r, "refinement-ratio", "fig6-ratio-cubic", cubic, "Figure 6a, R/Δx fixed: X³ + 1", scaled, true),
      figure(r, "refinement-ratio", "fig6-ratio-sine", sine, "Figure 6b, R/Δx fixed: sin 5X", scaled, true),
      figure(f, "refinement-fixed", "fig6-fixed-cubic", cubic, "Figure 6a, R fixed: X³ + 1", kept, false),
      figure(f, "refinement-fixed", "fig6-fixed-sine", sine, "Figure 6b, R fixed: sin 5X", kept, false)};
  s.tables = {sentences(r, f), fits(ratio, fixed)};
  s.notes = {
      "The paper does not say whether R or R/Δx is kept in Figure 6, so both readings are shown; a sentence "
      "that holds in one of them "
      "only is called ambiguous. A RMSE that keeps more than half of itself over the whole range is called a "
      "plateau.",
      "Inside means 2R from both ends. The error at the ends is of first order and sits on a number of "
      "particles that does not "
      "grow, which makes the RMSE over all particles of order 1.5."};
  return s;
}

}  // namespace

/// Figure 6 of paper 000, in both readings.
SectionPlan refinement_1d(bool long_run) {
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
      30,
      "refinement",
      "Refinement in one dimension",
      {{"refinement-ratio", with("--radius-over-dx", "4")}, {"refinement-fixed", with("--radius", "0.5")}},
      write};
}

}  // namespace plumb::reports::sections
