#pragma once
#include <string>
#include <vector>

#include "lib/core/types.hpp"

namespace plumb {

/// One more number per particle that a scheme shows.
struct NamedValues {
  std::string name;
  std::string unit;
  std::vector<double> values;  ///< one per particle
};

/// What a scheme shows of its state, one entry per particle. It is made when something is recorded or
/// measured, not at every step, and is all that files, norms and measures read.
template <int d>
struct Snapshot {
  double time = 0;  ///< [s]
  long step = 0;
  std::vector<Vec<d>> X;          ///< reference position, the particle's label [m]
  std::vector<Vec<d>> u;          ///< displacement x - X [m], with all its digits
  std::vector<Vec<d>> x;          ///< position [m]
  std::vector<Vec<d>> v;          ///< velocity [m/s]
  std::vector<double> mass;       ///< [kg] (per metre of thickness in 2D, per square metre in 1D)
  std::vector<double> volume;     ///< current volume [m^d]
  std::vector<Mat<3>> F;          ///< deformation gradient; empty where the scheme has none
  std::vector<Mat<3>> cauchy;     ///< Cauchy stress [Pa]; the out-of-plane components count
  std::vector<NamedValues> more;  ///< plastic strain, damage, temperature ..
};

}  // namespace plumb
