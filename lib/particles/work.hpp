#pragma once
#include <cstdint>

namespace plumb {

/// Work done so far; does not depend on the machine.
struct Work {
  std::int64_t particle_evaluations = 0;
  std::int64_t pair_evaluations = 0;
};

}  // namespace plumb
