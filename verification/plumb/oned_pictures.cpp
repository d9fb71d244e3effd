#include "verification/plumb/oned_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lib/schemes/tlsph/bonds/estimator_catalogue.hpp"

namespace plumb::app {
namespace {

constexpr std::size_t grey = 6;  // the last of the palette: what is exact

/// An estimator has its colour in every picture: its place in the catalogue.
std::size_t colour_of(const std::string& estimator) {
  const auto names = names_of(EstimatorCatalogue{});
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), estimator) - names.begin()) % grey;
}

/// The series of that name, made if it is not there yet.
reports::Series& series_named(reports::Picture& picture, const std::string& name, reports::Style style) {
  const auto found = std::find_if(picture.series.begin(), picture.series.end(),
                                  [&](const reports::Series& s) { return s.label == name; });
  if (found != picture.series.end()) return *found;
  reports::Series series;
  series.label = name;
  series.style = style;
  picture.series.push_back(series);
  return picture.series.back();
}

void add(reports::Series& series, double x, double y) {
  series.x.push_back(x);
  series.y.push_back(y);
}

/// "standard W1", with the field in front of it if there are several, and the variant behind it.
template <class Row>
std::string label_of(const Row& row, bool several_fields, const std::string& variant) {
  std::string label(name_of(row.pair));
  if constexpr (requires { row.estimator; }) label = row.estimator + " " + label;
  if constexpr (requires { row.field; })
    if (several_fields) label = row.field + ", " + label;
  return variant.empty() ? label : label + ", " + variant;
}

template <class Row>
bool several_fields(const std::vector<Row>& rows) {
  return std::any_of(rows.begin(), rows.end(),
                     [&](const Row& row) { return row.field != rows.front().field; });
}

/// The series of a method: in the colour of its estimator as long as nothing else tells them apart.
template <class Row>
reports::Series& series_of(reports::Picture& picture, const Row& row, const Row& first, bool several,
                           const std::string& variant, reports::Style style) {
  auto& series = series_named(picture, label_of(row, several, variant), style);
  if constexpr (requires { row.estimator; }) {
    if (!several && variant.empty()) series.colour = colour_of(row.estimator);
    series.dashed = row.pair != first.pair;
  }
  return series;
}

reports::Picture empty_picture(const std::string& title, const reports::Axis& x, const reports::Axis& y) {
  reports::Picture picture;
  picture.title = title;
  picture.x = x;
  picture.y = y;
  picture.labels = reports::Labels::legend;
  return picture;
}

/// The ends of the body as lines, those that lie in the picture.
void add_walls(reports::Picture& picture, double length, double from, double to) {
  if (from <= 0) picture.lines.push_back({0, "", true});
  if (to >= length) picture.lines.push_back({length, "", true});
}

template <class Row>
std::string fields_of(const OfVariants<Row>& rows) {
  return rows.empty() || rows.front().second.empty() || several_fields(rows.front().second)
             ? ""
             : " of " + rows.front().second.front().field;
}

}  // namespace

reports::Picture kernel_picture(const oned::Discretisation& discretisation, const oned::KernelView& view,
                                bool gradients) {
  using oned::KernelRow;
  auto picture =
      empty_picture(fmt::format("{} at x = {:g} m, R = {:g} m, dx = {:g} m",
                                gradients ? "Kernel gradients" : "Kernels", view.at, view.R, view.dx),
                    {"X_j", "m"}, {gradients ? "gradient" : "kernel", gradients ? "1/m²" : "1/m"});
  const std::vector<std::pair<const char*, double KernelRow::*>> kernels = {
      {"W", &KernelRow::W}, {"W0", &KernelRow::W0}, {"W1", &KernelRow::W1}};
  const std::vector<std::pair<const char*, double KernelRow::*>> slopes = {{"grad W", &KernelRow::gradW},
                                                                           {"L grad W", &KernelRow::LgradW},
                                                                           {"grad W0", &KernelRow::gradW0},
                                                                           {"L grad W0", &KernelRow::LgradW0},
                                                                           {"grad W1", &KernelRow::gradW1}};
  constexpr std::size_t many = 40;  // more points would hide the lines
  const auto style = !gradients                ? reports::Style::points
                     : view.rows.size() > many ? reports::Style::lines
                                               : reports::Style::both;
  std::size_t colour = 0;
  for (const auto& [name, member] : gradients ? slopes : kernels) {
    auto& series = series_named(picture, name, style);
    series.colour = colour++;
    for (const KernelRow& row : view.rows) add(series, row.x, row.*member);
  }
  if (!gradients) {
    const auto curves = oned::kernel_curves(discretisation, view, 201);
    const std::pair<const char*, const std::vector<double>*> lines[] = {
        {"W between", &curves.W}, {"W0 between", &curves.W0}, {"W1 between", &curves.W1}};
    colour = 0;
    for (const auto& [name, values] : lines) {
      auto& series = series_named(picture, name, reports::Style::lines);
      series.colour = colour++;
      series.x = curves.s;
      series.y = *values;
    }
  }
  add_walls(picture, discretisation.length, view.at - view.R, view.at + view.R);
  return picture;
}

reports::Picture correction_picture(const oned::Discretisation& discretisation,
                                    const OfVariants<oned::ProfileRow>& rows) {
  const bool one = rows.size() == 1;
  auto picture = empty_picture(one ? "The first-order correction along the body"
                                   : "alpha of the first-order correction along the body",
                               {"x", "m"}, {one ? "correction" : "alpha", "1"});
  for (const auto& [variant, profile] : rows)
    for (const oned::ProfileRow& row : profile) {
      add(series_named(picture, one ? "alpha" : variant, reports::Style::lines), row.x, row.alpha);
      if (!one) continue;
      add(series_named(picture, "beta R", reports::Style::lines), row.x, row.beta * discretisation.support());
      add(series_named(picture, "sum V W", reports::Style::lines), row.x, row.VW);
      add(series_named(picture, "negative share", reports::Style::lines), row.x, row.negative);
    }
  add_walls(picture, discretisation.length, 0, discretisation.length);
  return picture;
}

reports::Picture function_picture(const oned::Discretisation& discretisation,
                                  const OfVariants<oned::FunctionRow>& rows) {
  auto picture = empty_picture("Estimated function" + fields_of(rows), {"X", "m"}, {"f"});
  for (const auto& [variant, estimates] : rows) {
    const bool several = several_fields(estimates);
    for (const auto& row : estimates) {
      if (row.pair == estimates.front().pair && variant == rows.front().first) {
        auto& exact = series_named(picture, several ? row.field + ", exact" : "exact", reports::Style::lines);
        exact.dashed = true;
        exact.colour = grey;
        add(exact, row.X, row.exact);
      }
      add(series_of(picture, row, estimates.front(), several, variant, reports::Style::both), row.X,
          row.value);
    }
  }
  add_walls(picture, discretisation.length, 0, discretisation.length);
  return picture;
}

reports::Picture gradient_picture(const oned::Discretisation& discretisation,
                                  const OfVariants<oned::GradientRow>& rows, bool errors) {
  auto picture =
      empty_picture((errors ? "Error of the estimated gradient" : "Estimated gradient") + fields_of(rows),
                    {"X", "m"}, {errors ? "error of dx/dX" : "dx/dX", "1"});
  for (const auto& [variant, estimates] : rows) {
    const bool several = several_fields(estimates);
    for (const auto& row : estimates) {
      const auto& first = estimates.front();
      if (!errors && row.estimator == first.estimator && row.pair == first.pair &&
          variant == rows.front().first) {
        auto& exact = series_named(picture, several ? row.field + ", exact" : "exact", reports::Style::lines);
        exact.dashed = true;
        exact.colour = grey;
        add(exact, row.X, row.exact);
      }
      add(series_of(picture, row, first, several, variant, reports::Style::both), row.X,
          errors ? row.error : row.value);
    }
  }
  add_walls(picture, discretisation.length, 0, discretisation.length);
  return picture;
}

reports::Picture study_picture(const std::vector<std::pair<std::string, oned::RefinementStudy>>& studies) {
  OfVariants<oned::StudyRow> all;
  for (const auto& [variant, study] : studies) all.emplace_back(variant, study.rows);
  auto picture = empty_picture("Root mean square error of the estimated gradient" + fields_of(all),
                               {"dx", "m", reports::Scale::log}, {"RMSE", "1", reports::Scale::log});
  for (const auto& [variant, study] : studies) {
    const bool several = several_fields(study.rows);
    for (const auto& row : study.rows)
      add(series_of(picture, row, study.rows.front(), several, variant, reports::Style::both), row.dx,
          row.norms.rmse);
    for (const auto& fit : study.fits) {  // one triangle, or they would cover each other
      if (fit.norm != "rmse" || fit.trend != Trend::asymptotic) continue;
      const double order = std::round(2 * fit.fit.order) / 2;
      const std::string label = label_of(fit, several, variant);
      for (std::size_t k = 0; k < picture.series.size() && picture.triangles.empty() && order > 0; ++k)
        if (picture.series[k].label == label) picture.triangles.push_back({order, k});
    }
  }
  return picture;
}

reports::Picture response_picture(const OfVariants<oned::ResponseRow>& rows) {
  auto picture = empty_picture("Response inside a uniform lattice", {"θ = k dx", "1"}, {"response", "1"});
  for (const auto& [variant, responses] : rows)
    for (const auto& row : responses) {
      const auto& first = responses.front();
      if (row.estimator == first.estimator && row.pair == first.pair && variant == rows.front().first) {
        auto& exact = series_named(picture, "exact", reports::Style::lines);
        exact.dashed = true;
        exact.colour = grey;
        add(exact, row.theta, row.theta);
      }
      add(series_of(picture, row, first, false, variant, reports::Style::lines), row.theta, row.value);
    }
  return picture;
}

std::string errors_text(const std::string& of, const oned::GradientErrors& errors) {
  std::string text = fmt::format("{}: rms error {:.4g}", of, errors.rmse);
  if (errors.interior_rmse) text += fmt::format(", inside (2 R from the ends) {:.4g}", *errors.interior_rmse);
  if (errors.boundary_max) text += fmt::format(", near the ends {:.4g} at most", *errors.boundary_max);
  return text + '\n';
}

}  // namespace plumb::app
