#pragma once
#include "lib/schemes/tlsph/compatible/solver/bond_operator.hpp"

namespace plumb {

/// Multipliers in single precision: the part of an approximate inverse that varies from particle to particle
/// need not be known better.
template <int d>
using RoughBlock = Eigen::Matrix<float, lanes<d>, d + 1>;
template <int d>
using RoughMultipliers = std::vector<RoughBlock<d>>;

/// The normal matrix with fixed volumes once more, in single precision and in an order in which particles
/// near each other are near each other in memory.
template <int d>
struct BondSmoother {
  struct Bond {
    std::int32_t other;  ///< place
    float weight;
  };
  /// Half the position; in 3D a fourth number fills the register.
  using Half = Eigen::Matrix<float, lanes<d>, 1>;
  using Square = Eigen::Matrix<float, d + 1, d + 1>;

  std::vector<std::int32_t> particle;  ///< per place
  std::vector<Half> half;              ///< per place
  std::vector<Index> begin;            ///< per place: its first bond; one more at the end
  std::vector<Bond> bonds;             ///< both directions; some more at the end, to be read but not used
  std::vector<Square> diagonal, inverse_diagonal;  ///< per place

  Index places() const { return static_cast<Index>(particle.size()); }
};

/// Makes the smoother of a matrix, in single precision.
template <int d>
BondSmoother<d> bond_smoother(const BondOperator<d>& N);

/// What one smoothing works on, by place; kept from one to the next, because fresh memory costs time.
template <int d>
struct BondWork {
  RoughMultipliers<d> r, x, z, next;
};

/// work.x = approximately N^-1 work.r, by `sweeps` steps of a Chebyshev polynomial; work.r becomes what is
/// left of it.
template <int d>
void smooth(const BondSmoother<d>& smoother, int sweeps, BondWork<d>& work);

}  // namespace plumb
