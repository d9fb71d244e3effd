#include "lib/schemes/implicit/two_level.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plumb {
namespace {

constexpr int degree = 3;            // of the polynomial
constexpr double smoothed_part = 6;  // of the spectrum from the top: what the grid does not see
constexpr int power_steps = 10;
constexpr double safety = 1.1;  // of the largest eigenvalue, of which power iterations see most

}  // namespace

template <int d>
TwoLevel<d>::TwoLevel(const Cloud<d>& cloud, const EnergyOperators<d>& operators,
                      const std::vector<Index>& unknowns)
    : operators_(operators), unknowns_(unknowns), coarse_(cloud, operators, unknowns) {}

/// The diagonal blocks of K, of held unknowns as well.
template <int d>
std::vector<Mat<d>> TwoLevel<d>::diagonal_blocks(const SparseMatrix& material) const {
  constexpr int size = d * d;
  const PlaceGradients<d>& G = operators_.gradient;
  std::vector<Mat<d>> blocks(static_cast<std::size_t>(G.particles()), Mat<d>::Zero());
  for (Index q = 0; q < G.places(); ++q) {
    const Eigen::Map<const Tangent<d>> T(material.valuePtr() + q * size * size);
    G.for_each(q, [&](std::int64_t, const PlaceShare<d>& share) {
      Mat<d>& B = blocks[static_cast<std::size_t>(share.particle)];
      for (int a = 0; a < d; ++a)
        for (int b = 0; b < d; ++b)
          B(a, b) += operators_.weight[q] *
                     (share.slope.row(a) * T.template block<d, d>(d * a, d * b)).dot(share.slope.row(b));
    });
  }
  const Eigen::VectorXd terms = operators_.half_of_terms.diagonal();
  for (Index j = 0; j < G.particles(); ++j)
    blocks[static_cast<std::size_t>(j)].diagonal().array() += terms[j];
  return blocks;
}

template <int d>
void TwoLevel<d>::find_blocks(const SparseMatrix& material, const Eigen::VectorXd& weight) {
  inverse_ = diagonal_blocks(material);
  std::vector<char> free(d * inverse_.size(), 0);
  for (const Index n : unknowns_) free[static_cast<std::size_t>(n)] = 1;
  for (std::size_t j = 0; j < inverse_.size(); ++j) {
    Mat<d> B = 0.5 * (inverse_[j] + inverse_[j].transpose());
    if (weight.size() > 0) B.diagonal() += weight.segment<d>(d * static_cast<Index>(j));
    for (std::size_t k = 0; k < d; ++k)
      if (!free[d * j + k]) {
        const auto at = static_cast<Index>(k);
        B.row(at).setZero();
        B.col(at).setZero();
        B(at, at) = 1;
      }
    const Eigen::LLT<Mat<d>> root(B);
    if (root.info() == Eigen::Success)
      inverse_[j] = root.solve(Mat<d>::Identity());
    else  // a particle that is not stable by itself: its size will do
      inverse_[j] = Mat<d>::Identity() / std::max(B.norm(), 1e-300);
  }
}

template <int d>
void TwoLevel<d>::move_to(const SparseMatrix& material, const Eigen::VectorXd& weight, const Product& K) {
  find_blocks(material, weight);
  SparseMatrix coarse = coarse_.stiffness(material);
  const SparseMatrix& P = coarse_.motions();
  if (weight.size() > 0) {
    Eigen::VectorXd free(static_cast<Index>(unknowns_.size()));
    for (Index n = 0; n < free.size(); ++n) free[n] = weight[unknowns_[static_cast<std::size_t>(n)]];
    coarse += SparseMatrix(SparseMatrix(P.transpose()) * SparseMatrix(free.asDiagonal() * P))
                  .template triangularView<Eigen::Lower>();
  }
  factor_.analyse(coarse);
  const double scale = coarse.diagonal().cwiseAbs().mean();
  double shift = 0;
  while (!factor_.factorise(coarse, shift * scale)) {
    shift = shift == 0 ? 1e-8 : 10 * shift;
    if (shift > 1e3) throw std::runtime_error("the stiffness on the coarse grid is not a number");
  }
  largest_ = safety * largest_ratio(K);
}

template <int d>
Eigen::VectorXd TwoLevel<d>::over_blocks(const Eigen::VectorXd& r) const {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(d * operators_.gradient.particles());
  for (std::size_t n = 0; n < unknowns_.size(); ++n) all[unknowns_[n]] = r[static_cast<Index>(n)];
  for (Index j = 0; j < all.size() / d; ++j)
    all.segment<d>(d * j) = inverse_[static_cast<std::size_t>(j)] * Vec<d>(all.segment<d>(d * j));
  Eigen::VectorXd free(r.size());
  for (std::size_t n = 0; n < unknowns_.size(); ++n) free[static_cast<Index>(n)] = all[unknowns_[n]];
  return free;
}

template <int d>
double TwoLevel<d>::largest_ratio(const Product& K) const {
  Eigen::VectorXd v(static_cast<Index>(unknowns_.size()));
  for (Index n = 0; n < v.size(); ++n)
    v[n] = std::sin(1.7 * static_cast<double>(n) + 0.3);  // no symmetry spares it
  double ratio = 1;
  for (int n = 0; n < power_steps; ++n) {
    const Eigen::VectorXd next = over_blocks(K(v / v.norm()));
    ratio = next.norm();
    v = next;
  }
  return ratio;
}

template <int d>
Eigen::VectorXd TwoLevel<d>::smoothed(const Product& K, Eigen::VectorXd& r) const {
  const double least = largest_ / smoothed_part, middle = (largest_ + least) / 2,
               half = (largest_ - least) / 2;
  double rho = half / middle;
  Eigen::VectorXd step = over_blocks(r) / middle, x = step;
  for (int n = 1; n < degree; ++n) {
    r -= K(step);
    const double next = 1 / (2 * middle / half - rho);
    step = next * rho * step + 2 * next / half * over_blocks(r);
    x += step;
    rho = next;
  }
  r -= K(step);
  return x;
}

template <int d>
Eigen::VectorXd TwoLevel<d>::operator()(const Product& K, const Eigen::VectorXd& residual) const {
  Eigen::VectorXd r = residual;
  Eigen::VectorXd x = smoothed(K, r);
  const SparseMatrix& P = coarse_.motions();
  const Eigen::VectorXd correction = P * factor_.solve(P.transpose() * r);
  x += correction;
  r -= K(correction);
  return x + smoothed(K, r);
}

template class TwoLevel<1>;
template class TwoLevel<2>;
template class TwoLevel<3>;

}  // namespace plumb
