#include "oned/gradient.hpp"

#include <fmt/format.h>

namespace plumb::oned {

void see(const Cloud<1>& cloud, Window window, double x, std::vector<Neighbour<1>>& neighbourhood) {
  neighbourhood.clear();
  for (Index j = window.first; j < window.last; ++j)
    neighbourhood.push_back({Vec<1>(cloud.X[j][0] - x), cloud.V[j]});
}

Form form_named(std::string_view name) {
  if (name == "printed") return Form::printed;
  if (name == "difference") return Form::difference;
  throw unknown_name("form", name, {"printed", "difference"});
}

namespace {

/// Sum of the part of the stencil c that comes from kernel gradients: what the printed form multiplies x_i
/// with. The estimators are linear in the gradients, so that part is c less the stencil without gradients.
double gradient_sum(StencilFunction<1> stencil, Neighbourhood<1> neighbourhood, CorrectedKernel<1>& corrected,
                    const std::vector<Vec<1>>& c) {
  for (auto& gradient : corrected.gradient) gradient.setZero();
  const auto bonds = stencil(neighbourhood, corrected);
  double sum = 0;
  for (std::size_t k = 0; k < c.size(); ++k) sum += c[k][0] - bonds[k][0];
  return sum;
}

}  // namespace

std::vector<double> estimate(const Cloud<1>& cloud, const RadialKernel<1>& kernel, double R,
                             const GradientMethod& method, const std::vector<double>& values) {
  if (values.size() != cloud.X.size())
    throw InputError(fmt::format("{} values for {} particles", values.size(), cloud.X.size()),
                     "one value per particle is needed", "");
  const StencilFunction<1> stencil = estimator_named<1>(method.estimator);
  const double h = R / kernel.support;
  const std::vector<Window> supports = windows(cloud, R);
  std::vector<Neighbour<1>> neighbourhood;
  std::vector<double> F(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    see(cloud, supports[i], cloud.X[i][0], neighbourhood);
    CorrectedKernel<1> corrected = correct<1>(method.pair, kernel, h, neighbourhood);
    const auto c = stencil(neighbourhood, corrected);
    double sum = 0;
    for (std::size_t k = 0; k < c.size(); ++k)
      sum += (values[static_cast<std::size_t>(supports[i].first) + k] - values[i]) * c[k][0];
    if (method.pair == Correction::none && method.form == Form::printed)
      sum += values[i] * gradient_sum(stencil, neighbourhood, corrected, c);
    F[i] = sum;
  }
  return F;
}

GradientRow GradientTable::row(std::size_t k) const {
  const Column& column = columns[k / X.size()];
  const std::size_t i = k % X.size();
  const double right = exact[column.field][i], value = column.value[i];
  return {
      column.method.estimator, column.method.pair, fields[column.field], X[i], right, value, value - right};
}

GradientTable gradient_table(const Discretisation& discretisation, const std::vector<TestField>& fields,
                             const std::vector<GradientMethod>& methods) {
  const Cloud<1> cloud = make_cloud(discretisation);
  const RadialKernel<1> kernel = kernel_named<1>(discretisation.kernel);
  GradientTable table;
  for (const auto& X : cloud.X) table.X.push_back(X[0]);
  for (const TestField& field : fields) {
    const std::vector<double> x = values(field, cloud.X);
    table.exact.push_back(derivatives(field, cloud.X));
    table.fields.push_back(field.text);
    for (const GradientMethod& method : methods)
      table.columns.push_back(
          {method, table.fields.size() - 1, estimate(cloud, kernel, discretisation.support(), method, x)});
  }
  return table;
}

std::vector<GradientRow> gradient_rows(const Discretisation& discretisation,
                                       const std::vector<TestField>& fields,
                                       const std::vector<GradientMethod>& methods) {
  const GradientTable table = gradient_table(discretisation, fields, methods);
  std::vector<GradientRow> rows;
  for (std::size_t k = 0; k < table.size(); ++k) rows.push_back(table.row(k));
  return rows;
}

}  // namespace plumb::oned
