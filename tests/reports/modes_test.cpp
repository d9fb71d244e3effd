// Pictures of modes: the axis is that of the largest motion, the layer that of its particle.
#include "reports/modes.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <variant>

namespace plumb::reports::modes_test {
namespace {

using Json = nlohmann::ordered_json;

TEST(Modes, AreDrawnAlongTheLargestMotionInItsLayer) {
  const Json mode = {{"spacing", 0.5},
                     {"X", {{0, 0, 0}, {0.5, 0, 0}, {0, 0, 0.5}, {0.5, 0, 0.5}}},
                     {"u", {{0.1, 0.2, 0.3}, {0.1, 0.2, 0.4}, {0.3, -0.9, 0.5}, {0.6, 0.6, 0.6}}}};
  const Picture picture = mode_picture(mode, "mode");
  const auto& drawn = std::get<PointMap>(picture.map);
  EXPECT_EQ(drawn.label, "motion along Y");
  ASSERT_EQ(drawn.x.size(), 2u);
  // a motion of 1 is drawn as a third of a spacing
  EXPECT_NEAR(drawn.x[0], 0.5 / 3 * 0.3, 1e-15);
  EXPECT_NEAR(drawn.y[0], 0.5 / 3 * -0.9, 1e-15);
  EXPECT_NEAR(drawn.x[1], 0.5 + 0.5 / 3 * 0.6, 1e-15);
  EXPECT_EQ(drawn.z[0], -0.9);
  EXPECT_EQ(drawn.z[1], 0.6);
}

}  // namespace
}  // namespace plumb::reports::modes_test
