// Studies of schemes other than the total Lagrangian one: what a snapshot says of a point, and the same study
// by both.
#include "mms/scheme_level.hpp"

#include <gtest/gtest.h>

#include "lib/material/models/neo_hookean.hpp"
#include "lib/output/sitting.hpp"
#include "lib/scene/study.hpp"

namespace plumb::mms {
namespace {

TEST(SchemeLevel, ValuesOfASnapshotAreThoseOfTheLaw) {
  const NeoHookean law(Elastic{17e6, 0.3, 1100});
  Mat<2> F2;
  F2 << 1.2, 0.3, -0.1, 0.9;
  Mat<3> F = Mat<3>::Identity();
  F.topLeftCorner<2, 2>() = F2;
  const Mat<3> P = law.first_piola(F);
  Snapshot<2> shown;
  shown.X = {{0.5, 0.25}};
  shown.u = {{0.01, 0.02}};
  shown.x = {{0.51, 0.27}};
  shown.v = {{3, 4}};
  shown.F = {F};
  shown.cauchy = {P * F.transpose() / F.determinant()};
  const NodalValues<2> values = nodal_values(shown);
  ASSERT_EQ(values.size(), 1u);
  EXPECT_EQ(values[0].u, shown.u[0]);
  EXPECT_EQ(values[0].v, shown.v[0]);
  EXPECT_NEAR((values[0].gradient - (F2 - Mat<2>::Identity())).norm(), 0, 1e-15);
  // round-off of P (1e7 Pa) through a product and back
  EXPECT_NEAR((values[0].stress - P.topLeftCorner<2, 2>()).norm(), 0, 1e-14 * P.norm());
}

TEST(SchemeLevel, TheMixedSchemeFollowsTheSolution) {
  const auto study = [](const std::string& scheme) {
    return parse_study(R"([study]
solution = "swinging-plate"
spacings = [0.2, 0.1]
periods = 0.125
force = "finite-strain"
quadrature = "nodal"
[body]
size = [2, 2]
[material]
young = "17 MPa"
poisson = 0.3
density = 1100
[method]
scheme = ")" + scheme + "\"\n",
                       "test.toml");
  };
  const Study mixed = study("mixed");
  const auto solution = solution_of<2>(mixed);
  Sitting sitting;
  std::vector<double> errors;
  for (const double d : mixed.spacings) {
    auto run = run_level<2>(mixed, solution, d, {.body_force = true}, sitting);
    measure<2>(mixed, exact_field(solution, end_time(mixed)), run);
    ASSERT_FALSE(run.level.failure);
    EXPECT_EQ(run.level.pair_evaluations % run.level.steps, 0);
    errors.push_back(run.level.nodal.l2 / run.level.exact.l2);
    EXPECT_LT(run.level.nodal.stress_l2, 0.05 * run.level.exact.stress_l2);
    EXPECT_LT(run.level.nodal.velocity_l2, 0.05 * run.level.exact.velocity_l2);
  }
  EXPECT_LT(errors[1], errors[0] / 2.5);  // halving divides by 2 at first order, by 4 at second
  EXPECT_THROW(run_level<2>(study("implicit"), solution, 0.2, {.body_force = true}, sitting), InputError);
}

}  // namespace
}  // namespace plumb::mms
