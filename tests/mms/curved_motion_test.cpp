// Curved surfaces in studies: who follows the solution there, who is pulled, at rest and in motion.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "lib/core/error.hpp"
#include "lib/scene/study.hpp"
#include "mms/curved_surface.hpp"
#include "mms/level.hpp"
#include "mms/static_study.hpp"
#include "mms/study.hpp"

namespace plumb::mms::curved_motion_test {
namespace {

struct Shape {
  std::string name, text;
};

const std::vector<Shape> shapes{
    {"disc", "shape = \"ball\"\ncentre = [0.5, 0.5]\nradius = 0.5\n{}"},
    {"ball", "shape = \"ball\"\ncentre = [0.5, 0.5, 0.5]\nradius = 0.5\n{}"},
    {"drilled cube",
     "size = [1, 1, 1]\n{}[[body.hole]]\nshape = \"ball\"\ncentre = [0.5, 0.5, 0.5]\nradius = 0.25\n"}};

Study study_on(const Shape& shape, const std::string& cloud, const std::string& surface,
               const std::string& law = "linear-elastic", double spacing = 0.2) {
  const std::string body = fmt::format(fmt::runtime(shape.text), cloud);
  return parse_study(fmt::format(R"([study]
solution = "affine-patch"
spacings = [{}]
periods = 0.25
force = "finite-strain"
quadrature = "nodal"
surface = "{}"
[body]
{}
[material]
model = "{}"
young = "17 MPa"
poisson = 0.3
density = 1100
[method]
beta = 1.2
gradient = "compatible"
momentum = "adjoint"
cfl = 0.25
)",
                                 spacing, surface, body, law),
                     "curved.toml");
}

const std::vector<std::string> clouds{"", "jitter = 0.2\n", "cloud = \"blue-noise\"\n"};

/// The areas are those of the bonds: a uniform stress is in balance with them, on every cloud.
TEST(CurvedSurfaces, AnAffineMapIsInEquilibrium) {
  for (const Shape& shape : shapes)
    for (const auto& cloud : clouds)
      for (const char* surface : {"displaced", "pulled"}) {
        const StaticLevel level = run_static_study(study_on(shape, cloud, surface)).levels.at(0);
        const std::string which = shape.name + ", " + cloud + surface;
        // round-off: some 1e-14 was found
        EXPECT_LT(level.relative(&ErrorNorms::l2), 1e-12) << which;
        EXPECT_LT(level.relative(&ErrorNorms::stress_l2), 1e-12) << which;
        EXPECT_GT(level.exact.h1, 0.1) << which;
      }
}

/// In motion what is left is the error of Verlet's steps, which falls with their square: half a spacing, half a step.
TEST(CurvedSurfaces, AnAffineMapInMotionHasTheErrorOfTheStepsOnly) {
  for (const Shape& shape : shapes)
    for (const char* surface : {"displaced", "pulled"}) {
      Study study = study_on(shape, "", surface, "neo-hookean");
      const auto error = [&](double cfl) {
        study.method.cfl = cfl;
        return run_study(study).levels.at(0).nodal.l2;
      };
      const double coarse = error(0.2), fine = error(0.1);
      // a whole number of steps ends a quarter of the period: steps are not quite halved
      EXPECT_NEAR(std::log2(coarse / fine), 2, 0.3) << shape.name << surface << coarse;
    }
}

/// Every particle with a piece of a curved surface follows the solution, or is pulled; nobody does both.
TEST(CurvedSurfaces, HaveOneConditionEverywhere) {
  for (const auto& cloud : clouds) {
    const Study followed = study_on(shapes[1], cloud, "displaced"),
                pulled = study_on(shapes[1], cloud, "pulled");
    const auto solution = solution_of<3>(followed);
    const auto body = driven_simulation<3>(followed, solution, 0.2);
    const auto a = curved_surface<3>(followed, solution, body.solid),
               b = curved_surface<3>(pulled, solution, body.solid);
    EXPECT_TRUE(b.displaced.empty());
    EXPECT_GT(a.displaced.size(), 50u);
    // the ball's area vectors close, and turn its centre outwards: sum X . B = 3 V
    Vec<3> sum = Vec<3>::Zero();
    double moment = 0;
    for (const auto& place : b.pulled) {
      sum += place.area;
      moment += place.area.dot(place.at - Vec<3>::Constant(0.5));
    }
    EXPECT_LT(sum.norm(), 1e-12);
    EXPECT_NEAR(moment, 3 * (std::acos(-1.0) / 6), 0.02) << "a polyhedron in a ball of radius 0.5";
    auto held = b;
    hold_half(body.solid.cloud, held);
    EXPECT_EQ(held.displaced.size() + held.pulled.size(), b.pulled.size());
    for (const auto& place : held.pulled) EXPECT_GE(place.at[0], 0.5);
  }
}

/// A scheme with a body of its own cannot be driven there, and says so.
TEST(CurvedSurfaces, AreRefusedToOtherSchemes) {
  for (const Shape& shape : shapes) {
    Study study = study_on(shape, "", "displaced", "neo-hookean");
    study.method.scheme = "mixed";
    try {
      run_study(study);
      ADD_FAILURE() << shape.name;
    } catch (const InputError& error) {
      EXPECT_EQ(error.problem(), "scheme \"mixed\" on a curved surface");
    }
  }
}

}  // namespace
}  // namespace plumb::mms::curved_motion_test
