// Rod of paper 004, 6.3, held just so that it cannot move as a whole: values of an independent implementation.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lib/schemes/implicit/equilibrium.hpp"
#include "lib/schemes/tlsph/boundary/supports.hpp"
#include "tests/lib/schemes/implicit_bodies.hpp"

namespace plumb {
namespace {

/// Energy without that of the hourglass term [J], and largest displacement along the rod [m].
struct PulledRod {
  double energy, longest;
};

/// 17 x 7 x 5 nodes 0.5 m apart, pulled by 1 MPa. Its foot is held in x, its middle in y and z, and a particle above it in y.
PulledRod pulled_rod(double alpha) {
  Cloud<3> cloud = lattice<3>({Vec<3>(0, -1.5, -1), Vec<3>(8, 3, 2)}, {16, 6, 4}, Layout::node);
  const std::vector<double> radius(cloud.X.size(), 1.025);
  SurfaceLoad<3> load;
  load.name = "x+";
  load.steady = true;
  load.traction = [](const Vec<3>&, const Vec<3>& normal, double) -> Vec<3> { return 1e6 * normal; };
  std::vector<Support<3>> supports;
  for (Index i = 0; i < cloud.size(); ++i) {
    const Vec<3>& X = cloud.X[i];
    const auto share = [&](int k, double edge) {
      return std::abs(std::abs(X[k]) - edge) < 1e-9 ? 0.25 : 0.5;
    };
    if (X[0] > 8 - 1e-9) load.places.push_back({i, X, share(1, 1.5) * share(2, 1) * Vec<3>::UnitX()});
    if (X[0] > 1e-9) continue;
    supports.push_back({i, 0});
    const double y = std::abs(X[1]);
    if (y < 1e-9 && std::abs(X[2]) < 1e-9) supports.insert(supports.end(), {{i, 1}, {i, 2}});
    if (y < 1e-9 && X[2] > 1 - 1e-9) supports.push_back({i, 1});
  }
  Actions<3> actions = holding<3>(cloud, supports);
  actions.surface.push_back(load);
  const Elastic steel{30e9, 0.3, 1000};
  const Solid<3> solid = testing::dual_body<3>(cloud, radius, "linear-elastic", steel, alpha);
  State<3> state = make_state(solid);
  EXPECT_TRUE(find_equilibrium<3>(solid, actions, 1, {}, state).completed());
  const Solid<3> bare = testing::dual_body<3>(solid.cloud, radius, "linear-elastic", steel);
  const auto u = unknowns_of(solid, state.u);
  PulledRod rod{testing::energy_of_all(bare).energy(u), 0};
  for (Index i = 0; i < cloud.size(); ++i) rod.longest = std::max(rod.longest, u[3 * i]);
  return rod;
}

/// The scene pulled-rod.toml is a quarter of a larger rod between planes of symmetry, which hold more than that.
TEST(DualSupports, ThePulledRodHasItsValues) {
  const PulledRod plain = pulled_rod(0), stiffened = pulled_rod(1);
  EXPECT_NEAR(plain.energy, 817.65885327, 1e-8);  // to their printed digits
  EXPECT_NEAR(plain.longest, 2.88010814e-4, 1e-12);
  EXPECT_NEAR(stiffened.energy, 807.66810597, 1e-8);
  EXPECT_NEAR(stiffened.longest, 2.81239255e-4, 1e-12);
}

}  // namespace
}  // namespace plumb
