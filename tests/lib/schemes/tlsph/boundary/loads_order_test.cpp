// Order in time with all that varies in time: tractions, a pressure that follows, a body force, and a side that
// is moved. Reference: RK3 with much smaller steps on the same body, so that space does not enter.
#include <gtest/gtest.h>

#include <cmath>

#include "lib/convergence/verdict.hpp"
#include "lib/geometry/facets.hpp"
#include "lib/schemes/tlsph/boundary/apply_actions.hpp"
#include "lib/schemes/tlsph/boundary/supports.hpp"
#include "tests/support/solids.hpp"

namespace plumb::testing {
namespace {

constexpr double end = 4e-3, w = 900;  // 3.6 rad of every load

/// Pieces of the side along that normal.
std::vector<LoadedPlace<2>> side_of(const Cloud<2>& cloud, const Vec<2>& normal) {
  std::vector<LoadedPlace<2>> places;
  for (const Facet<2>& facet : box_facets(cloud))
    if (facet.area.dot(normal) > 0.99 * facet.area.norm())
      places.push_back({facet.owner, facet.centroid, facet.area});
  return places;
}

Actions<2> varying(const Cloud<2>& cloud) {
  Actions<2> actions;
  Held<2> moved;
  moved.name = "left";
  moved.steady = false;
  moved.motion = [](const Vec<2>& at, int k, double t) -> HeldMotion {
    const double a = 2e-3 * (1 + k + at[1]);
    return {a * std::sin(w * t), a * w * std::cos(w * t), -a * w * w * std::sin(w * t)};
  };
  for (const Index i : particles_on_face(cloud, 0, false, Layout::node))
    for (int k = 0; k < 2; ++k) moved.places.push_back({i, k, cloud.X[i]});
  actions.held.push_back(moved);
  actions.surface.push_back({"right",
                             side_of(cloud, Vec<2>(1, 0)),
                             [](const Vec<2>& at, const Vec<2>&, double t) {
                               return Vec<2>(4e5 * std::sin(w * t), 2e5 * at[1] * std::cos(w * t));
                             },
                             {},
                             false});
  actions.surface.push_back({"top",
                             side_of(cloud, Vec<2>(0, 1)),
                             {},
                             [](const Vec<2>& at, double t) { return 5e5 * at[0] * std::sin(w * t); },
                             false});
  actions.body_forces.push_back(
      {"wind",
       [](const Vec<2>& X, double t) { return Vec<2>(4e5 * X[1] * std::cos(w * t), -6e5 * std::sin(w * t)); },
       false});
  return actions;
}

/// Displacements of all particles at the end.
std::vector<double> after(const std::string& name, int steps) {
  Solid<2> solid = rubber_block<2>(4, Layout::node, 0);
  const Actions<2> actions = varying(solid.cloud);
  State<2> state = make_state(solid);
  impose(solid, actions, state);
  apply_actions(solid, actions);
  const ChosenIntegrator<2> integrator = with_prescribed_motion(integrator_named<2>(name, solid), actions);
  for (int n = 0; n < steps; ++n) EXPECT_TRUE(integrator.step(solid, state, end / steps));
  std::vector<double> u;
  for (Index i = 0; i < solid.cloud.size(); ++i)
    for (const double component : vector_at<2>(state.u, solid.bonds.slots.of(i))) u.push_back(component);
  return u;
}

TEST(OrderInTime, IsKeptWithLoadsAndMotionThatVary) {
  const std::vector<double> reference = after("rk3", 3200);
  for (const auto& [name, order] : {std::pair("rk3", 3.0), std::pair("verlet", 2.0)}) {
    std::vector<Level> levels;
    for (const int steps : {50, 100, 200, 400}) {
      const std::vector<double> u = after(name, steps);
      double square = 0;
      for (std::size_t k = 0; k < u.size(); ++k) square += std::pow(u[k] - reference[k], 2);
      levels.push_back({end / steps, std::sqrt(square)});
    }
    const OrderFit fit = fit_order(levels);
    RecordProperty(name, std::to_string(fit.order));
    EXPECT_EQ(judge(fit, order), Verdict::pass)
        << name << ": " << fit.order << " [" << fit.lower << ", " << fit.upper << "]";
    EXPECT_GT(fit.lower, order - 0.5) << name;
  }
}

}  // namespace
}  // namespace plumb::testing
