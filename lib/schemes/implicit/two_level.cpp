#include "lib/schemes/implicit/two_level.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>

namespace plumb {
namespace {

constexpr double grid = 2;           // of spacings
constexpr int degree = 3;            // of the polynomial
constexpr double smoothed_part = 6;  // of the spectrum from the top: what the grid does not see
constexpr int power_steps = 10;
constexpr double safety = 1.1;  // of the largest eigenvalue, of which power iterations see most

/// Rows of all unknowns, columns of the components at the nodes of the grid around the particles.
template <int d>
SparseMatrix linear_on_grid(const Cloud<d>& cloud, const std::vector<Index>& unknowns) {
  const double cell = grid * cloud.spacing;
  Vec<d> lower = cloud.X.front();
  for (const auto& X : cloud.X) lower = lower.cwiseMin(X);
  std::vector<char> free(static_cast<std::size_t>(d * cloud.size()), 0);
  for (const Index n : unknowns) free[static_cast<std::size_t>(n)] = 1;
  std::map<std::array<Index, d>, Index> nodes;
  std::vector<Eigen::Triplet<double>> entries;
  for (Index i = 0; i < cloud.size(); ++i) {
    const Vec<d> at = (cloud.X[static_cast<std::size_t>(i)] - lower) / cell;
    for (int corner = 0; corner < 1 << d; ++corner) {
      std::array<Index, d> node;
      double share = 1;
      for (int k = 0; k < d; ++k) {
        const double below = std::floor(at[k]), part = at[k] - below;
        const bool upper = corner >> k & 1;
        node[static_cast<std::size_t>(k)] = static_cast<Index>(below) + (upper ? 1 : 0);
        share *= upper ? part : 1 - part;
      }
      if (share < 1e-9) continue;  // on a plane of the grid, but for rounding
      const Index number = nodes.try_emplace(node, static_cast<Index>(nodes.size())).first->second;
      for (int k = 0; k < d; ++k)
        if (free[static_cast<std::size_t>(d * i + k)]) entries.emplace_back(d * i + k, d * number + k, share);
    }
  }
  SparseMatrix all(d * cloud.size(), d * static_cast<Index>(nodes.size()));
  all.setFromTriplets(entries.begin(), entries.end());
  std::vector<Index> seen;  // nodes of held particles alone have nothing to move
  for (Index c = 0; c < all.cols(); ++c)
    if (all.col(c).nonZeros() > 0) seen.push_back(c);
  std::vector<Index> rows(static_cast<std::size_t>(all.rows()));
  for (std::size_t n = 0; n < rows.size(); ++n) rows[n] = static_cast<Index>(n);
  return part_of(all, rows, seen);
}

/// The rows of one of `components`, particle by particle.
SparseMatrix component_of(const SparseMatrix& all, int component, int components) {
  std::vector<Index> rows, columns;
  for (Index n = component; n < all.rows(); n += components) rows.push_back(n);
  for (Index n = 0; n < all.cols(); ++n) columns.push_back(n);
  return part_of(all, rows, columns);
}

/// w of every place with D = (w G)^T, from its largest entry.
template <int d>
Eigen::VectorXd weights_of_places(const LinearOperators& operators) {
  const SparseMatrix& G = operators.gradient;
  const Index places = G.rows() / (d * d);
  struct Entry {
    double value = 0;
    Index row = 0, column = 0;
  };
  std::vector<Entry> largest(static_cast<std::size_t>(places));
  for (Index c = 0; c < G.cols(); ++c)
    for (SparseMatrix::InnerIterator it(G, c); it; ++it) {
      Entry& entry = largest[static_cast<std::size_t>(it.row() / (d * d))];
      if (std::abs(it.value()) > std::abs(entry.value)) entry = {it.value(), it.row(), c};
    }
  Eigen::VectorXd w(places);
  for (Index q = 0; q < places; ++q) {
    const Entry& entry = largest[static_cast<std::size_t>(q)];
    w[q] = entry.value == 0 ? 0 : operators.force.coeff(entry.column, entry.row) / entry.value;
  }
  return w;
}

}  // namespace

template <int d>
TwoLevel<d>::TwoLevel(const Cloud<d>& cloud, const LinearOperators& operators,
                      const std::vector<Index>& unknowns)
    : operators_(operators), unknowns_(unknowns), place_weight_(weights_of_places<d>(operators)) {
  const SparseMatrix all = linear_on_grid(cloud, unknowns);
  coarse_gradient_ = operators.gradient * all;
  coarse_terms_.resize(all.cols(), all.cols());
  if (operators.terms.nonZeros() > 0)
    for (int k = 0; k < d; ++k) {
      const SparseMatrix part = component_of(all, k, d);
      coarse_terms_ += SparseMatrix(SparseMatrix(part.transpose()) * SparseMatrix(operators.terms * part));
    }
  std::vector<Index> columns(static_cast<std::size_t>(all.cols()));
  for (std::size_t n = 0; n < columns.size(); ++n) columns[n] = static_cast<Index>(n);
  coarse_ = part_of(all, unknowns, columns);
}

/// In pieces of the places: the product of all stresses with the gradients of coarse motions would be the largest matrix of all.
template <int d>
SparseMatrix TwoLevel<d>::coarse_stiffness(const SparseMatrix& material) const {
  constexpr int size = d * d;
  constexpr Index at_once = 4096;
  SparseMatrix sum = coarse_terms_;
  for (Index first = 0; first < place_weight_.size(); first += at_once) {
    const Index end = std::min<Index>(first + at_once, place_weight_.size());
    const SparseMatrix gradient = coarse_gradient_.middleRows(size * first, size * (end - first));
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(static_cast<std::size_t>((end - first) * size * size));
    for (Index q = first; q < end; ++q)
      for (int n = 0; n < size; ++n)
        for (int m = 0; m < size; ++m)
          entries.emplace_back(size * (q - first) + m, size * (q - first) + n,
                               place_weight_[q] * material.valuePtr()[(size * q + n) * size + m]);
    SparseMatrix tangents(gradient.rows(), gradient.rows());
    tangents.setFromTriplets(entries.begin(), entries.end());
    sum += SparseMatrix(SparseMatrix(gradient.transpose()) * SparseMatrix(tangents * gradient));
  }
  return sum;
}

template <int d>
void TwoLevel<d>::find_blocks(const SparseMatrix& material, const Eigen::VectorXd& weight) {
  constexpr int size = d * d;
  const SparseMatrix& G = operators_.gradient;
  const Index particles = G.cols() / d;
  std::vector<char> free(static_cast<std::size_t>(G.cols()), 0);
  for (const Index n : unknowns_) free[static_cast<std::size_t>(n)] = 1;
  inverse_.resize(static_cast<std::size_t>(particles));
#pragma omp parallel for schedule(static)
  for (Index j = 0; j < particles; ++j) {
    Mat<d> B = Mat<d>::Zero();
    std::array<Index, d> at;
    for (int k = 0; k < d; ++k) at[static_cast<std::size_t>(k)] = G.outerIndexPtr()[d * j + k];
    for (;;) {
      Index place = G.rows();  // the next one that any component of the particle takes part in
      for (int k = 0; k < d; ++k) {
        const Index p = at[static_cast<std::size_t>(k)];
        if (p < G.outerIndexPtr()[d * j + k + 1]) place = std::min<Index>(place, G.innerIndexPtr()[p] / size);
      }
      if (place == G.rows()) break;
      Eigen::Matrix<double, size, d> slope = Eigen::Matrix<double, size, d>::Zero();
      for (int k = 0; k < d; ++k)
        for (Index& p = at[static_cast<std::size_t>(k)];
             p < G.outerIndexPtr()[d * j + k + 1] && G.innerIndexPtr()[p] / size == place; ++p)
          slope(G.innerIndexPtr()[p] % size, k) = G.valuePtr()[p];
      const Eigen::Map<const Tangent<d>> T(material.valuePtr() + place * size * size);
      B += place_weight_[place] * slope.transpose() * T * slope;
    }
    for (int k = 0; k < d; ++k) {
      B(k, k) += operators_.terms.coeff(j, j);
      if (weight.size() > 0) B(k, k) += weight[d * j + k];
    }
    B = Mat<d>(0.5 * (B + B.transpose()));
    for (int k = 0; k < d; ++k)
      if (!free[static_cast<std::size_t>(d * j + k)]) {
        B.row(k).setZero();
        B.col(k).setZero();
        B(k, k) = 1;
      }
    const Eigen::LLT<Mat<d>> root(B);
    if (root.info() == Eigen::Success)
      inverse_[static_cast<std::size_t>(j)] = root.solve(Mat<d>::Identity());
    else  // a particle that is not stable by itself: its size will do
      inverse_[static_cast<std::size_t>(j)] = Mat<d>::Identity() / std::max(B.norm(), 1e-300);
  }
}

template <int d>
void TwoLevel<d>::move_to(const SparseMatrix& material, const Eigen::VectorXd& weight, const Product& K) {
  find_blocks(material, weight);
  SparseMatrix coarse = coarse_stiffness(material);
  if (weight.size() > 0) {
    Eigen::VectorXd free(static_cast<Index>(unknowns_.size()));
    for (Index n = 0; n < free.size(); ++n) free[n] = weight[unknowns_[static_cast<std::size_t>(n)]];
    coarse += SparseMatrix(SparseMatrix(coarse_.transpose()) * SparseMatrix(free.asDiagonal() * coarse_));
  }
  coarse = SparseMatrix(0.5 * (coarse + SparseMatrix(coarse.transpose())));
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
  Eigen::VectorXd all = Eigen::VectorXd::Zero(operators_.gradient.cols());
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
  const Eigen::VectorXd correction = coarse_ * factor_.solve(coarse_.transpose() * r);
  x += correction;
  r -= K(correction);
  return x + smoothed(K, r);
}

template class TwoLevel<1>;
template class TwoLevel<2>;
template class TwoLevel<3>;

}  // namespace plumb
