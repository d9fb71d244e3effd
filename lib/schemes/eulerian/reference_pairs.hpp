#pragma once
#include <memory>
#include <vector>

#include "lib/schemes/eulerian/spline_pairs.hpp"
#include "lib/schemes/moving_pairs.hpp"

namespace plumb {

/// What (28) of paper 001 needs of a reference: where its particles were, and weights of their pairs.
template <int d>
class ReferencePairs {
 public:
  /// Particles at x [m] with volumes V [m^d] and the pairs of that list.
  ReferencePairs(std::vector<Vec<d>> x, std::vector<double> V, std::shared_ptr<const PairList> list,
                 const SplinePairs<d>& kernel);

  const std::vector<Vec<d>>& x() const { return x_; }
  const std::vector<double>& V() const { return V_; }
  /// F_ref of (30): the deformation of particle i from the reference to the places x [m]; I where the
  /// neighbours do not span the space.
  Mat<d> gradient(const std::vector<Vec<d>>& x, Index i) const;

 private:
  std::vector<Vec<d>> x_;
  std::vector<double> V_;
  std::shared_ptr<const PairList> list_;
  std::vector<double> weight_;  ///< -V_j W'/r of each pair [m^-2]
  std::vector<Mat<d>> L_;       ///< (9); 0 where it is not defined
};

/// The inverse of M = sum V_j (x_j - x_i) (x) grad W, (9); 0 where the neighbours do not span the space.
template <int d>
Mat<d> correction(const Mat<d>& M) {
  constexpr double least = 1e-3;  // of M.det, relative to neighbours all around: a corner has 0.9
  return spans_space<d>(M, least) ? Mat<d>(M.inverse()) : Mat<d>(Mat<d>::Zero());
}

}  // namespace plumb
