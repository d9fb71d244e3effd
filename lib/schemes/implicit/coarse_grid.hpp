#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "lib/geometry/cloud.hpp"
#include "lib/schemes/implicit/energy_operators.hpp"

namespace plumb {

/// Motions of a body that are linear in the cells of a grid of two spacings, and its stiffness for them, P^T K P of THEORY (15.16).
/// Unknowns are numbered d x node + component; those that move no free unknown have a stiffness of 1.
template <int d>
class CoarseGrid {
 public:
  /// `unknowns`: the free ones, ascending. The operators must outlive it.
  CoarseGrid(const Cloud<d>& cloud, const EnergyOperators<d>& operators, const std::vector<Index>& unknowns);

  Index unknowns() const { return d * nodes_; }
  const SparseMatrix& motions() const { return motions_; }  ///< P: rows of free unknowns
  /// The stiffness with the tangents T of the law; of the part above the diagonal only what is in its blocks.
  SparseMatrix stiffness(const SparseMatrix& material) const;

 private:
  using Place = std::array<Index, d>;  ///< of a node in the grid
  static constexpr int corners = 1 << d;

  /// Nodes around a particle, and what each of its free components takes of them.
  struct Corner {
    std::int32_t node = -1;  ///< -1: none
    double share = 0;
  };
  /// The nodes that a place of the law reads, with their slopes.
  struct Read {
    std::vector<std::int32_t> node;
    std::vector<Mat<d>> slope;
  };

  void set_nodes(const Cloud<d>& cloud);
  void set_motions(const std::vector<Index>& unknowns);
  void set_terms();
  void set_pattern();
  void read(Index place, std::vector<std::int32_t>& number, Read& found) const;
  Index code(std::int32_t row, std::int32_t column) const;
  Index entry(std::int32_t row, std::int32_t column, int a, int c) const;
  Index blocks_of(std::int32_t column) const {
    return first_[static_cast<std::size_t>(column) + 1] - first_[static_cast<std::size_t>(column)];
  }
  SparseMatrix stiffness_of_terms() const;

  const EnergyOperators<d>& operators_;
  Index nodes_ = 0;
  std::vector<Place> place_;                         ///< of each node
  std::vector<std::array<Corner, corners>> around_;  ///< each particle
  std::vector<char> free_;                           ///< each unknown of the particles
  SparseMatrix motions_;
  std::array<SparseMatrix, d> terms_;  ///< of each component, between nodes
  Index reach_ = 0;                    ///< of coupled nodes, in cells
  std::vector<std::int32_t> slot_;     ///< of the block at node x code in its column; -1: none
  std::vector<std::int32_t> row_;  ///< nodes that each node is coupled with, itself and later ones, ascending
  std::vector<Index> first_;       ///< of each node in row_
};

}  // namespace plumb
