#pragma once
#include <vector>

#include "lib/schemes/tlsph/loops/solid.hpp"

namespace plumb {

/// What one particle has to do with another: a d x d table of numbers.
template <int d>
struct Share {
  Index other;
  int number;  ///< in the order in which they were found
  Mat<d> table;
};
template <int d>
using Shares = std::vector<Share<d>>;

/// Rows of the operators G and D of a body, particle by particle, THEORY (3.1), (5.1). The body must outlive it.
template <int d>
class OperatorRows {
 public:
  explicit OperatorRows(const Solid<d>& solid);

  /// Makes `shares` those of F_i, in the order of the others, each once: F_i,ab gets table_ab u_a of each.
  void gradient(Index i, Shares<d>& shares) const;
  /// Makes `shares` those of minus the force on i: its component a gets the sum over b of table_ab P_ab of each.
  void force(Index i, Shares<d>& shares) const;

 private:
  const Solid<d>& solid_;
  std::vector<Index> particle_;  ///< of a slot
};

}  // namespace plumb
