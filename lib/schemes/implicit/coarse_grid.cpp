#include "lib/schemes/implicit/coarse_grid.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace plumb {
namespace {

constexpr double grid = 2;  // of spacings

}  // namespace

template <int d>
CoarseGrid<d>::CoarseGrid(const Cloud<d>& cloud, const EnergyOperators<d>& operators,
                          const std::vector<Index>& unknowns)
    : operators_(operators) {
  set_nodes(cloud);
  set_motions(unknowns);
  if (operators_.has_terms()) set_terms();
  set_pattern();
}

template <int d>
void CoarseGrid<d>::set_nodes(const Cloud<d>& cloud) {
  const double cell = grid * cloud.spacing;
  Vec<d> lower = cloud.X.front();
  for (const auto& X : cloud.X) lower = lower.cwiseMin(X);
  std::map<Place, std::int32_t> number;
  around_.resize(cloud.X.size());
  for (std::size_t i = 0; i < cloud.X.size(); ++i) {
    const Vec<d> at = (cloud.X[i] - lower) / cell;
    for (std::size_t corner = 0; corner < corners; ++corner) {
      Place place;
      double share = 1;
      for (int k = 0; k < d; ++k) {
        const double below = std::floor(at[k]), part = at[k] - below;
        const bool upper = corner >> k & 1;
        place[static_cast<std::size_t>(k)] = static_cast<Index>(below) + (upper ? 1 : 0);
        share *= upper ? part : 1 - part;
      }
      if (share < 1e-9) continue;  // on a plane of the grid, but for rounding
      const auto [found, is_new] = number.try_emplace(place, static_cast<std::int32_t>(place_.size()));
      if (is_new) place_.push_back(place);
      around_[i][corner] = {found->second, share};
    }
  }
  nodes_ = static_cast<Index>(place_.size());
}

template <int d>
void CoarseGrid<d>::set_motions(const std::vector<Index>& unknowns) {
  free_.assign(d * around_.size(), 0);
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t n = 0; n < unknowns.size(); ++n) {
    const Index unknown = unknowns[n];
    free_[static_cast<std::size_t>(unknown)] = 1;
    for (const Corner& corner : around_[static_cast<std::size_t>(unknown / d)])
      if (corner.node >= 0)
        entries.emplace_back(static_cast<Index>(n), d * corner.node + unknown % d, corner.share);
  }
  motions_.resize(static_cast<Index>(unknowns.size()), d * nodes_);
  motions_.setFromTriplets(entries.begin(), entries.end());
}

template <int d>
void CoarseGrid<d>::set_terms() {
  const SparseMatrix& half = operators_.half_of_terms;
  for (std::size_t k = 0; k < d; ++k) {
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t i = 0; i < around_.size(); ++i)
      for (const Corner& corner : around_[i])
        if (corner.node >= 0 && free_[d * i + k])
          entries.emplace_back(static_cast<Index>(i), corner.node, corner.share);
    SparseMatrix motions(half.rows(), nodes_);
    motions.setFromTriplets(entries.begin(), entries.end());
    const SparseMatrix across = motions.transpose();
    const SparseMatrix below = across * SparseMatrix(half * motions);
    const SparseMatrix diagonal = across * SparseMatrix(half.diagonal().asDiagonal() * motions);
    terms_[k] = SparseMatrix(below + SparseMatrix(below.transpose())) - diagonal;
  }
}

/// Where the node of a row lies as it is seen from that of a column: a number below (2 reach + 1)^d.
template <int d>
Index CoarseGrid<d>::code(std::int32_t row, std::int32_t column) const {
  Index all = 0;
  for (std::size_t k = 0; k < d; ++k)
    all = all * (2 * reach_ + 1) + reach_ + place_[static_cast<std::size_t>(row)][k] -
          place_[static_cast<std::size_t>(column)][k];
  return all;
}

/// The nodes of a place and their slopes. `number` is -1 for all nodes, before and after.
template <int d>
void CoarseGrid<d>::read(Index place, std::vector<std::int32_t>& number, Read& found) const {
  found.node.clear();
  found.slope.clear();
  operators_.gradient.for_each(place, [&](std::int64_t, const PlaceShare<d>& share) {
    Mat<d> slope = share.slope;
    for (int k = 0; k < d; ++k)
      if (!free_[static_cast<std::size_t>(d * share.particle + k)]) slope.row(k).setZero();
    for (const Corner& corner : around_[static_cast<std::size_t>(share.particle)]) {
      if (corner.node < 0) continue;
      std::int32_t& n = number[static_cast<std::size_t>(corner.node)];
      if (n < 0) {
        n = static_cast<std::int32_t>(found.node.size());
        found.node.push_back(corner.node);
        found.slope.push_back(Mat<d>::Zero());
      }
      found.slope[static_cast<std::size_t>(n)] += corner.share * slope;
    }
  });
  for (const std::int32_t node : found.node) number[static_cast<std::size_t>(node)] = -1;
}

template <int d>
void CoarseGrid<d>::set_pattern() {
  std::vector<std::int32_t> number(static_cast<std::size_t>(nodes_), -1);
  Read found;
  const auto for_each_pair = [&](auto&& use) {
    for (Index q = 0; q < operators_.gradient.places(); ++q) {
      read(q, number, found);
      for (const std::int32_t column : found.node)
        for (const std::int32_t row : found.node)
          if (row >= column) use(row, column);
    }
    for (const SparseMatrix& part : terms_)
      for (Index column = 0; column < part.cols(); ++column)
        for (SparseMatrix::InnerIterator it(part, column); it; ++it)
          if (it.row() >= column) use(static_cast<std::int32_t>(it.row()), static_cast<std::int32_t>(column));
  };
  for_each_pair([&](std::int32_t row, std::int32_t column) {
    for (std::size_t k = 0; k < d; ++k)
      reach_ = std::max(reach_, std::abs(place_[static_cast<std::size_t>(row)][k] -
                                         place_[static_cast<std::size_t>(column)][k]));
  });
  Index codes = 1;
  for (int k = 0; k < d; ++k) codes *= 2 * reach_ + 1;
  slot_.assign(static_cast<std::size_t>(nodes_ * codes), -1);
  for_each_pair([&](std::int32_t row, std::int32_t column) {
    slot_[static_cast<std::size_t>(column * codes + code(row, column))] = row;
  });
  first_.assign(1, 0);
  std::vector<std::pair<std::int32_t, std::size_t>> rows;
  for (Index column = 0; column < nodes_; ++column) {  // from rows to their places in the column
    rows.clear();
    for (Index c = column * codes; c < (column + 1) * codes; ++c)
      if (slot_[static_cast<std::size_t>(c)] >= 0)
        rows.emplace_back(slot_[static_cast<std::size_t>(c)], static_cast<std::size_t>(c));
    std::sort(rows.begin(), rows.end());
    for (std::size_t n = 0; n < rows.size(); ++n) {
      slot_[rows[n].second] = static_cast<std::int32_t>(n);
      row_.push_back(rows[n].first);
    }
    first_.push_back(static_cast<Index>(row_.size()));
  }
}

/// The place of an entry among those of the matrix: component a of the row's node, c of the column's.
template <int d>
Index CoarseGrid<d>::entry(std::int32_t row, std::int32_t column, int a, int c) const {
  const auto n = static_cast<std::size_t>(column);
  const Index codes = static_cast<Index>(slot_.size()) / nodes_;
  const Index slot = slot_[static_cast<std::size_t>(column * codes + code(row, column))];
  return d * d * first_[n] + c * d * blocks_of(column) + d * slot + a;
}

/// Zeros, and the stiffness of terms.
template <int d>
SparseMatrix CoarseGrid<d>::stiffness_of_terms() const {
  SparseMatrix K(unknowns(), unknowns());
  K.resizeNonZeros(d * d * first_.back());
  for (std::int32_t column = 0; column < nodes_; ++column) {
    const auto n = static_cast<std::size_t>(column);
    for (int c = 0; c < d; ++c) {
      K.outerIndexPtr()[d * column + c] =
          static_cast<SparseMatrix::StorageIndex>(d * d * first_[n] + c * d * blocks_of(column));
      for (Index b = first_[n]; b < first_[n + 1]; ++b)
        for (int a = 0; a < d; ++a) {
          const Index at = entry(row_[static_cast<std::size_t>(b)], column, a, c);
          K.innerIndexPtr()[at] = d * row_[static_cast<std::size_t>(b)] + a;
          K.valuePtr()[at] = 0;
        }
    }
  }
  K.outerIndexPtr()[unknowns()] = static_cast<SparseMatrix::StorageIndex>(d * d * first_.back());
  for (int k = 0; k < d; ++k)
    for (std::int32_t column = 0; column < terms_[static_cast<std::size_t>(k)].cols(); ++column)
      for (SparseMatrix::InnerIterator it(terms_[static_cast<std::size_t>(k)], column); it; ++it)
        if (it.row() >= column)
          K.valuePtr()[entry(static_cast<std::int32_t>(it.row()), column, k, k)] += it.value();
  return K;
}

template <int d>
SparseMatrix CoarseGrid<d>::stiffness(const SparseMatrix& material) const {
  constexpr int size = d * d;
  SparseMatrix K = stiffness_of_terms();
  std::vector<std::int32_t> number(static_cast<std::size_t>(nodes_), -1);
  Read found;
  for (Index q = 0; q < operators_.gradient.places(); ++q) {
    read(q, number, found);
    const Eigen::Map<const Tangent<d>> T(material.valuePtr() + q * size * size);
    for (std::size_t n = 0; n < found.node.size(); ++n) {
      Eigen::Matrix<double, size, d> stress;
      for (int c = 0; c < d; ++c)
        stress.col(c) =
            operators_.weight[q] * T.template middleCols<d>(d * c) * found.slope[n].row(c).transpose();
      for (std::size_t m = 0; m < found.node.size(); ++m) {
        if (found.node[m] < found.node[n]) continue;
        const Index first = entry(found.node[m], found.node[n], 0, 0), column = d * blocks_of(found.node[n]);
        for (int a = 0; a < d; ++a)
          for (int c = 0; c < d; ++c)
            K.valuePtr()[first + c * column + a] +=
                found.slope[m].row(a).dot(stress.template block<d, 1>(d * a, c));
      }
    }
  }
  for (Index n = 0; n < unknowns(); ++n)
    if (motions_.col(n).nonZeros() == 0) K.coeffRef(n, n) = 1;
  return K;
}

template class CoarseGrid<1>;
template class CoarseGrid<2>;
template class CoarseGrid<3>;

}  // namespace plumb
