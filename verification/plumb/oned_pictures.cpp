#include "verification/plumb/oned_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumb::app {
namespace {

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

/// "standard W1", with the field in front of it if there are several.
template <class Row>
std::string label_of(const Row& row, bool several_fields) {
  const std::string method = row.estimator + " " + std::string(name_of(row.pair));
  return several_fields ? row.field + ", " + method : method;
}

template <class Row>
bool several_fields(const std::vector<Row>& rows) {
  return std::any_of(rows.begin(), rows.end(),
                     [&](const Row& row) { return row.field != rows.front().field; });
}

reports::Picture empty_picture(const std::string& title, const reports::Axis& x, const reports::Axis& y) {
  reports::Picture picture;
  picture.title = title;
  picture.x = x;
  picture.y = y;
  picture.labels = reports::Labels::legend;
  return picture;
}

}  // namespace

reports::Picture kernel_picture(const oned::KernelView& view, bool gradients) {
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
  const auto style = view.rows.size() > 40 ? reports::Style::lines : reports::Style::both;
  for (const auto& [name, member] : gradients ? slopes : kernels)
    for (const KernelRow& row : view.rows) {
      auto& series = series_named(picture, name, style);
      series.x.push_back(row.x);
      series.y.push_back(row.*member);
    }
  return picture;
}

reports::Picture gradient_picture(const std::vector<oned::GradientRow>& rows, bool errors) {
  auto picture = empty_picture(errors ? "Error of the estimated gradient" : "Estimated gradient", {"X", "m"},
                               {errors ? "error of dx/dX" : "dx/dX", "1"});
  const bool several = several_fields(rows);
  for (const auto& row : rows) {
    if (!errors && row.estimator == rows.front().estimator && row.pair == rows.front().pair) {
      auto& exact = series_named(picture, several ? row.field + ", exact" : "exact", reports::Style::lines);
      exact.dashed = true;
      exact.x.push_back(row.X);
      exact.y.push_back(row.exact);
    }
    auto& series = series_named(picture, label_of(row, several), reports::Style::both);
    series.x.push_back(row.X);
    series.y.push_back(errors ? row.error : row.value);
  }
  return picture;
}

reports::Picture study_picture(const oned::RefinementStudy& study) {
  auto picture = empty_picture("Root mean square error of the estimated gradient",
                               {"dx", "m", reports::Scale::log}, {"RMSE", "1", reports::Scale::log});
  const bool several = several_fields(study.rows);
  for (const auto& row : study.rows) {
    auto& series = series_named(picture, label_of(row, several), reports::Style::both);
    series.x.push_back(row.dx);
    series.y.push_back(row.norms.rmse);
  }
  for (const auto& fit : study.fits) {  // one triangle, or they would cover each other
    if (fit.norm != "rmse" || fit.trend != Trend::asymptotic) continue;
    const double order = std::round(2 * fit.fit.order) / 2;
    const std::string label = label_of(fit, several);
    for (std::size_t k = 0; k < picture.series.size() && picture.triangles.empty() && order > 0; ++k)
      if (picture.series[k].label == label) picture.triangles.push_back({order, k});
  }
  return picture;
}

reports::Picture response_picture(const std::vector<oned::ResponseRow>& rows) {
  auto picture = empty_picture("Response inside a uniform lattice", {"θ = k dx", "1"}, {"response", "1"});
  for (const auto& row : rows) {
    if (row.estimator == rows.front().estimator && row.pair == rows.front().pair) {
      auto& exact = series_named(picture, "exact", reports::Style::lines);
      exact.dashed = true;
      exact.x.push_back(row.theta);
      exact.y.push_back(row.theta);
    }
    auto& series =
        series_named(picture, row.estimator + " " + std::string(name_of(row.pair)), reports::Style::lines);
    series.x.push_back(row.theta);
    series.y.push_back(row.value);
  }
  return picture;
}

}  // namespace plumb::app
