#include "lib/schemes/tlsph/loops/stress_window.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <tuple>

namespace plumb::testing {
namespace {

struct Shape {
  Index blocks, reach, shares;
};

class Window : public ::testing::TestWithParam<Shape> {};

/// Which block's stress stands where, as a thread goes through its share: the memory as the loops see it.
class Memory {
 public:
  explicit Memory(const Shape& shape) : shape_(shape), window_(1, shape.blocks, shape.reach, shape.shares) {}

  /// What evaluate() does with one share, up to the point where threads wait for each other.
  void go_through(Index share) {
    const auto [first, end] = window_.inner(share);
    Index next = first;
    for (Index b = window_.begin_of(share); b < window_.begin_of(share + 1); ++b) {
      write(b);
      if (next < end && next + shape_.reach <= b) expect_alive(next++);
    }
    while (next < end) expect_alive(next++);
  }
  void finish(Index share) {
    const auto [first, end] = window_.inner(share);
    for (Index b = window_.begin_of(share); b < first; ++b) expect_alive(b);
    for (Index b = end; b < window_.begin_of(share + 1); ++b) expect_alive(b);
  }
  Index forces() const { return forces_; }
  std::set<Index> places_of(Index share) const {
    std::set<Index> places;
    for (Index b = window_.begin_of(share); b < window_.begin_of(share + 1); ++b) places.insert(place(b));
    return places;
  }
  Index place(Index block) const { return window_.place(block * block_slots); }

 private:
  void write(Index block) { standing_[place(block)] = block; }
  void expect_alive(Index block) {
    ++forces_;
    for (Index b = block - shape_.reach; b <= block + shape_.reach; ++b)
      if (b >= 0 && b < shape_.blocks) {
        EXPECT_EQ(standing_[place(b)], b) << "for the force of block " << block;
      }
  }

  Shape shape_;
  StressWindow window_;
  std::map<Index, Index> standing_;
  Index forces_ = 0;
};

TEST_P(Window, HoldsWhatEveryForceReads) {
  const Shape& shape = GetParam();
  Memory memory(shape);
  for (Index s = shape.shares - 1; s >= 0; --s) memory.go_through(s);  // in any order
  for (Index s = 0; s < shape.shares; ++s) memory.finish(s);
  EXPECT_EQ(memory.forces(), shape.blocks);
}

TEST_P(Window, GivesEveryShareItsOwnMemory) {
  const Shape& shape = GetParam();
  const Memory memory(shape);
  std::set<Index> seen{memory.place(-1)};  // zeros, outside of the body
  EXPECT_EQ(memory.place(shape.blocks) - memory.place(-1), 0);
  for (Index s = 0; s < shape.shares; ++s)
    for (const Index place : memory.places_of(s)) EXPECT_TRUE(seen.insert(place).second);
}

INSTANTIATE_TEST_SUITE_P(Shapes, Window,
                         ::testing::Values(Shape{1, 1, 1}, Shape{27, 2, 1}, Shape{27, 2, 2}, Shape{27, 2, 3},
                                           Shape{100, 3, 2}, Shape{100, 40, 1}, Shape{100, 40, 2},
                                           Shape{5, 7, 2}, Shape{16, 1, 16}));

TEST(StressWindow, IsSmallOnALargeBody) {
  const StressWindow window(9, 4000, 40, 1);
  EXPECT_EQ(window.bytes(), 9 * ((2 * 40 + 1 + 1) * block_slots + 72) * sizeof(double) + (4000 + 82) * 4);
}

}  // namespace
}  // namespace plumb::testing
