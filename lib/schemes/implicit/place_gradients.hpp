#pragma once
#include <Eigen/SparseCore>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lib/core/types.hpp"

namespace plumb {

/// What a displacement u_j of particle j adds to the gradient of a place: A_ab = u_a slope_ab. Rows of the slope differ only where walls
/// mirror j.
template <int d>
struct PlaceShare {
  Index particle;
  Mat<d> slope;  ///< [1/m]
};

/// G, the gradients of displacements at the places where a law is asked: particles, or points in elements. One row per place of
/// (particle, slope), where a sparse matrix would have the same numbers once for each component. Gradients and stresses are numbered
/// d^2 x place + d x row + column, displacements and forces d x particle + component.
template <int d>
class PlaceGradients {
 public:
  PlaceGradients() = default;
  /// `mirrored`: slopes may have rows of their own.
  PlaceGradients(Index particles, bool mirrored) : particles_(particles), rows_(mirrored ? d : 1) {}

  /// Makes room for so many.
  void reserve(Index places, Index shares);
  /// Appends a place: each particle at most once, ascending.
  void add(std::span<const PlaceShare<d>> shares);

  Index places() const { return static_cast<Index>(begin_.size()) - 1; }
  Index particles() const { return particles_; }
  Index shares() const { return static_cast<Index>(particle_.size()); }
  /// Calls use(number, share) for each share of a place, in the order in which they were added.
  template <class Use>
  void for_each(Index place, Use&& use) const {
    for (std::int64_t n = begin_[static_cast<std::size_t>(place)];
         n < begin_[static_cast<std::size_t>(place) + 1]; ++n)
      use(n, PlaceShare<d>{particle_[static_cast<std::size_t>(n)], slope(n)});
  }

  /// Returns the number of the particle's share of a place; nullopt: it has none.
  std::optional<std::int64_t> number(Index place, Index particle) const;
  Mat<d> slope(std::int64_t share) const {
    Mat<d> all;
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b)
        all(a, b) = slope_[static_cast<std::size_t>((share * rows_ + (rows_ == 1 ? 0 : a)) * d + b)];
    return all;
  }

  /// Returns G u [1] from u [m].
  Eigen::VectorXd times(const Eigen::VectorXd& u) const;
  /// Returns the sum over places of w_q G_q^T P_q [N] from stresses [Pa] and volumes w [m^d].
  Eigen::VectorXd forces(const Eigen::VectorXd& w, const Eigen::VectorXd& P) const;
  /// Returns these sums with the size of every number: no smaller than |G u| and |w G^T P|.
  Eigen::VectorXd largest_gradients(const Eigen::VectorXd& u) const;
  Eigen::VectorXd largest_forces(const Eigen::VectorXd& w, const Eigen::VectorXd& P) const;
  /// Returns G of the places from `first` to before `end` and of these unknowns, ascending, as a matrix.
  Eigen::SparseMatrix<double, Eigen::RowMajor> matrix(Index first, Index end,
                                                      std::span<const Index> unknowns) const;
  /// Returns all of it as a matrix.
  Eigen::SparseMatrix<double> matrix() const;

 private:
  template <class Size>
  Eigen::VectorXd gradients_by(const Eigen::VectorXd& u, Size&& size) const;
  template <class Size>
  Eigen::VectorXd forces_by(const Eigen::VectorXd& w, const Eigen::VectorXd& P, Size&& size) const;

  Index particles_ = 0;
  int rows_ = 1;  ///< of a slope that are kept
  std::vector<std::int64_t> begin_{0};
  std::vector<std::int32_t> particle_;
  std::vector<double> slope_;
};

}  // namespace plumb
