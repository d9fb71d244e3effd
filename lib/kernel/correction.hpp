#pragma once
#include <string_view>
#include <vector>

#include "lib/kernel/kernel.hpp"
#include "lib/kernel/neighbourhood.hpp"

namespace plumb {

/// Which corrected kernel and which gradient are used together (paper 000, section 2.2).
enum class Correction {
  none,   ///< W and grad W as they are
  W0raw,  ///< Shepard kernel (10) and its gradient (13), without L
  W0,     ///< Shepard kernel (10) with the L-corrected gradient (11)
  W1      ///< first-order kernel (6) with its full gradient (A.4)
};

/// Returns the name of the pair in scenes.
std::string_view name_of(Correction pair);
/// The pair of that name; InputError names the nearest valid one.
Correction pair_named(std::string_view name);

/// Corrected kernel and gradient at one particle, in the order of its neighbourhood and multiplied by the
/// volume. The gradient is the one with respect to the position X_i of the evaluation point.
template <int d>
struct CorrectedKernel {
  std::vector<double> weight;    ///< V_j W~_ij, dimensionless
  std::vector<Vec<d>> gradient;  ///< V_j grad W~_ij [1/m]
  double alpha = 1;              ///< of (6), (8); 1/sum V W for W0
  Vec<d> beta = Vec<d>::Zero();  ///< of (6), (7) [1/m]; zero unless W1
};

/// Evaluates the pair at the point from which the neighbourhood is seen. All sums are formed in units of h,
/// so that nothing under- or overflows whatever the size of the body. THEORY (2.1)-(2.8). Throws InputError
/// if a correction needs d independent neighbours and there are fewer.
template <int d>
CorrectedKernel<d> correct(Correction pair, const RadialKernel<d>& kernel, double h,
                           Neighbourhood<d> neighbours);

/// The L correction (11) with the transpose that (12) lacks: M^-T g with M = sum V X_ij (x) grad W, in place.
template <int d>
void normalise_gradient(Neighbourhood<d> neighbours, std::vector<Vec<d>>& gradient);

/// Number of independent directions among the neighbours (0 to d); geometry only, no kernel values, no
/// lengths.
template <int d>
int independent_directions(Neighbourhood<d> neighbours);

}  // namespace plumb
