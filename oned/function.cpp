#include "oned/function.hpp"

#include "oned/gradient.hpp"

namespace plumb::oned {

std::vector<FunctionRow> function_rows(const Discretisation& discretisation,
                                       const std::vector<TestField>& fields,
                                       const std::vector<Correction>& pairs) {
  const Cloud<1> cloud = make_cloud(discretisation);
  const RadialKernel<1> kernel = kernel_named<1>(discretisation.kernel);
  const double R = discretisation.support(), h = R / kernel.support;
  const std::vector<Window> supports = windows(cloud, R);
  std::vector<Neighbour<1>> seen;
  std::vector<FunctionRow> rows;
  for (const TestField& field : fields) {
    const std::vector<double> f = values(field, cloud.X);
    for (const Correction pair : pairs)
      for (std::size_t i = 0; i < f.size(); ++i) {
        see(cloud, supports[i], cloud.X[i][0], seen);
        const auto corrected = correct<1>(pair, kernel, h, seen);
        double value = 0;
        for (std::size_t k = 0; k < seen.size(); ++k)
          value += corrected.weight[k] * f[static_cast<std::size_t>(supports[i].first) + k];
        rows.push_back({pair, field.text, cloud.X[i][0], f[i], value, value - f[i]});
      }
  }
  return rows;
}

}  // namespace plumb::oned
