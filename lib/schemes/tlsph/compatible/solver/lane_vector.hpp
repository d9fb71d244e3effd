#pragma once

namespace plumb {

/// n numbers in one of the compiler's vector types. Sums of Eigen's fixed vectors end up in memory, where
/// each addition waits for the one before.
template <class T, int n>
struct LaneVectorOf {
  typedef T Type __attribute__((vector_size(n * sizeof(T))));
};
template <class T>
struct LaneVectorOf<T, 1> {
  using Type = T;
};
template <class T, int n>
using LaneVector = typename LaneVectorOf<T, n>::Type;

/// Loads and stores the lanes of a vector register; the memory need not be aligned.
template <class V, class T>
inline V load_lanes(const T* from) {
  V v;
  __builtin_memcpy(&v, from, sizeof(V));
  return v;
}
template <class V, class T>
inline void store_lanes(V v, T* to) {
  __builtin_memcpy(to, &v, sizeof(V));
}

}  // namespace plumb
