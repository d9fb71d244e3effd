#pragma once
#include <utility>

namespace plumb {

/// Calls f.template operator()<d>() for a dimension 1, 2 or 3 that is known at run time, and returns what that returns.
/// It is the one place that chooses among instantiations by dimension.
template <class F>
decltype(auto) with_dimension(int dimension, F&& f) {
  if (dimension == 1) return std::forward<F>(f).template operator()<1>();
  if (dimension == 2) return std::forward<F>(f).template operator()<2>();
  return std::forward<F>(f).template operator()<3>();
}

}  // namespace plumb
