// Largest steps of a free square, by form, balance and Poisson's ratio.
#include <gtest/gtest.h>

#include "tests/support/updated.hpp"

namespace plumb::testing {
namespace {

/// Whether small random velocities stay small over 1500 steps of cfl h/c_0.
bool stays_small(const UpdatedOptions& o, double nu, double cfl) {
  const Elastic rubber{17e6, nu, 1100};
  const Cloud<2> cloud = cells<2>({8, 8}, 0.125);
  test::Numbers numbers(3);
  auto body = updated_body<2>(cloud, o, rubber);
  auto state =
      body.start(moving<2>(cloud, [&](const Vec<2>&) { return Vec<2>(1e-4 * numbers.vector<2>()); }));
  const double dt = cfl * body.smoothing_length() / body.law().sound_speed();
  for (int n = 0; n < 1500; ++n) {
    if (body.advance(state, dt)) return false;
    for (int k = 0; k < 2; ++k)
      for (Index i = 0; i < cloud.size(); ++i)
        if (!(std::abs(state.v[k][i]) < 1e-2)) return false;
  }
  return true;
}

struct Limit {
  const char* form;
  bool conservative;
  double nu, cfl;
};
class UpdatedStability : public ::testing::TestWithParam<Limit> {};

TEST_P(UpdatedStability, LimitsOfTheStep) {
  const auto [form, conservative, nu, cfl] = GetParam();
  UpdatedOptions o = conservative ? UpdatedOptions() : printed(form);
  o.form = form;
  EXPECT_TRUE(stays_small(o, nu, 0.95 * cfl));
  EXPECT_FALSE(stays_small(o, nu, 1.07 * cfl));
  // half of h/c of the fastest wave, the default, is 0.7 of the limit at most
  o.speed = "pressure";
  const auto body = updated_body<2>(cells<2>({8, 8}, 0.125), o, {17e6, nu, 1100});
  EXPECT_GT(cfl * body.wave_speed() / body.law().sound_speed(), 0.7);
}
INSTANTIATE_TEST_SUITE_P(Measured, UpdatedStability,
                         ::testing::Values(Limit{"eno", false, 0, 0.352}, Limit{"eno", false, 0.3, 0.545},
                                           Limit{"gno", false, 0, 0.557}, Limit{"gno", false, 0.45, 0.964},
                                           Limit{"eno", true, 0, 0.349}, Limit{"gno", true, 0, 0.487},
                                           Limit{"gno", true, 0.3, 0.627}, Limit{"gno", true, 0.495, 0.715}));

}  // namespace
}  // namespace plumb::testing
