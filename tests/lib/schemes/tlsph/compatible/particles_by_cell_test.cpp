// Particles by cells, blocks and colours: what may be handled at the same time has no spline in common.
#include "lib/schemes/tlsph/compatible/solver/particles_by_cell.hpp"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <random>
#include <set>

namespace plumb {
namespace {

/// Long in the first direction, so that a colour has several blocks.
template <int d>
std::vector<Vec<d>> points() {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> number;
  std::vector<Vec<d>> X(4000);
  for (auto& x : X)
    for (int k = 0; k < d; ++k) x[k] = number(random) * (k == 0 ? 60 : 22);
  return X;
}

/// Places of the 4^d splines around a point.
template <int d>
std::set<Index> splines_of(const SplineGrid<d>& grid, const Vec<d>& X) {
  const auto first = splines_at<d>(grid, X).cell;
  std::set<Index> places;
  for (int m = 0; m < int_power(4, d); ++m) {
    auto spline = first;
    for (int k = 0, rest = m; k < d; ++k, rest /= 4) spline[k] += rest % 4;
    places.insert(grid.place(spline));
  }
  return places;
}

template <class Dimension>
class ParticlesInCells : public ::testing::Test {
 protected:
  static constexpr int d = Dimension::value;
  std::vector<Vec<d>> X = points<d>();
  SplineGrid<d> grid = grid_over<d>(X, 2.0);
  ParticlesByCell<d> by = particles_by_cell<d>(grid, X);
};
using Dimensions = ::testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 2>,
                                    std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(ParticlesInCells, Dimensions);

TYPED_TEST(ParticlesInCells, ABlockIsOfCellsThatLieTogether) {
  std::set<std::array<Index, TestFixture::d>> blocks;
  for (std::size_t b = 0; b + 1 < this->by.block_begin.size(); ++b) {
    std::set<std::array<Index, TestFixture::d>> here;
    for (Index cell = this->by.block_begin[b]; cell < this->by.block_begin[b + 1]; ++cell) {
      const auto at =
          splines_at<TestFixture::d>(this->grid, this->X[this->by.particles[this->by.begin[cell]]]).cell;
      std::array<Index, TestFixture::d> block{};
      for (int k = 0; k < TestFixture::d; ++k) block[k] = at[k] / 4;
      here.insert(block);
    }
    EXPECT_EQ(here.size(), 1u);
    EXPECT_TRUE(blocks.insert(*here.begin()).second) << "a block twice";
  }
}

TYPED_TEST(ParticlesInCells, EveryParticleIsInItsCellOnce) {
  std::vector<int> times(this->X.size(), 0);
  for (std::size_t cell = 0; cell + 1 < this->by.begin.size(); ++cell) {
    const auto at =
        splines_at<TestFixture::d>(this->grid, this->X[this->by.particles[this->by.begin[cell]]]).cell;
    for (Index n = this->by.begin[cell]; n < this->by.begin[cell + 1]; ++n) {
      const auto i = this->by.particles[n];
      ++times[i];
      EXPECT_EQ(splines_at<TestFixture::d>(this->grid, this->X[i]).cell, at);
    }
  }
  EXPECT_EQ(std::vector<int>(this->X.size(), 1), times);
}

TYPED_TEST(ParticlesInCells, BlocksOfOneColourShareNoSpline) {
  std::size_t most_blocks = 0;
  for (std::size_t colour = 0; colour + 1 < this->by.colour_begin.size(); ++colour) {
    std::map<Index, Index> block_of;  // by place of the spline
    const Index first = this->by.colour_begin[colour], end = this->by.colour_begin[colour + 1];
    most_blocks = std::max(most_blocks, static_cast<std::size_t>(end - first));
    for (Index block = first; block < end; ++block)
      for (Index n = this->by.begin[this->by.block_begin[block]];
           n < this->by.begin[this->by.block_begin[block + 1]]; ++n)
        for (const Index place : splines_of<TestFixture::d>(this->grid, this->X[this->by.particles[n]]))
          EXPECT_EQ(block_of.try_emplace(place, block).first->second, block);
  }
  EXPECT_GT(most_blocks, 1u);  // or nothing was tried
}

}  // namespace
}  // namespace plumb
