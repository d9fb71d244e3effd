// The growth that dissipation leaves, or makes, by iteration: on small bodies against all eigenvalues.
#include "lib/spectrum/damped_growth.hpp"

#include <gtest/gtest.h>

#include "lib/scene/read_scene.hpp"
#include "lib/scene/tlsph.hpp"
#include "lib/spectrum/spectrum.hpp"

namespace plumb {
namespace {

/// A square of 16 particles whose symmetrised force makes motions grow, with JST dissipation of fourth order.
LinearOperator<2> square(double eta4) {
  const Scene scene = parse_scene(
      "[scene]\ndimension = 2\nmax_steps = 2\n[body]\nsize = [1, 1]\nspacing = 0.25\nlayout = "
      "\"cell\"\njitter = 0.3\n"
      "[material]\nyoung = 17e6\npoisson = 0.495\ndensity = 1100\n"
      "[method]\nmomentum = \"symmetrised\"\ngradient = \"standard\"\npair = \"W1\"\nbeta = 0.9\n[jst]\n",
      "test.toml", {"jst.eta4=" + std::to_string(eta4)});
  const TlsphBody<2> simulation = make_tlsph<2>(scene);
  return {simulation.solid, simulation.supports};
}

TEST(DampedGrowth, ByIterationIsThatOfAllEigenvalues) {
  std::vector<double> rates;
  for (const double eta4 : {0.004, 0.016}) {
    SCOPED_TRACE(eta4);
    LinearOperator<2> op = square(eta4);
    const SparseMatrix K = op.stiffness_matrix();
    const double largest = spectrum_of(op).largest;
    const Growth all = dense_damped_growth(op, K), some = damped_growth(op, K, largest);
    rates.push_back(all.rate);
    ASSERT_GT(all.rate, some.resolution) << "only what is faster is sure to be found";
    EXPECT_NEAR(some.rate, all.rate, 5e-4 * all.rate);  // three digits are promised
    EXPECT_EQ(all.resolution, 0);
  }
  EXPECT_GT(std::abs(rates[0] - rates[1]), 0.5 * rates[0]) << "dissipation must matter here";
}

}  // namespace
}  // namespace plumb
