#pragma once
#include <bit>
#include <boost/align/aligned_allocator.hpp>
#include <cmath>
#include <cstdint>
#include <vector>

namespace plumb {

/// Doubles on 64-byte boundaries (one cache line, one AVX-512 register).
using AlignedVector = std::vector<double, boost::alignment::aligned_allocator<double, 64>>;

/// Number of doubles that one instruction of the target machine handles.
#if defined(__AVX512F__)
inline constexpr int native_width = 8;
#elif defined(__AVX__)
inline constexpr int native_width = 4;
#else
inline constexpr int native_width = 2;
#endif

/// The compiler's vector types (member types, because template arguments would lose the attribute).
template <int W>
struct VectorOf {
  typedef double Doubles __attribute__((vector_size(W * sizeof(double))));
  typedef std::uint64_t Words __attribute__((vector_size(W * sizeof(double))));
};
template <>
struct VectorOf<1> {
  using Doubles = double;
  using Words = std::uint64_t;
};

/// W doubles that are treated alike: the scalar type of all loops over particles. The compiler's own vector
/// types do the work, so that the same source serves every instruction set; W = 1 is a plain double.
template <int W>
struct Pack {
  using Lanes = typename VectorOf<W>::Doubles;
  using Words = typename VectorOf<W>::Words;

  Lanes lanes;

  Pack() = default;
  Pack(double value)
      : lanes(Lanes{} + value) {}  // NOLINT(google-explicit-constructor): arithmetic with constants
  static Pack of(Lanes lanes) {
    Pack p;
    p.lanes = lanes;
    return p;
  }
  /// W consecutive doubles from any address.
  static Pack load(const double* from) {
    Pack p;
    __builtin_memcpy(&p.lanes, from, sizeof(Lanes));
    return p;
  }
  /// Loads values that several products use: one load into a register, where GCC would make the load
  /// part of every product.
  static Pack load_once(const double* from) {
    Pack p = load(from);
    asm("" : "+v"(p.lanes));
    return p;
  }
  void store(double* to) const { __builtin_memcpy(to, &lanes, sizeof(Lanes)); }
  double operator[](int lane) const {
    double values[W];
    store(values);
    return values[lane];
  }

  friend Pack operator+(Pack a, Pack b) { return of(a.lanes + b.lanes); }
  friend Pack operator-(Pack a, Pack b) { return of(a.lanes - b.lanes); }
  friend Pack operator*(Pack a, Pack b) { return of(a.lanes * b.lanes); }
  friend Pack operator/(Pack a, Pack b) { return of(a.lanes / b.lanes); }
  friend Pack operator-(Pack a) { return of(-a.lanes); }
  Pack& operator+=(Pack b) { return *this = *this + b; }
  Pack& operator-=(Pack b) { return *this = *this - b; }
  Pack& operator*=(Pack b) { return *this = *this * b; }

  /// Lane by lane the smaller one; b where either is not a number.
  friend Pack min(Pack a, Pack b) { return of(a.lanes < b.lanes ? a.lanes : b.lanes); }
  /// 1 in lanes that are not positive (not a number included), 0 elsewhere.
  friend Pack not_positive(Pack a) { return of(a.lanes > 0 ? Pack(0).lanes : Pack(1).lanes); }
  /// The smaller of a and b in lanes where `use` is positive, b elsewhere.
  friend Pack lesser_where_positive(Pack a, Pack b, Pack use) {
    return of(use.lanes > 0 ? min(a, b).lanes : b.lanes);
  }
};

/// Natural logarithm, lane by lane.
template <int W>
Pack<W> log(Pack<W> x) {
  double values[W];
  x.store(values);
  for (double& value : values) value = std::log(value);
  return Pack<W>::load(values);
}

/// x^(-1/3) for x > 0, to about 2 units in the last place: a first guess from the exponent bits (relative
/// error below 4 %), then two fourth-order steps y <- y (1 + c/3 + 2c^2/9 + 14c^3/81), c = 1 - x y^3.
template <int W>
Pack<W> reciprocal_cbrt(Pack<W> x) {
  using Words = typename VectorOf<W>::Words;
  const Words high = std::bit_cast<Words>(x.lanes) >> 32;
  const Words third = (high * std::uint64_t{0x55555556}) >> 32;
  Pack<W> y = Pack<W>::of(
      std::bit_cast<typename VectorOf<W>::Doubles>(Words((std::uint64_t{0x553ef0ff} - third) << 32)));
  for (int step = 0; step < 2; ++step) {
    const Pack<W> c = Pack<W>(1) - x * y * y * y;
    y = y + y * c * (Pack<W>(1.0 / 3) + c * (Pack<W>(2.0 / 9) + c * Pack<W>(14.0 / 81)));
  }
  return y;
}

}  // namespace plumb
