#pragma once
#include <functional>
#include <vector>

#include "lib/linear/cholesky.hpp"
#include "lib/schemes/implicit/coarse_grid.hpp"

namespace plumb {

/// An approximate inverse of a stiffness K = D T G + terms + weight of the free unknowns of a cloud, for conjugate gradients: motions that are
/// linear in the cells of a grid of two spacings by a direct solve, what is left by a Chebyshev polynomial of K over its diagonal
/// blocks, before and after. Symmetric and positive. THEORY (15.16).
template <int d>
class TwoLevel {
 public:
  using Product = std::function<Eigen::VectorXd(const Eigen::VectorXd& v)>;  ///< K v of free unknowns

  /// The cloud and the operators must outlive it. `unknowns`: the free ones, ascending.
  TwoLevel(const Cloud<d>& cloud, const EnergyOperators<d>& operators, const std::vector<Index>& unknowns);

  /// Moves to the tangents T of the law, to a weight of all unknowns (no entries: none) and to their K.
  void move_to(const SparseMatrix& material, const Eigen::VectorXd& weight, const Product& K);
  /// About K^-1 r.
  Eigen::VectorXd operator()(const Product& K, const Eigen::VectorXd& r) const;

  Index coarse_unknowns() const { return coarse_.unknowns(); }

 private:
  std::vector<Mat<d>> diagonal_blocks(const SparseMatrix& material) const;
  void find_blocks(const SparseMatrix& material, const Eigen::VectorXd& weight);
  Eigen::VectorXd over_blocks(const Eigen::VectorXd& r) const;
  /// The polynomial; r is left at what remains of it.
  Eigen::VectorXd smoothed(const Product& K, Eigen::VectorXd& r) const;
  double largest_ratio(const Product& K) const;

  const EnergyOperators<d>& operators_;
  const std::vector<Index>& unknowns_;
  CoarseGrid<d> coarse_;
  Cholesky factor_;
  std::vector<Mat<d>> inverse_;  ///< of the diagonal blocks, by particle
  double largest_ = 1;           ///< eigenvalue of K over its blocks
};

}  // namespace plumb
