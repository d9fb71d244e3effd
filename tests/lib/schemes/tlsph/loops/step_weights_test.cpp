// The weight of an evaluation in its step is that of its own block: threads are at different evaluations.
#include <gtest/gtest.h>

#include "lib/schemes/tlsph/loops/step_weights.hpp"

namespace plumb {
namespace {

/// Block n of packs of four.
Block block(Index n) {
  return {n * block_slots / 4, (n + 1) * block_slots / 4, 4};
}

TEST(StepWeights, BlocksAreCountedApart) {
  StepWeights weights({0.25, 0.5, 0.75}, 3);
  EXPECT_FALSE(weights.carries());
  weights.count(block(1));
  weights.count(block(1));
  weights.count(block(2));
  EXPECT_EQ(weights.of(block(1)), 0.5);
  EXPECT_EQ(weights.of(block(2)), 0.25) << "another block is ahead of this one";
  weights.count(block(1));
  EXPECT_EQ(weights.of(block(1)), 0.75);
  weights.start_step();
  weights.count(block(1));
  EXPECT_EQ(weights.of(block(1)), 0.25);
}

TEST(StepWeights, OneAloneCountsAtBothEndsOfAStep) {
  StepWeights weights({0.5}, 1);
  EXPECT_TRUE(weights.carries());
  for (int n = 0; n < 2; ++n) {
    weights.count(block(0));
    EXPECT_EQ(weights.of(block(0)), 0.5);
  }
}

}  // namespace
}  // namespace plumb
