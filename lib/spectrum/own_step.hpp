#pragma once
#include <Eigen/Core>

#include "lib/run/simulation.hpp"

namespace plumb {

/// What a step of a scheme makes of small disturbances of a body's state: the eigenvalues of its derivative, which
/// the scheme's own steps give. Growth by the way the step is made is in it, and that of forces without an energy.
struct StepSpectrum {
  Index unknowns = 0;        ///< numbers of the state that act on each other
  double time_step = 0;      ///< [s]
  Eigen::VectorXcd factors;  ///< what a step multiplies each motion by
  double resolution = 0;     ///< [1/s]: slower growth may be rounding, THEORY (9.8)
  double growth = 0;         ///< fastest growth ln|factor| / step, or 0 if it is below the resolution [1/s]
  double growth_aperiodic = 0;  ///< likewise of positive factors: growth without oscillation [1/s]
  Index growing = 0;            ///< motions that grow faster than the resolution
  double fastest = 0;           ///< largest angle of a factor / step: the fastest oscillation [rad/s]
};

/// Units by which the numbers of a state are made comparable.
struct StateScales {
  double length, speed, density;  ///< spacing [m], wave speed [m/s], [kg/m^d]
};

/// Differentiates a step of the simulation about the state that it is in, and leaves it in some other one. The state
/// is disturbed by some 1e-12 of a spacing and steps once before, so that all that a scheme keeps of pairs is there.
/// Throws InputError beyond `most` unknowns, or if a step fails.
template <int d>
StepSpectrum spectrum_of_step(Simulation<d>& simulation, const StateScales& scales, Index most = 5000);

}  // namespace plumb
