// Who is held, in which directions, at which velocity: on every face, where two and three of them meet, and
// what a step then does.
#include <gtest/gtest.h>

#include <map>

#include "lib/scene/read_scene.hpp"
#include "lib/scene/tlsph.hpp"
#include "lib/schemes/tlsph/boundary/supports.hpp"
#include "lib/schemes/tlsph/loops/evaluate.hpp"

namespace plumb {
namespace {

const std::string body =
    "[scene]\nmax_steps = 3\ndimension = {d}\n[body]\nsize = {size}\norigin = {origin}\nspacing = "
    "0.25\nlayout = \"{layout}\"\n"
    "[material]\nyoung = 1e6\npoisson = 0.3\ndensity = 1000\n";

std::string scene_with(int d, const std::string& layout, const std::string& boundaries) {
  std::string text = body;
  const std::map<std::string, std::string> values = {{"{d}", std::to_string(d)},
                                                     {"{size}", d == 2 ? "[1, 0.75]" : "[1, 0.75, 0.5]"},
                                                     {"{origin}", d == 2 ? "[-3, 2]" : "[-3, 2, 5]"},
                                                     {"{layout}", layout}};
  for (const auto& [key, value] : values) text.replace(text.find(key), key.size(), value);
  return text + boundaries;
}

std::string boundary(const std::string& face, const std::string& kind, const std::string& more = "") {
  return "[[boundary]]\nface = \"" + face + "\"\nkind = \"" + kind + "\"\n" + more;
}

/// Velocities that are prescribed, by particle and component.
template <int d>
std::map<std::pair<Index, int>, double> held(const TlsphBody<d>& simulation) {
  std::map<std::pair<Index, int>, double> found;
  for (const auto& s : simulation.supports) found[{s.particle, s.component}] = s.velocity;
  return found;
}

/// Whether a particle belongs to the outer layer of a face.
template <int d>
bool in_layer(const Cloud<d>& cloud, Index i, int axis, bool upper, bool node) {
  const double wall = cloud.box.origin[axis] + (upper ? cloud.box.size[axis] : 0);
  return std::abs(std::abs(cloud.X[i][axis] - wall) - (node ? 0 : 0.125)) < 1e-9;
}

template <int d>
void expect_rollers_where_they_meet(const std::string& layout) {
  std::string boundaries;
  for (int axis = 0; axis < d; ++axis)
    boundaries += boundary(std::string(1, "xyz"[axis]) + (axis == 1 ? "+" : "-"), "roller");
  const auto simulation = make_tlsph<d>(parse_scene(scene_with(d, layout, boundaries), "t.toml"));
  const auto found = held(simulation);
  const Cloud<d>& cloud = simulation.solid.cloud;
  std::size_t expected = 0;
  for (Index i = 0; i < cloud.size(); ++i)
    for (int axis = 0; axis < d; ++axis) {
      const bool holds = in_layer(cloud, i, axis, axis == 1, layout == "node");
      expected += holds;
      EXPECT_EQ(found.count({i, axis}), holds) << layout << " particle " << i << " axis " << axis;
    }
  EXPECT_EQ(found.size(), expected);
}

TEST(Held, RollersHoldEveryDirectionWhereTheyMeet) {
  for (const std::string layout : {"node", "cell"}) {
    expect_rollers_where_they_meet<2>(layout);
    expect_rollers_where_they_meet<3>(layout);
  }
}

TEST(Held, ClampedAndMovedFacesHoldAllComponents) {
  const std::string moves = boundary("y+", "velocity", "velocity = [\"0.5 m/s\", \"-0.25*X\"]\n");
  const auto simulation =
      make_tlsph<2>(parse_scene(scene_with(2, "node", boundary("y-", "clamped") + moves), "t.toml"));
  const auto found = held(simulation);
  const Cloud<2>& cloud = simulation.solid.cloud;
  std::size_t expected = 0;
  for (Index i = 0; i < cloud.size(); ++i) {
    const bool low = in_layer(cloud, i, 1, false, true), high = in_layer(cloud, i, 1, true, true);
    expected += 2 * (low + high);
    if (!low && !high) continue;
    ASSERT_TRUE(found.contains({i, 0}) && found.contains({i, 1})) << i;
    EXPECT_DOUBLE_EQ(found.at({i, 0}), low ? 0 : 0.5) << i;
    EXPECT_DOUBLE_EQ(found.at({i, 1}), low ? 0 : -0.25 * cloud.X[i][0]) << i;
  }
  EXPECT_EQ(found.size(), expected);
}

/// Held components keep their velocity and move by it, whatever the forces; the others move.
TEST(Held, StepsMoveHeldParticlesAtTheirVelocityOnly) {
  for (const std::string integrator : {"verlet", "rk3"}) {
    const std::string moves = boundary("y+", "velocity", "velocity = [\"0\", \"1 m/s\"]\n");
    auto s = make_tlsph<2>(
        parse_scene(scene_with(2, "node", boundary("x-", "roller") + boundary("y-", "clamped") + moves),
                    "t.toml", {"method.integrator=" + integrator}));
    for (int n = 0; n < 3; ++n) ASSERT_TRUE(s.integrator.step(s.solid, s.state, 1e-4));
    const auto found = held(s);
    for (Index i = 0; i < s.solid.cloud.size(); ++i)
      for (int k = 0; k < 2; ++k) {
        const Index slot = s.solid.bonds.slots.of(i);
        if (!found.contains({i, k})) continue;
        EXPECT_NEAR(s.state.v[k][slot], found.at({i, k}), 1e-15) << integrator << ' ' << i;
        EXPECT_NEAR(s.state.u[k][slot], 3e-4 * found.at({i, k}), 1e-18) << integrator << ' ' << i;
      }
  }
}

/// Lower and upper face of each axis: the outer layer and no other, with the largest jitter that is allowed
/// too.
TEST(Held, FacesAreTheOuterLayer) {
  for (const auto layout : {Layout::node, Layout::cell})
    for (const double jitter : {0.0, 0.3}) {
      Box<3> box{Vec<3>(-1, 0.5, 2), Vec<3>(1.0, 0.8, 0.6)};
      const Cloud<3> regular = lattice<3>(box, {5, 4, 3}, layout);
      const Cloud<3> cloud = jitter > 0 ? jittered<3>(regular, jitter, 5, layout) : regular;
      for (int axis = 0; axis < 3; ++axis)
        for (const bool upper : {false, true}) {
          std::vector<Index> expected;
          const double wall = box.origin[axis] + (upper ? box.size[axis] : 0);
          for (Index i = 0; i < regular.size(); ++i)
            if (std::abs(regular.X[i][axis] - wall) < 0.11) expected.push_back(i);
          EXPECT_EQ(particles_on_face<3>(cloud, axis, upper, layout), expected) << axis << upper << jitter;
        }
    }
}

}  // namespace
}  // namespace plumb
