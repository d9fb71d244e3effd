#include "lib/schemes/eulerian/reference_pairs.hpp"

#include <array>

namespace plumb {

template <int d>
ReferencePairs<d>::ReferencePairs(std::vector<Vec<d>> x, std::vector<double> V,
                                  std::shared_ptr<const PairList> list, const SplinePairs<d>& kernel)
    : x_(std::move(x)),
      V_(std::move(V)),
      list_(std::move(list)),
      weight_(list_->other.size()),
      L_(x_.size()) {
  for_particles(static_cast<Index>(x_.size()), [&](Index i) {
    Mat<d> M = Mat<d>::Zero();
    for (auto n = list_->begin[i]; n < list_->begin[i + 1]; ++n) {
      const Vec<d> apart = x_[i] - x_[list_->other[n]];
      weight_[n] = -V_[list_->other[n]] * kernel(apart.norm());
      M += weight_[n] * apart * apart.transpose();
    }
    L_[i] = correction<d>(M);
  });
}

template <int d>
Mat<d> ReferencePairs<d>::gradient(const std::vector<Vec<d>>& x, Index i) const {
  if (L_[i] == Mat<d>::Zero()) return Mat<d>::Identity();
  // number by number: vectors of three would go through memory, and wait for it
  std::array<double, d * d> sum{};
  for (auto n = list_->begin[i]; n < list_->begin[i + 1]; ++n) {
    const Index j = list_->other[n];
    for (int k = 0; k < d; ++k) {
      const double apart = weight_[n] * (x[i][k] - x[j][k]);
      for (int l = 0; l < d; ++l) sum[k + l * d] += apart * (x_[i][l] - x_[j][l]);
    }
  }
  return Eigen::Map<const Mat<d>>(sum.data()) * L_[i];
}

template class ReferencePairs<1>;
template class ReferencePairs<2>;
template class ReferencePairs<3>;

}  // namespace plumb
