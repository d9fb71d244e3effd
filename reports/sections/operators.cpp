#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "reports/checks.hpp"
#include "reports/results.hpp"
#include "reports/section.hpp"
#include "reports/studies.hpp"

namespace plumb::reports::sections::operators {
namespace {

using Json = nlohmann::ordered_json;

const std::string finer_cube = "study.spacings=[0.0625,0.0416666666666667,0.03125,0.0208333333333333]";
const std::string finer_rings =
    "study.spacings=[0.03125,0.0208333333333333,0.015625,0.0104166666666667,0.0078125]";

/// One scheme on one kind of cloud.
struct Case {
  std::string id, cloud, scheme, file;
  std::vector<std::string> set;
  bool lattice = false;
};

std::vector<Case> cases() {
  const std::string jitter = "body.jitter=0.2", rings = "generalized_vortex.toml",
                    cube = "trigonometric_cube.toml", plate = "operators.toml",
                    other = "method.momentum=symmetrised", seed = "body.seed=5",
                    amplitude = "study.parameters.amplitude=0.02", early = "study.periods=0.25";
  return {{"operators-lattice", "lattice, 2D", "improved, adjoint", plate, {}, true},
          {"operators-lattice-symmetrised", "lattice, 2D", "improved, symmetrised", plate, {other}, true},
          {"operators-lattice-3d",
           "lattice, 3D",
           "improved, adjoint",
           cube,
           {finer_cube, amplitude, early},
           true},
          {"operators-jitter", "jitter 0.2, 2D", "improved, adjoint", plate, {jitter}},
          {"operators-jitter-standard",
           "jitter 0.2, 2D",
           "standard, adjoint",
           plate,
           {jitter, "method.gradient=standard"}},
          {"operators-jitter-symmetrised", "jitter 0.2, 2D", "improved, symmetrised", plate, {jitter, other}},
          {"operators-jitter-variational",
           "jitter 0.2, 2D",
           "improved, variational",
           plate,
           {jitter, "method.momentum=variational"}},
          {"operators-jitter-compatible",
           "jitter 0.2, 2D",
           "compatible",
           plate,
           {jitter, "method.gradient=compatible"}},
          {"operators-jitter-3d",
           "jitter 0.2, 3D",
           "improved, adjoint",
           cube,
           {finer_cube, amplitude, early, jitter, seed}},
          {"operators-jitter-3d-variational",
           "jitter 0.2, 3D",
           "improved, variational",
           cube,
           {finer_cube, amplitude, early, jitter, seed, "method.momentum=variational"}},
          {"operators-rings", "rings, 2D", "improved, adjoint", rings, {finer_rings}},
          {"operators-rings-symmetrised", "rings, 2D", "improved, symmetrised", rings, {finer_rings, other}},
          {"operators-clipped",
           "clipped lattice, 2D",
           "improved, adjoint",
           rings,
           {finer_rings, "body.layout=cell"}}};
}

/// The key of a quantity in the levels, as `plumb operators` writes it.
std::string key_of(const std::string& name, const std::string& part) {
  const std::string stem = name == "Div P"       ? "div_p"
                           : name == "F"         ? "f"
                           : name == "Laplacian" ? "laplacian"
                                                 : name;
  return stem + "_" + part;
}

std::vector<double> column(const Json& result, const std::string& key) {
  std::vector<double> values;
  for (const auto& level : result.at("levels")) values.push_back(number(level, key));
  return values;
}

const Json& fit_of(const Json& result, const std::string& name, const std::string& part) {
  for (const auto& fit : result.at("fits"))
    if (text(fit, "operator") == name && text(fit, "part") == part) return fit;
  throw MissingResult("no fit of " + name + ", " + part);
}

/// "1.94 [1.90, 1.98]", or what stands in its place.
std::string order_text(const Json& fit) {
  if (!fit.at("order").is_number()) return "round-off";
  const Json& ends = fit.at("ci95");
  if (!ends.at(0).is_number()) return fmt::format("{:.2f}", number(fit, "order"));
  return fmt::format("{:.2f} [{:.2f}, {:.2f}]", number(fit, "order"), ends.at(0).get<double>(),
                     ends.at(1).get<double>());
}

Figure figure(const Results& results, const std::string& id, const std::string& title,
              const std::vector<std::string>& jobs) {
  Figure out{
      id,
      {title, {"particle spacing d", "m", Scale::log}, {"relative error", "", Scale::log}},
      "Inside: a quarter of the body away from its surface; boundary: within two support radii of it. There "
      "the force holds the traction too, so Div P is compared with Div P − P B/V, THEORY (11.4).",
      jobs};
  out.picture.labels = Labels::legend;
  out.picture.height = 480;
  for (const auto& entry : cases())
    if (std::find(jobs.begin(), jobs.end(), entry.id) != jobs.end()) {
      const Json result = results.json(entry.id);
      for (const auto& [name, part] : {std::pair("F", "inside"), std::pair("F", "boundary"),
                                       std::pair("Div P", "inside"), std::pair("Div P", "boundary")})
        out.picture.series.push_back({fmt::format("{}, {}: {}", entry.scheme, name, part),
                                      column(result, "d"), column(result, key_of(name, part))});
    }
  return out;
}

DataTable orders_table() {
  return {"operators-orders",
          "Orders of the operators in L₂, with 95 % intervals",
          {{"cloud"},
           {"scheme"},
           {"F inside"},
           {"F boundary"},
           {"Div P inside"},
           {"Div P boundary"},
           {"Laplacian inside"},
           {"Laplacian boundary"}},
          {}};
}

DataTable constraint_table() {
  return {"operators-constraint",
          "Integration constraint: force under a uniform stress inside, times d over the stress",
          {{"cloud"}, {"scheme"}, {"coarsest", "", 3}, {"finest", "", 3}, {"order"}, {"trend"}},
          {}};
}

void add_rows(const Case& entry, const Json& result, DataTable& orders, DataTable& constraint) {
  std::vector<Entry> row{entry.cloud, entry.scheme};
  for (const char* name : {"F", "Div P", "Laplacian"})
    for (const char* part : {"inside", "boundary"}) row.emplace_back(order_text(fit_of(result, name, part)));
  orders.rows.push_back(row);
  orders.jobs.push_back(entry.id);
  const auto values = column(result, "constraint_inside");
  const Json& fit = fit_of(result, "constraint", "inside");
  constraint.rows.push_back(
      {entry.cloud, entry.scheme, values.front(), values.back(), order_text(fit), text(fit, "verdict")});
  constraint.jobs.push_back(entry.id);
}

Section write(const Results& results) {
  Section s;
  s.question = "At which order are F, Div P and the Laplacian approximated, before any time step is made?";
  DataTable orders = orders_table(), constraint = constraint_table();
  for (const auto& entry : cases()) {
    const Json result = results.json(entry.id);
    add_rows(entry, result, orders, constraint);
    if (!entry.lattice) continue;
    for (const char* name : {"F", "Div P"})
      s.checks.push_back(
          order_check(fmt::format("order of {} inside, {}, {}", name, entry.cloud, entry.scheme),
                      column(result, "d"), column(result, key_of(name, "inside")), 2));
    const auto values = column(result, "constraint_inside");
    s.checks.push_back(
        bound_check(fmt::format("integration constraint inside, {}, {}", entry.cloud, entry.scheme),
                    *std::max_element(values.begin(), values.end()), 1e-12,
                    "round-off of some hundred terms of order 1"));
  }
  for (const char* id : {"operators-jitter-variational", "operators-jitter-compatible"}) {
    const auto values = column(results.json(id), "constraint_inside");
    s.checks.push_back(bound_check(fmt::format("integration constraint inside, jitter 0.2, {}", id + 17),
                                   *std::max_element(values.begin(), values.end()), 1e-10,
                                   "round-off, and what the refined projection leaves"));
  }
  const auto divergence = [&](const char* id) {
    return order_text(fit_of(results.json(id), "Div P", "inside"));
  };
  s.answer = fmt::format(
      "On lattices F and Div P are of second order inside. On jittered clouds Div P has the order {} "
      "with the paper's schemes, {} with the variationally consistent force, {} with compatible bonds.",
      divergence("operators-jitter"), divergence("operators-jitter-variational"),
      divergence("operators-jitter-compatible"));
  s.figures = {figure(results, "operators-lattice-errors", "Lattice, 2D", {"operators-lattice"}),
               figure(results, "operators-jitter-errors", "Jitter 0.2, 2D",
                      {"operators-jitter", "operators-jitter-variational", "operators-jitter-compatible"})};
  s.tables = {orders, constraint};
  s.notes = {
      "Nothing is declared but for the inside of lattices. A force under a uniform stress of order p in "
      "this unit limits Div P to order p − 1: on jittered clouds it is of order 0, so that Div P grows as "
      "1/d. Pointwise consistency of Div P is not needed for convergence: a Galerkin scheme of linear "
      "consistency has an error of order 0 there and converges all the same (section on compatible bonds).",
      "At the boundary compatible bonds hold the traction to a constant share of "
      "Div P; the other schemes spread it over several layers of particles, so "
      "that their difference from Div P − P B/V grows as 1/d from point to point.",
      "The Laplacian of JST has a constant relative error: "
      "it is a smoother, no approximation of known order."};
  return s;
}

}  // namespace

/// Errors of the operators on exact fields, and the integration constraint.
SectionPlan planned(Extent) {
  SectionPlan plan{210, "operators", "Operators on exact fields", {}, write};
  for (const auto& entry : cases())
    plan.jobs.push_back(refinement_job({entry.id, entry.cloud, entry.file, entry.set}, "operators"));
  return plan;
}

}  // namespace plumb::reports::sections::operators
