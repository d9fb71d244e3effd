// Runge-Kutta stages over the fields of any state.
#include "lib/schemes/blend.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace plumb::testing {
namespace {

/// y' = z, z' = -y + sin(2t)/10 at every slot, and a field that stages must leave alone.
struct Oscillators {
  Field y{1, 3000, 0}, z{2, 3000, 0}, mark{1, 3000, 0};
  double time = 0;
  long step = 0;

  template <class Visit>
  void fields(Visit&& visit) {
    visit(FieldInfo{"y", "m"}, y);
    visit(FieldInfo{"mark", "", Role::history}, mark);
    visit(FieldInfo{"z", "m/s"}, z);
  }
};

std::optional<Trouble> oscillate(const Oscillators& s, double t, Oscillators& rate) {
  for (Index i = 0; i < 3000; ++i) {
    rate.y[0][i] = s.z[1][i];
    rate.z[0][i] = 7;
    rate.z[1][i] = -s.y[0][i] + 0.1 * std::sin(2 * t);
    rate.mark[0][i] = 1e9;
  }
  return std::nullopt;
}

/// Error at t = 1 of y(0) = 1, z(0) = 0: y = cos t + (2 sin t - sin 2t)/30.
double error_after(int steps) {
  Oscillators state, before, rate;
  std::fill_n(state.y[0], 3000, 1.0);
  std::fill_n(state.mark[0], 3000, 5.0);
  for (int n = 0; n < steps; ++n)
    EXPECT_FALSE(ssp_rk3_step(state, before, rate, 3000, 1.0 / steps, oscillate));
  EXPECT_EQ(state.step, steps);
  EXPECT_NEAR(state.time, 1, 1e-14);
  EXPECT_EQ(state.mark[0][2999], 5);
  EXPECT_NEAR(state.z[0][2999], 7, 1e-12);
  EXPECT_EQ(state.y[0][0], state.y[0][2999]);
  return std::abs(state.y[0][2999] - std::cos(1.0) - (2 * std::sin(1.0) - std::sin(2.0)) / 30);
}

TEST(Blend, ThirdOrderWithALoadThatVariesInTime) {
  // 64 steps: the next term of the error is about 1/64 of the first
  EXPECT_NEAR(std::log2(error_after(64) / error_after(128)), 3, 0.05);
}

TEST(Blend, TroubleInAnyStageLeavesTheState) {
  for (int bad = 0; bad < 3; ++bad) {
    Oscillators state, before, rate;
    std::fill_n(state.y[0], 3000, 1.0);
    int stage = 0;
    const auto trouble =
        ssp_rk3_step(state, before, rate, 3000, 0.1,
                     [&](const Oscillators& s, double t, Oscillators& r) -> std::optional<Trouble> {
                       if (stage++ == bad) return Trouble{42, "y", 0};
                       return oscillate(s, t, r);
                     });
    ASSERT_TRUE(trouble);
    EXPECT_EQ(trouble->particle, 42);
    EXPECT_EQ(state.y[0][7], 1);
    EXPECT_EQ(state.z[1][7], 0);
    EXPECT_EQ(state.time, 0);
    EXPECT_EQ(state.step, 0);
  }
}

}  // namespace
}  // namespace plumb::testing
