// What counts as unstable, and the measure of spurious modes on motions with known values.
#include "lib/stability/trial.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "lib/scene/read_scene.hpp"
#include "lib/schemes/tlsph/measures/solid_measures.hpp"
#include "tests/support/solids.hpp"

namespace plumb {
namespace {

using testing::rubber_block;

constexpr const char* plate = R"toml([scene]
dimension = 2
end_time = 0.05
[body]
size = [1, 1]
spacing = 0.1
[material]
young = 17e6
poisson = 0.3
density = 1100
[method]
gradient = "improved"
[initial]
velocity = ["1e-3*sin(9*X+5*Y)", "1e-3*sin(7*Y-4*X)"]
)toml";

Trial trial(const std::vector<std::string>& overrides, const StabilityBounds& bounds) {
  return *try_scene(parse_scene(plate, "plate.toml", overrides), bounds, [] { return true; });
}

TEST(Trial, AStableRunReachesItsEnd) {
  const Trial t = trial({}, {.energy_growth = 0.5, .hourglass = 0.5});
  EXPECT_FALSE(t.cause);
  EXPECT_DOUBLE_EQ(t.time, 0.05);
  EXPECT_NEAR(t.energy, 1, 0.1);
  EXPECT_NEAR(t.stretch, 1, 1e-4);  // strains are below 1e-4
}

TEST(Trial, EveryCauseIsFound) {
  EXPECT_EQ(trial({"method.cfl=1.2"}, {.energy_growth = 0.5, .hourglass = {}}).cause, Cause::energy_growth);
  EXPECT_EQ(trial({"method.cfl=4"}, {}).cause, Cause::inverted);
  EXPECT_EQ(
      trial({"initial.velocity=['40*sin(31*X)*cos(31*Y)', '0']"}, {.energy_growth = {}, .hourglass = 0.03})
          .cause,
      Cause::hourglass);
}

// Also where it tears and particles fly off: faster than waves travel, so it does.
TEST(Trial, TheStretchIsThatOfWhatPulls) {
  const auto pulled = [](const char* velocity) {
    const std::string boundaries = fmt::format(
        "[[boundary]]\nface = 'x-'\nkind = 'clamped'\n[[boundary]]\nface = 'x+'\nkind = 'velocity'\n"
        "velocity = ['{}', '0']\n",
        velocity);
    const Scene scene = parse_scene(plate + boundaries, "plate.toml", {"initial.velocity=['0', '0']"});
    return *try_scene(scene, {}, [] { return true; });
  };
  const Trial slow = pulled("1"), torn = pulled("400");
  EXPECT_FALSE(slow.cause);
  EXPECT_NEAR(slow.stretch, 1.05, 1e-12);
  EXPECT_TRUE(torn.cause);
  EXPECT_NEAR(torn.stretch, 1 + 400 * torn.time, 1e-12);
}

// In rubber, velocities of 1e-6 m/s are energies of the size of round-off (THEORY (8.9)); it is not growth,
// and growth is still found when it has risen above it.
TEST(Trial, RoundOffIsNotTakenForGrowth) {
  for (const char* v : {"1e-5", "1e-6", "1e-7", "1e-9", "0"}) {
    const std::string velocity = fmt::format("initial.velocity=['{0}*sin(9*X+5*Y)', '{0}*sin(7*Y-4*X)']", v);
    const StabilityBounds bounds{.energy_growth = 0.5, .hourglass = {}};
    EXPECT_FALSE(trial({velocity}, bounds).cause) << v << " m/s";
    if (v[0] == '0') continue;
    EXPECT_EQ(trial({velocity, "method.cfl=1.2", "scene.end_time=0.2"}, bounds).cause, Cause::energy_growth)
        << v << " m/s";
  }
}

TEST(Trial, ASceneThatCannotBeBuiltIsRefusedAndNotStable) {
  const Trial t = trial({"method.gradient=compatible", "method.beta=0.55", "body.jitter=0.3"}, {});
  EXPECT_FALSE(t.cause) << "nothing ran";
  EXPECT_FALSE(t.stable());
  // sentences: the problem and why, each with its stop
  EXPECT_NE(t.refused.find(". "), std::string::npos) << t.refused;
  EXPECT_EQ(t.refused.back(), '.') << t.refused;
  EXPECT_TRUE(trial({}, {}).stable());
}

TEST(Trial, StopsWhenAsked) {
  int steps = 0;
  EXPECT_FALSE(try_scene(parse_scene(plate, "plate.toml"), {}, [&steps] { return ++steps < 5; }));
  EXPECT_EQ(steps, 5);
}

TEST(HourglassShare, IsZeroForAffineMotionAndKnownForACheckerboard) {
  for (const double amplitude : {0.01, 0.1, 0.4}) {
    const Index n = 60;
    const auto solid = rubber_block<2>(n, Layout::node, 0);
    const double d = solid.cloud.spacing, a = amplitude * d;
    State<2> affine = make_state(solid), board = make_state(solid);
    for (Index i = 0; i < solid.cloud.size(); ++i) {
      const Vec<2>& X = solid.cloud.X[i];
      const long parity = std::lround(X[0] / d) + std::lround(X[1] / d);
      set_vector<2>(affine.u, solid.bonds.slots.of(i),
                    Vec<2>(0.3 * X[0] - 0.2 * X[1], 0.1 * X[0] + amplitude * X[1]));
      set_vector<2>(board.u, solid.bonds.slots.of(i), Vec<2>(parity % 2 ? a : -a, 0));
    }
    EXPECT_LT(hourglass_share(solid, affine), 1e-13) << "rounding of F";
    // Neighbours are 2a apart beside their distance; inside, F sees nothing of it. THEORY (8.8). The two
    // outermost layers of 60 see some: 7 % of the pairs.
    EXPECT_NEAR(hourglass_share(solid, board), 2 * a / std::hypot(d, 2 * a), 0.05 * amplitude);
  }
}

}  // namespace
}  // namespace plumb
