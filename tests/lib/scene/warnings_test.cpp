#include "lib/scene/warnings.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include "lib/scene/read_scene.hpp"
#include "lib/scene/tlsph.hpp"
#include "lib/schemes/tlsph/measures/solid_measures.hpp"
#include "lib/spectrum/spectrum.hpp"

namespace plumb {
namespace {

/// A free square of 9^2 cells, or cube, of a stiff material; without warnings as it stands.
Scene scene_with(const std::vector<std::string>& changes, int dimension = 2, const std::string& more = "") {
  const std::string text = dimension == 2 ? R"toml(
[scene]
name = "square"
dimension = 2
max_steps = 10
[body]
size = [0.9, 0.9]
spacing = 0.1
layout = "cell"
[material]
young = "17 MPa"
poisson = 0.3
density = 1100
)toml"
                                          : R"toml(
[scene]
name = "cube"
dimension = 3
max_steps = 10
[body]
size = [1, 1, 1]
spacing = 0.2
layout = "cell"
[material]
young = "17 MPa"
poisson = 0.495
density = 1100
)toml";
  return parse_scene(text + more, "test.toml", changes);
}

std::vector<std::string> warned(const std::vector<std::string>& changes) {
  return make_tlsph<2>(scene_with(changes)).warnings;
}

bool one(const std::vector<std::string>& warnings, const std::string& part) {
  return warnings.size() == 1 && warnings[0].find(part) != std::string::npos;
}

TEST(Warnings, ThereAreNoneForTheDefaults) {
  EXPECT_TRUE(warned({}).empty());
  EXPECT_TRUE(warned({"initial.velocity=['2*X', 'sin(3*X)']"}).empty());
}

TEST(Warnings, WideKernelNearAFreeFace) {
  const std::vector<std::string> paper{"method.momentum=symmetrised", "method.integrator=rk3",
                                       "jst.eta4=0.015625"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), paper.begin(), paper.end());
    return warned(more);
  };
  EXPECT_TRUE(with({}).empty());
  EXPECT_TRUE(one(with({"method.beta=1.2"}), "near a free face")) << with({"method.beta=1.2"}).size();
  EXPECT_TRUE(one(with({"method.beta=0.8", "method.kernel=quintic"}), "near a free face"));  // R = 2.4 d
  const auto at_the_limit =
      with({"method.beta=1"});  // R = 2 d: the growth was measured there; a lattice distance too
  EXPECT_TRUE(at_the_limit.size() == 2 && one({at_the_limit[0]}, "near a free face"));
  std::string rollers;
  for (const char* face : {"x-", "x+", "y-", "y+"})
    rollers += fmt::format("[[boundary]]\nface = \"{}\"\nkind = \"roller\"\n", face);
  EXPECT_TRUE(make_tlsph<2>(scene_with({"method.momentum=symmetrised", "method.beta=1.2"}, 2, rollers))
                  .warnings.empty());
  EXPECT_TRUE(one(warned({"method.momentum=symmetrised"}), "nothing damps"));
  EXPECT_TRUE(warned({"method.beta=1.1"}).empty());
  EXPECT_TRUE(one(warned({"method.beta=1.25"}), "modes are softer"));
}

/// The rule behind that warning, by eigenvalues: the numbers in its text and the factor past R = 2 d.
TEST(Warnings, GrowthPastTwoSpacingsIsAsTheTextSays) {
  const auto spectrum = [](const char* momentum, double beta) {
    const auto simulation = make_tlsph<3>(
        scene_with({std::string("method.momentum=") + momentum, fmt::format("method.beta={}", beta)}, 3));
    LinearOperator<3> op(simulation.solid, simulation.supports);
    return spectrum_of(op);
  };
  EXPECT_NEAR(spectrum("symmetrised", 0.9).growth.rate, 0.009, 5e-4);  // half of the last digit printed
  EXPECT_NEAR(spectrum("symmetrised", 1.0).growth.rate, 0.044, 5e-4);
  EXPECT_NEAR(spectrum("symmetrised", 1.2).growth.rate, 0.087, 5e-4);
  EXPECT_EQ(spectrum("adjoint", 0.9).low.spurious_below_smooth.found, 0);
  EXPECT_EQ(spectrum("adjoint", 1.2).low.spurious_below_smooth.found, 28);
}

TEST(Warnings, JstAboveItsStepCap) {
  const std::vector<std::string> strong{"method.integrator=rk3", "jst.eta4=0.5", "method.cfl=0.9"};
  EXPECT_TRUE(one(warned(strong), "JST limits the time step"));
  EXPECT_TRUE(warned({"method.integrator=rk3", "jst.eta4=0.001"}).empty());
  // a fixed step is not limited: 3 % above the cap it is warned of, and blows up
  const double cap = make_tlsph<2>(scene_with(strong)).solid.step_limit;
  const auto fixed = [&](double share) {
    return scene_with({"method.integrator=rk3", "jst.eta4=0.5",
                       fmt::format("method.time_step={}", share * cap),
                       "initial.velocity=['1e-3*X*Y', '1e-3*X*Y*Y']", "scene.max_steps=600"});
  };
  EXPECT_TRUE(one(make_tlsph<2>(fixed(1.03)).warnings, "what JST bears"));
  EXPECT_TRUE(make_tlsph<2>(fixed(0.97)).warnings.empty());
  const auto completes = [&](double share) {
    auto simulation = make_tlsph<2>(fixed(share));
    return run<2>(simulation.solid, simulation.state, simulation.integrator, simulation.control).completed();
  };
  EXPECT_TRUE(completes(0.97));
  EXPECT_FALSE(completes(1.03));
}

TEST(Warnings, SupportRadiusOnALatticeDistance) {
  EXPECT_TRUE(one(warned({"method.beta=1.0"}), "R = 2 d"));
  // the diagonal neighbour, at sqrt 2 spacings; quintic: R = 3 beta d
  EXPECT_TRUE(one(warned({"method.kernel=quintic", "method.beta=0.47140452079103168"}), "R = 1.41421356"));
  EXPECT_TRUE(warned({"method.beta=1.0000001"}).empty());
  EXPECT_TRUE(warned({"method.beta=1.0", "body.jitter=0.1"}).empty());
}

TEST(Warnings, AliasedInitialVelocity) {
  const auto wave = [](double k) { return fmt::format("initial.velocity=['0', 'sin({}*X)']", k); };
  const double pi = 3.14159265358979;
  for (const double theta : {0.5, 1.5, 2.5}) EXPECT_TRUE(warned({wave(theta / 0.1)}).empty()) << theta;
  for (const double theta : {3.3, 4.5, 2 * pi, 7.0, 4 * pi, 14.0})
    EXPECT_TRUE(one(warned({wave(theta / 0.1)}), "aliased along x")) << theta;
  EXPECT_TRUE(one(warned({"initial.velocity=['cos(50*Y)', '0']"}), "aliased along y"));
  EXPECT_TRUE(one(warned({"initial.velocity=['1000 + sin(50*X)', '0']"}), "aliased along x"));
  EXPECT_TRUE(warned({"initial.velocity=['X > 0.5 ? 1 : 0', '3']"}).empty());  // a step is no wave
}

}  // namespace
}  // namespace plumb
