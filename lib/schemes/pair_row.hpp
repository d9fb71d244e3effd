#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "lib/core/pack.hpp"
#include "lib/schemes/moving_pairs.hpp"

namespace plumb {

/// What a row of pairs is filled with: the more, the dearer.
enum class Seen {
  positions,   ///< r, weight, distance
  velocities,  ///< v, too
  openings     ///< per_r and opening, too
};

/// The pairs of one particle that are within the reach, with r_ij = x_i - x_j and v_ij = v_i - v_j, in ascending order of the others, number by number so
/// that several are worked on at once. What stands here depends on the positions only, not on the age of the
/// list. Up to `padded` there are more entries, of no weight.
template <int d>
class PairRow {
 public:
  static constexpr Index width = native_width;

  explicit PairRow(Index longest) : room_(static_cast<std::size_t>(size_for(longest) * (2 * d + 5)), 0.0) {
    const Index size = size_for(longest);
    other.resize(static_cast<std::size_t>(size), 0);
    place.resize(static_cast<std::size_t>(size), 0);
    double* next = room_.data();
    const auto take = [&] { return std::exchange(next, next + size); };
    for (int k = 0; k < d; ++k) r[k] = take();
    for (int k = 0; k < d; ++k) v[k] = take();
    weight = take();
    distance = take();
    per_r = take();
    opening = take();
    spare = take();
  }

  Index count = 0, padded = 0;
  std::array<double*, d> r{}, v{};  ///< r_ij [m], v_ij [m/s]
  double* weight = nullptr;         ///< w V_j [1/m^2]
  double* distance = nullptr;       ///< [m]
  double* per_r = nullptr;          ///< 1/distance [1/m]; r per_r is 0 for particles at one place
  double* opening = nullptr;        ///< v_ij . r_ij [m^2/s]
  double* spare = nullptr;          ///< room for numbers by pair of whoever uses the row
  std::vector<std::int32_t> other;
  std::vector<std::int64_t> place;  ///< in the list

  template <class Slope>
  void fill(const MovingPairs<d, Slope>& pairs, Index i, Seen seen) {
    const std::array<double, d> here = numbers_of(pairs.x[i]);
    const double reach = 1 / pairs.slope.per_reach, square = reach * reach;
    Index m = 0;
    for (auto n = pairs.list.begin[i]; n < pairs.list.begin[i + 1]; ++n) {
      const std::int32_t j = pairs.list.other[n];
      double s = 0;
      for (int k = 0; k < d; ++k) {
        const double apart = here[k] - pairs.x[j][k];
        r[k][m] = apart;
        s += apart * apart;
      }
      distance[m] = s;
      weight[m] = pairs.V[j];
      other[m] = j;
      place[m] = n;
      m += s < square;
    }
    count = m;
    padded = (m + width - 1) / width * width;
    for (; m < padded; ++m) {
      for (int k = 0; k < d; ++k) r[k][m] = 0;
      distance[m] = square;
      weight[m] = 0;
      other[m] = static_cast<std::int32_t>(i);
    }
    weigh(pairs.slope);
    if (seen == Seen::positions) return;
    fill_velocities(pairs.v, i);
    if (seen == Seen::openings) find_openings();
  }

  /// -sum weight a (x) r of numbers by pair.
  Mat<d> minus_sum(const std::array<double*, d>& a) const {
    using Real = Pack<native_width>;
    Mat<d, Real> sum;
    for (int n = 0; n < d * d; ++n) sum(n / d, n % d) = Real(0);
    for (Index m = 0; m < padded; m += width) {
      const Real w = Real::load(weight + m);
      for (int k = 0; k < d; ++k) {
        const Real first = w * Real::load(a[k] + m);
        for (int l = 0; l < d; ++l) sum(k, l) -= first * Real::load(r[l] + m);
      }
    }
    Mat<d> whole;
    for (int n = 0; n < d * d; ++n) {
      double one = 0;
      for (int lane = 0; lane < width; ++lane) one += sum(n / d, n % d)[lane];
      whole(n / d, n % d) = one;
    }
    return whole;
  }

  /// sum c r (x) r of numbers by pair, with zeros up to the end of the last pack.
  Mat<d> sum_of_squares(const double* c) const {
    using Real = Pack<native_width>;
    std::array<std::array<Real, d>, d> sum;
    for (auto& line : sum) line.fill(Real(0));
    for (Index m = 0; m < padded; m += width) {
      std::array<Real, d> at;
      for (int k = 0; k < d; ++k) at[k] = Real::load(r[k] + m);
      const Real weighed = Real::load(c + m);
      for (int k = 0; k < d; ++k) {
        const Real first = weighed * at[k];
        for (int l = k; l < d; ++l) sum[k][l] += first * at[l];
      }
    }
    Mat<d> whole;
    for (int k = 0; k < d; ++k)
      for (int l = k; l < d; ++l) {
        double one = 0;
        for (int lane = 0; lane < width; ++lane) one += sum[k][l][lane];
        whole(k, l) = whole(l, k) = one;
      }
    return whole;
  }

  /// sum weight (S_i + S_j) r_ij: over V_i the force of an adjoint pair of sums, with S of each particle.
  Vec<d> adjoint_sum(const std::vector<Mat<d>>& S, Index i) const {
    Vec<d> sum = Vec<d>::Zero(), own = Vec<d>::Zero();
    for (Index m = 0; m < count; ++m) {
      const Vec<d> wr = weight[m] * r_of(m);
      own += wr;
      sum += S[other[m]] * wr;
    }
    return sum + S[i] * own;
  }

  /// Fills per_r and the speed at which each pair opens, times its distance: v_ij . r_ij [m^2/s].
  void find_openings() {
#pragma omp simd
    for (Index m = 0; m < padded; ++m) {
      per_r[m] = 1 / std::max(distance[m], 1e-300);
      double sum = 0;
      for (int k = 0; k < d; ++k) sum += v[k][m] * r[k][m];
      opening[m] = sum;
    }
  }

  Vec<d> r_of(Index m) const {
    Vec<d> apart;
    for (int k = 0; k < d; ++k) apart[k] = r[k][m];
    return apart;
  }
  Vec<d> v_of(Index m) const {
    Vec<d> apart;
    for (int k = 0; k < d; ++k) apart[k] = v[k][m];
    return apart;
  }

 private:
  /// One more pack than pairs: the last pair that is looked at may be no neighbour.
  static Index size_for(Index longest) {
    return (longest + 2 * width) / width * width;
  }

  /// Numbers one by one: vectors of three would go through memory, and every pair would wait for it.
  static std::array<double, d> numbers_of(const Vec<d>& a) {
    std::array<double, d> numbers;
    for (int k = 0; k < d; ++k) numbers[k] = a[k];
    return numbers;
  }

  void fill_velocities(const std::vector<Vec<d>>& of, Index i) {
    const std::array<double, d> here = numbers_of(of[i]);
    for (Index m = 0; m < padded; ++m)
      for (int k = 0; k < d; ++k) v[k][m] = here[k] - of[other[m]][k];
  }

  template <class Slope>
  void weigh(const Slope& slope) {
#pragma omp simd
    for (Index m = 0; m < padded; ++m) {
      const double far = std::sqrt(distance[m]);
      weight[m] *= slope(far);
      distance[m] = far;
    }
  }

  AlignedVector room_;
};

/// Calls use(i, row) for all particles, side by side, with the pairs of each.
template <int d, class Slope, class Use>
void for_rows(const MovingPairs<d, Slope>& pairs, Seen seen, Use&& use) {
  const Index particles = pairs.count();
  std::int64_t longest = 0;
  for (Index i = 0; i < particles; ++i)
    longest = std::max(longest, pairs.list.begin[i + 1] - pairs.list.begin[i]);
#pragma omp parallel if (particles >= particles_for_threads)
  {
    PairRow<d> row(longest);
#pragma omp for schedule(static)
    for (Index i = 0; i < particles; ++i) {
      row.fill(pairs, i, seen);
      use(i, static_cast<const PairRow<d>&>(row));
    }
  }
}

}  // namespace plumb
