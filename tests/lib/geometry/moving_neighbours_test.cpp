// Lists of moving particles: every near pair, whatever the age of the list, and values that stay with their
// pairs.
#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "lib/geometry/moving_neighbours.hpp"

namespace plumb {
namespace {

template <int d>
std::vector<Vec<d>> random_points(Index count, double size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> somewhere(-size, size);
  std::vector<Vec<d>> x(static_cast<std::size_t>(count));
  for (auto& at : x)
    for (int k = 0; k < d; ++k) at[k] = somewhere(random);
  return x;
}

template <int d>
std::vector<std::int32_t> near_ones(const std::vector<Vec<d>>& x, Index i, double radius) {
  std::vector<std::int32_t> found;
  for (std::size_t j = 0; j < x.size(); ++j)
    if (static_cast<Index>(j) != i && (x[j] - x[i]).norm() < radius)
      found.push_back(static_cast<std::int32_t>(j));
  return found;
}

template <int d>
void finds_all_pairs(Index count, double radius) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const auto x = random_points<d>(count, 1, seed);
    const PairList list = pairs_within<d>(x, radius);
    for (Index i = 0; i < count; ++i) {
      const auto row = list.of(i);
      ASSERT_EQ(std::vector<std::int32_t>(row.begin(), row.end()), near_ones<d>(x, i, radius)) << i;
    }
  }
}

TEST(MovingNeighbours, AllPairsOfAnyCloud) {
  finds_all_pairs<1>(60, 0.11);
  finds_all_pairs<2>(1600, 0.1);  // more rows than one thread takes
  finds_all_pairs<3>(300, 0.4);
  finds_all_pairs<3>(40, 5);  // all see all
}

TEST(MovingNeighbours, OneParticleFarOutCostsNoMemory) {
  auto x = random_points<2>(50, 1, 5);
  x.push_back(Vec<2>(1e12, -3e11));
  const PairList list = pairs_within<2>(x, 0.3);
  EXPECT_TRUE(list.of(50).empty());
  const auto row = list.of(7);
  EXPECT_EQ(std::vector<std::int32_t>(row.begin(), row.end()), near_ones<2>(x, 7, 0.3));
}

/// Sum over neighbours of a weight that vanishes at the reach.
std::vector<double> sums(const PairList& list, const std::vector<Vec<2>>& x, double reach) {
  std::vector<double> sum(x.size(), 0.0);
  for (std::size_t i = 0; i < x.size(); ++i)
    for (const auto j : list.of(static_cast<Index>(i))) {
      const double t = std::max(0.0, 1 - (x[i] - x[j]).norm() / reach);
      sum[i] += t * t * t * (x[i][0] + 3 * x[j][1]);
    }
  return sum;
}

TEST(MovingNeighbours, SumsDoNotKnowTheAgeOfTheList) {
  constexpr double reach = 0.3;
  auto x = random_points<2>(200, 1, 11);
  const auto v = random_points<2>(200, 0.01, 12);
  MovingNeighbours<2> kept(reach, 0.1);
  long found = 0;
  for (int step = 0; step < 60; ++step) {
    found += kept.update(x);
    const auto old = sums(*kept.list(), x, reach), fresh = sums(pairs_within<2>(x, reach), x, reach);
    for (std::size_t i = 0; i < x.size(); ++i) ASSERT_EQ(old[i], fresh[i]) << step;
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += v[i] + Vec<2>(5, -7);  // all fly together
  }
  EXPECT_EQ(found, kept.searches());
  EXPECT_GT(found, 5);   // 60 steps of 0.014 at most, and 0.05 to go
  EXPECT_LT(found, 21);  // not because of the flight, which is 500 skins long
}

TEST(MovingNeighbours, ATurnNeedsNoNewList) {
  const auto first = random_points<2>(100, 1, 41);
  MovingNeighbours<2> one(0.3, 0.1), two(0.3, 0.1, [] {
    std::vector<int> body(100, 0);
    for (int i = 50; i < 100; ++i) body[i] = 1;
    return body;
  }());
  one.update(first);
  two.update(first);
  for (int step = 1; step <= 20; ++step) {
    const double angle = 0.2 * step;
    Mat<2> R;
    R << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    auto x = first;
    for (auto& at : x) at = R * at + Vec<2>(step, 0);
    EXPECT_FALSE(one.update(x));
    two.update(x);
    x[3] += Vec<2>(0.2, 0);
    if (step == 20) {
      EXPECT_TRUE(one.update(x));
    }
  }
  EXPECT_GT(two.searches(), 5);  // two bodies may come near to each other: their turn counts
}

TEST(MovingNeighbours, BodiesThatMeetAreSeen) {
  // two particles, each its own body, on their way to each other: neither moves relative to its body's mean
  for (const bool two : {false, true}) {
    std::vector<Vec<2>> x{Vec<2>(0, 0), Vec<2>(1, 0)};
    MovingNeighbours<2> kept(0.2, 0.1, two ? std::vector<int>{0, 1} : std::vector<int>{});
    kept.update(x);
    EXPECT_TRUE(kept.list()->other.empty());
    for (int step = 0; step < 45; ++step) {
      x[0][0] += 0.01;
      x[1][0] -= 0.01;
      kept.update(x);
      if ((x[1] - x[0]).norm() < 0.2 * (1 - 1e-12)) {
        ASSERT_EQ(kept.list()->other.size(), 2U) << two << ' ' << step;
      }
    }
    EXPECT_EQ(kept.body_of(1), two ? 1 : 0);
  }
}

TEST(MovingNeighbours, ValuesStayWithTheirPairs) {
  auto x = random_points<2>(700, 1, 21);
  const auto v = random_points<2>(700, 0.05, 22);
  MovingNeighbours<2> kept(0.15, 0.05);
  kept.update(x);
  const auto name = [](Index i, Index j) {
    return static_cast<double>(std::min(i, j) * 1000 + std::max(i, j));
  };
  PairHistory history;
  history.move_to(kept.list());
  EXPECT_TRUE(std::all_of(history.value.begin(), history.value.end(), [](double q) { return q == 0; }));
  for (Index i = 0; i < 700; ++i)
    for (auto n = kept.list()->begin[i]; n < kept.list()->begin[i + 1]; ++n)
      history.value[n] = name(i, kept.list()->other[n]);
  const PairList before = *kept.list();
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += v[i];
  ASSERT_TRUE(kept.update(x));
  const PairHistory again = history_of(history.triples(), 700);
  EXPECT_EQ(again.value, history.value);
  EXPECT_EQ(again.list->other, history.list->other);
  history.move_to(kept.list());
  Index lasting = 0, fresh = 0;
  for (Index i = 0; i < 700; ++i)
    for (auto n = kept.list()->begin[i]; n < kept.list()->begin[i + 1]; ++n) {
      const auto old = before.of(i);
      const bool was = std::binary_search(old.begin(), old.end(), kept.list()->other[n]);
      ASSERT_EQ(history.value[n], was ? name(i, kept.list()->other[n]) : 0.0);
      ++(was ? lasting : fresh);
    }
  EXPECT_GT(lasting, 1000);
  EXPECT_GT(fresh, 1000);
}

TEST(MovingNeighbours, SameListForAnyNumberOfThreads) {
  const auto x = random_points<3>(2000, 1, 31);
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const PairList one = pairs_within<3>(x, 0.3);
  omp_set_num_threads(3);
  const PairList three = pairs_within<3>(x, 0.3);
  omp_set_num_threads(threads);
  EXPECT_EQ(one.begin, three.begin);
  EXPECT_EQ(one.other, three.other);
}

}  // namespace
}  // namespace plumb
