#pragma once
#include "reports/body.hpp"
#include "reports/drawn_bodies.hpp"
#include "reports/results.hpp"

namespace plumb::reports {

/// The number of a drawn body against the one that a closed form or an independent solution gives, with its
/// source and the reason of its tolerance.
/// @throws MissingResult if the run wrote no such number.
Check number_of(const DrawnBody& body, const Results& results);

/// Where the material point X is: through the two layers of particles nearest to it in each direction,
/// multilinear, also a little beyond the outer ones. `values` in place of positions likewise.
/// @throws MissingResult where the particles are no lattice around X.
Point place_of(const BodyState& state, const Point& X);
double value_of(const BodyState& state, const Point& X);

/// Von Mises stress [Pa] of a bar pulled to `stretch` with free sides, neo-Hookean with moduli mu, kappa
/// [Pa]: mu J^(-5/3) (stretch^2 - t^2), t the side's stretch that leaves no stress across.
double uniaxial_stress(double stretch, double mu, double kappa);

/// Time of the second return through zero, between rows of a series that starts at zero: a period.
/// @throws MissingResult if there are not as many.
double first_period(const std::vector<double>& time, const std::vector<double>& displacement);

}  // namespace plumb::reports
