#include "lib/schemes/tlsph/loops/stress_window.hpp"

#include <algorithm>

namespace plumb {

StressWindow::StressWindow(int components, Index blocks, Index reach, Index shares)
    : blocks_(blocks), reach_(reach), shares_(shares), outside_(reach + 1) {
  const Index zeros = 0;  // the place of what lies outside
  Index used = zeros + 1;
  shift_.resize(blocks + 2 * outside_);
  const auto put = [&](Index block, Index place) {
    shift_[block + outside_] = static_cast<std::int32_t>((place - block) * block_slots);
  };
  for (Index b = 1; b <= outside_; ++b) {
    put(-b, zeros);
    put(blocks - 1 + b, zeros);
  }
  for (Index s = 0; s < shares; ++s) {
    const Index first = begin_of(s), last = begin_of(s + 1);
    const Index head = s == 0 ? first : std::min(first + 2 * reach, last);
    const Index tail = s == shares - 1 ? last : std::max(last - 2 * reach, head);
    const Index alive = std::min(tail - head, 2 * reach + 1);
    for (Index b = first; b < head; ++b) put(b, used++);
    for (Index b = head; b < tail; ++b) put(b, used + (b - head) % alive);
    used += alive;
    for (Index b = tail; b < last; ++b) put(b, used++);
  }
  values_ = Field(components, used * block_slots, 0);
}

}  // namespace plumb
