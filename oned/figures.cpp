#include "oned/figures.hpp"

#include <fmt/format.h>

#include <array>

#include "oned/explorer.hpp"
#include "oned/response.hpp"

namespace plumb::oned {
namespace {

const std::vector<Method> figure_5_methods = {
    {"standard", Pair::W1}, {"improved", Pair::W1}, {"improved", Pair::W0}};

struct Column {
  const char* label;
  double KernelRow::*member;
};

template <std::size_t n>
std::vector<Curve> columns_of(const KernelView& view, const std::array<Column, n>& columns) {
  std::vector<Curve> curves;
  for (const Column& column : columns) {
    Curve curve{column.label, {}, {}};
    for (const KernelRow& row : view.rows) {
      curve.x.push_back(row.x);
      curve.y.push_back(row.*column.member);
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

std::string label_of(const std::string& estimator, Pair pair) {
  return estimator + ", " + std::string(name_of(pair));
}

std::vector<double> positions_of(const Cloud<1>& cloud) {
  std::vector<double> X;
  for (const Vec<1>& position : cloud.X) X.push_back(position[0]);
  return X;
}

/// The exact gradient and its estimates at every particle of the paper's cloud (0, 5), dx = 1/8, R = 4 dx.
std::vector<Curve> estimates_of(const Field& field, const std::vector<Method>& methods) {
  const Discretisation paper;
  const Cloud<1> cloud = make_cloud(paper);
  const RadialKernel<1> kernel = kernel_named<1>(paper.kernel);
  const std::vector<double> X = positions_of(cloud);
  std::vector<Curve> curves{{"exact", X, derivatives(field, cloud.X)}};
  for (const Method& method : methods)
    curves.push_back({label_of(method.estimator, method.pair), X,
                      estimate(cloud, kernel, paper.support(), method, values(field, cloud.X))});
  return curves;
}

/// The estimates minus the exact curve, which comes first.
std::vector<Curve> errors_of(const std::vector<Curve>& estimates) {
  std::vector<Curve> errors(estimates.begin() + 1, estimates.end());
  for (Curve& curve : errors)
    for (std::size_t i = 0; i < curve.y.size(); ++i) curve.y[i] -= estimates[0].y[i];
  return errors;
}

/// One curve per method of a study's rows for one field, y over x as the two functions read them.
template <class X, class Y>
std::vector<Curve> curves_of(const Study& study, const std::string& field, X x, Y y) {
  std::vector<Curve> curves;
  for (const StudyRow& row : study.rows) {
    if (row.field != field) continue;
    const std::string label = label_of(row.estimator, row.pair);
    if (curves.empty() || curves.back().label != label) curves.push_back({label, {}, {}});
    curves.back().x.push_back(x(row));
    curves.back().y.push_back(y(row));
  }
  return curves;
}

std::vector<std::string> rmse_notes(const Study& study, const std::string& field) {
  std::vector<std::string> notes;
  for (const StudyFit& f : study.fits)
    if (f.field == field && f.norm == "rmse")
      notes.push_back(fmt::format("{}: {}, order {:.2f} [{:.2f}, {:.2f}]", label_of(f.estimator, f.pair),
                                  name_of(f.trend), f.fit.order, f.fit.lower, f.fit.upper));
  return notes;
}

constexpr std::array<std::pair<const char*, const char*>, 2> figure_6_fields = {
    {{"poly:1,0,0,1", "X³ + 1"}, {"sin:5", "sin(5X)"}}};

}  // namespace

std::vector<Chart> figure_2() {
  Discretisation d;
  d.length = 2;
  d.n = 200;
  d.radius = {1, true};
  constexpr std::array<Column, 3> kernels = {
      {{"W", &KernelRow::W}, {"W0", &KernelRow::W0}, {"W1", &KernelRow::W1}}};
  constexpr std::array<Column, 5> gradients = {{{"grad W", &KernelRow::gradW},
                                                {"L grad W", &KernelRow::LgradW},
                                                {"grad W0", &KernelRow::gradW0},
                                                {"L grad W0", &KernelRow::LgradW0},
                                                {"grad W1", &KernelRow::gradW1}}};
  std::vector<Chart> charts;
  for (const double at : {1.0, 0.0}) {
    const KernelView view = explore(d, at);
    const auto note = [&](const char* name) {
      for (const auto& [key, sum] : view.sums)
        if (key == name) return fmt::format("sum {} = {:.6g}", name, sum);
      return std::string();
    };
    charts.push_back({at > 0 ? "figure-2a" : "figure-2c",
                      fmt::format("Kernels at x = {:g} m", at),
                      "X_j",
                      "m",
                      "kernel",
                      "1/m",
                      columns_of(view, kernels),
                      false,
                      false,
                      {note("VW"), note("VW0"), note("VW1")}});
    charts.push_back({at > 0 ? "figure-2b" : "figure-2d",
                      fmt::format("Kernel gradients at x = {:g} m", at),
                      "X_j",
                      "m",
                      "gradient",
                      "1/m²",
                      columns_of(view, gradients),
                      false,
                      false,
                      {note("VXgradW"), note("VXgradW0"), note("VXLgradW0"), note("VXgradW1")}});
  }
  return charts;
}

std::vector<Chart> figure_4() {
  const Field field = parse_field("poly:1,1");
  const Cloud<1> cloud = make_cloud({});
  const std::string setting = "x = X + 1, dx = 1/8 m, R = 4 dx, W1";
  return {{"figure-4a",
           "Field, " + setting,
           "X",
           "m",
           "x",
           "m",
           {{"particles", positions_of(cloud), values(field, cloud.X)}},
           false,
           false,
           {}},
          {"figure-4b",
           "Gradient, " + setting,
           "X",
           "m",
           "dx/dX",
           "1",
           estimates_of(field, {{"standard", Pair::W1}, {"bond", Pair::W1}, {"improved", Pair::W1}}),
           false,
           false,
           {}}};
}

std::vector<Chart> figure_5() {
  std::vector<Chart> charts, errors;
  const std::string setting = ", dx = 1/8 m, R = 4 dx";
  for (const auto& [text, title, letter] :
       {std::array{"poly:1,0,1", "x = X² + 1", "ac"}, std::array{"poly:1,0,0,1", "x = X³ + 1", "bd"}}) {
    const auto curves = estimates_of(parse_field(text), figure_5_methods);
    charts.push_back({fmt::format("figure-5{}", letter[0]),
                      "Gradient of " + (title + setting),
                      "X",
                      "m",
                      "dx/dX",
                      "1",
                      curves,
                      false,
                      false,
                      {}});
    errors.push_back({fmt::format("figure-5{}", letter[1]),
                      "Error of the gradient of " + (title + setting),
                      "X",
                      "m",
                      "error of dx/dX",
                      "1",
                      errors_of(curves),
                      false,
                      false,
                      {}});
  }
  charts.insert(charts.end(), errors.begin(), errors.end());
  return charts;
}

Study figure_6_study(Reading reading) {
  Discretisation d;
  if (reading == Reading::fixed_radius) d.radius = {0.5, true};
  std::vector<Field> fields;
  for (const auto& [text, title] : figure_6_fields) fields.push_back(parse_field(text));
  return refine(d, {40, 80, 160, 320, 640, 1280, 2560, 5120}, fields, figure_5_methods);
}

std::vector<Chart> figure_6(Reading reading) {
  const Study study = figure_6_study(reading);
  const bool fixed = reading == Reading::fixed_radius;
  std::vector<Chart> charts;
  for (const auto& [field, title] : figure_6_fields)
    charts.push_back(
        {fmt::format("figure-6{}-{}", charts.empty() ? "a" : "b", fixed ? "fixed-radius" : "fixed-ratio"),
         fmt::format("RMSE of the gradient of {}, {}", title, fixed ? "R = 0.5 m fixed" : "R = 4 dx"), "N",
         "1", "RMSE", "1",
         curves_of(
             study, field, [](const StudyRow& r) { return static_cast<double>(r.n); },
             [](const StudyRow& r) { return r.norms.rmse; }),
         true, true, rmse_notes(study, field)});
  return charts;
}

std::vector<Chart> cost_charts(const Study& study, const std::string& name) {
  std::vector<Chart> charts;
  for (const StudyRow& row : study.rows) {
    const std::string title = fmt::format("Error against cost, {}", row.field);
    if (!charts.empty() && charts.back().title == title) continue;
    charts.push_back({fmt::format("{}-{}", name, charts.size() + 1),
                      title,
                      "CPU time",
                      "s",
                      "RMSE",
                      "1",
                      curves_of(
                          study, row.field, [](const StudyRow& r) { return r.cpu_s; },
                          [](const StudyRow& r) { return r.norms.rmse; }),
                      true,
                      true,
                      {}});
  }
  return charts;
}

Chart response_chart() {
  const std::vector<Method> methods = {{"standard", Pair::W1}, {"bond", Pair::W1}, {"improved", Pair::W1}};
  Chart chart{"response", "Response inside a uniform lattice, R = 4 dx",
              "θ = k dx", "1",
              "response", "1",
              {},         false,
              false,      {}};
  for (const ResponseRow& row : response_rows("cubic", 4, methods, 100)) {
    if (chart.curves.empty() || chart.curves.back().label != row.estimator)
      chart.curves.push_back({row.estimator, {}, {}});
    chart.curves.back().x.push_back(row.theta);
    chart.curves.back().y.push_back(row.value);
  }
  chart.curves.push_back({"exact", chart.curves.front().x, chart.curves.front().x});
  return chart;
}

}  // namespace plumb::oned
