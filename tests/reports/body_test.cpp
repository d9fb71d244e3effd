#include "reports/body.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "lib/core/error.hpp"
#include "lib/output/particles.hpp"
#include "reports/results.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

using namespace plumb::reports;

/// n^3 (or n^2) particles with unit spacing at rest, the value is the x coordinate.
BodyState cube(int n, bool plane = false) {
  BodyState state;
  for (int k = 0; k < (plane ? 1 : n); ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        state.reference.push_back({1.0 * i, 1.0 * j, 1.0 * k});
        state.value.push_back(i);
      }
  state.position = state.reference;
  return state;
}

const ColourScale quantity{"x", "m", 1, 0, 2};

Patches patches(const BodyState& state, const View& view) {
  return std::get<Patches>(body_picture("cube", state, view, quantity, 1, {state}).map);
}

TEST(Body, ACubeShowsTheThreeFacesThatTheReaderSees) {
  const BodyState state = cube(3);
  // z to the right and y upwards: the reader looks along +x, so the face at x = 0 is seen and that at x = 2
  // is not
  const auto seen = patches(state, {'z', 'y', 'x'});
  EXPECT_EQ(seen.z.size(), 12u);
  EXPECT_EQ(*std::min_element(seen.z.begin(), seen.z.end()), 0);
  EXPECT_LT(*std::max_element(seen.z.begin(), seen.z.end()), 2);
  // x to the right and y upwards: the reader sees z = 2, y = 2 and, turned a little, one end
  EXPECT_EQ(patches(state, {'x', 'y', 'z'}).z.size(), 12u);
}

TEST(Body, ABodyTurnedRoundShowsItsOtherSide) {
  BodyState state = cube(3);
  for (auto& x : state.position) x = {-x[0], x[1], -x[2]};  // half a turn about y
  const auto seen = patches(state, {'z', 'y', 'x'});
  EXPECT_EQ(seen.z.size(), 12u);
  EXPECT_EQ(*std::max_element(seen.z.begin(), seen.z.end()), 2);
  EXPECT_GT(*std::min_element(seen.z.begin(), seen.z.end()), 0);
}

TEST(Body, APlaneBodyIsDrawnAsItIs) {
  const auto seen = patches(cube(4, true), {'x', 'y', 'z'});
  EXPECT_EQ(seen.z.size(), 9u);
  EXPECT_EQ(*std::max_element(seen.x.begin(), seen.x.end()), 3);
  EXPECT_EQ(*std::max_element(seen.y.begin(), seen.y.end()), 3);
}

TEST(Body, ParticlesOnNoLatticeAreSquares) {
  BodyState state = cube(3);
  state.reference[5][1] += 0.1;
  EXPECT_EQ(patches(state, {'z', 'y', 'x'}).z.size(), 27u);
}

TEST(Body, WithoutParticlesThereIsNoPicture) {
  EXPECT_THROW(patches(BodyState{}, {}), plumb::InputError);
}

TEST(Body, StatesOfARunAreReadWithAllTheirDigits) {
  const plumb::test::TemporaryFolder folder;
  plumb::ParticleSeries series(folder.path(), "particles");
  const std::vector<double> points{0.1, 1.0 / 3, 2, 5, 6, 7}, moved{0.05, 0, 1, 0, 0, -1}, stress{3, 1e-300};
  const std::vector<plumb::PointField> fields{{"displacement [m]", 3, moved}, {"stress [Pa]", 1, stress}};
  series.write({0, 3, points, fields});
  series.write({0.25, 3, points, fields});
  const auto states = read_states(folder.path(), "stress [Pa]");
  ASSERT_EQ(states.size(), 2u);
  EXPECT_EQ(states[1].time, 0.25);
  EXPECT_EQ(states[0].value, stress);
  EXPECT_EQ(states[0].position[0], (Point{0.1, 1.0 / 3, 2}));
  EXPECT_EQ(states[0].reference[1], (Point{5, 6, 8}));
  EXPECT_THROW(read_states(folder.path(), "no such field"), MissingResult);
  EXPECT_THROW(read_states(folder.path() / "nowhere", "stress [Pa]"), MissingResult);
}

}  // namespace
