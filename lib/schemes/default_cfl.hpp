#pragma once

namespace plumb {

/// Chooses alpha_CFL of (31) where nobody else does. At 0.5 every scheme that was measured is stable.
inline constexpr double default_cfl = 0.5;

}  // namespace plumb
