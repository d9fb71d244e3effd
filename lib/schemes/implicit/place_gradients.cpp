#include "lib/schemes/implicit/place_gradients.hpp"

#include <algorithm>
#include <numeric>

namespace plumb {

template <int d>
void PlaceGradients<d>::add(std::span<const PlaceShare<d>> shares) {
  for (const PlaceShare<d>& share : shares) {
    particle_.push_back(static_cast<std::int32_t>(share.particle));
    for (int a = 0; a < rows_; ++a)
      for (int b = 0; b < d; ++b) slope_.push_back(share.slope(a, b));
  }
  begin_.push_back(static_cast<std::int64_t>(particle_.size()));
}

template <int d>
void PlaceGradients<d>::reserve(Index places, Index shares) {
  begin_.reserve(static_cast<std::size_t>(places) + 1);
  particle_.reserve(static_cast<std::size_t>(shares));
  slope_.reserve(static_cast<std::size_t>(shares * rows_ * d));
}

template <int d>
std::optional<std::int64_t> PlaceGradients<d>::number(Index place, Index particle) const {
  const auto first = particle_.begin() + begin_[static_cast<std::size_t>(place)],
             end = particle_.begin() + begin_[static_cast<std::size_t>(place) + 1];
  const auto found = std::lower_bound(first, end, static_cast<std::int32_t>(particle));
  if (found == end || *found != particle) return std::nullopt;
  return found - particle_.begin();
}

template <int d>
template <class Size>
Eigen::VectorXd PlaceGradients<d>::gradients_by(const Eigen::VectorXd& u, Size&& size) const {
  Eigen::VectorXd all(d * d * places());
#pragma omp parallel for schedule(static)
  for (Index q = 0; q < places(); ++q) {
    Mat<d> A = Mat<d>::Zero();
    for_each(q, [&](std::int64_t, const PlaceShare<d>& share) {
      A += Vec<d>(u.segment<d>(d * share.particle)).asDiagonal() * size(share.slope);
    });
    for (int n = 0; n < d * d; ++n) all[d * d * q + n] = A(n / d, n % d);
  }
  return all;
}

/// One thread: particles get what many places have for them, in the order of the places.
template <int d>
template <class Size>
Eigen::VectorXd PlaceGradients<d>::forces_by(const Eigen::VectorXd& w, const Eigen::VectorXd& P,
                                             Size&& size) const {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(d * particles_);
  for (Index q = 0; q < places(); ++q) {
    Mat<d> stress;
    for (int n = 0; n < d * d; ++n) stress(n / d, n % d) = w[q] * P[d * d * q + n];
    for_each(q, [&](std::int64_t, const PlaceShare<d>& share) {
      all.segment<d>(d * share.particle) += stress.cwiseProduct(size(share.slope)).rowwise().sum();
    });
  }
  return all;
}

template <int d>
Eigen::VectorXd PlaceGradients<d>::times(const Eigen::VectorXd& u) const {
  return gradients_by(u, [](const Mat<d>& slope) -> const Mat<d>& { return slope; });
}

template <int d>
Eigen::VectorXd PlaceGradients<d>::forces(const Eigen::VectorXd& w, const Eigen::VectorXd& P) const {
  return forces_by(w, P, [](const Mat<d>& slope) -> const Mat<d>& { return slope; });
}

template <int d>
Eigen::VectorXd PlaceGradients<d>::largest_gradients(const Eigen::VectorXd& u) const {
  return gradients_by(u.cwiseAbs(), [](const Mat<d>& slope) -> Mat<d> { return slope.cwiseAbs(); });
}

template <int d>
Eigen::VectorXd PlaceGradients<d>::largest_forces(const Eigen::VectorXd& w, const Eigen::VectorXd& P) const {
  return forces_by(w.cwiseAbs(), P.cwiseAbs(),
                   [](const Mat<d>& slope) -> Mat<d> { return slope.cwiseAbs(); });
}

template <int d>
Eigen::SparseMatrix<double, Eigen::RowMajor> PlaceGradients<d>::matrix(
    Index first, Index end, std::span<const Index> unknowns) const {
  std::vector<Index> number(static_cast<std::size_t>(d * particles_), -1);
  for (std::size_t n = 0; n < unknowns.size(); ++n)
    number[static_cast<std::size_t>(unknowns[n])] = static_cast<Index>(n);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(
      d * d * (begin_[static_cast<std::size_t>(end)] - begin_[static_cast<std::size_t>(first)])));
  for (Index q = first; q < end; ++q)
    for_each(q, [&](std::int64_t, const PlaceShare<d>& share) {
      for (int a = 0; a < d; ++a) {
        const Index column = number[static_cast<std::size_t>(d * share.particle + a)];
        for (int b = 0; column >= 0 && b < d; ++b)
          entries.emplace_back(d * d * (q - first) + d * a + b, column, share.slope(a, b));
      }
    });
  Eigen::SparseMatrix<double, Eigen::RowMajor> m(d * d * (end - first), static_cast<Index>(unknowns.size()));
  m.setFromTriplets(entries.begin(), entries.end());
  return m;
}

template <int d>
Eigen::SparseMatrix<double> PlaceGradients<d>::matrix() const {
  std::vector<Index> all(static_cast<std::size_t>(d * particles_));
  std::iota(all.begin(), all.end(), Index{0});
  return matrix(0, places(), all);
}

template class PlaceGradients<1>;
template class PlaceGradients<2>;
template class PlaceGradients<3>;

}  // namespace plumb
