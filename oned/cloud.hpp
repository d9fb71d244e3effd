#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lib/core/types.hpp"
#include "lib/geometry/cloud.hpp"
#include "oned/field.hpp"

namespace plumb::oned {

/// cell: n particles at (i + 1/2) dx with the volume dx; node: n + 1 at i dx, half volumes at the ends.
Layout layout_named(std::string_view name);

/// The support radius R: a multiple of the spacing, or fixed while the spacing shrinks.
struct Radius {
  double value = 4;
  bool fixed = false;  ///< value is R [m]; otherwise it is R / dx

  double over(double dx) const { return fixed ? value : value * dx; }
};

/// What defines a cloud on (0, L).
struct Discretisation {
  double length = 5;  ///< L [m]
  Index n = 40;       ///< number of cells; dx = L / n
  Layout layout = Layout::cell;
  double jitter = 0;  ///< largest displacement of a particle over dx, in [0, 1/2)
  std::uint64_t seed = 1;
  std::string kernel = "cubic";
  Radius radius;

  double dx() const { return length / static_cast<double>(n); }
  double support() const { return radius.over(dx()); }  ///< R [m]
};

/// The cloud of a discretisation, in ascending order, with Voronoi volumes if jittered. The same seed gives
/// the same cloud on every machine. In the node layout the end particles stay where they are. InputError for
/// sizes that are not positive, finite or in range.
Cloud<1> make_cloud(const Discretisation& discretisation);

/// A cloud from given positions in [0, length], in any order, with Voronoi volumes. Two particles nearer than
/// 1e-8 mean spacings count as coincident and are refused with both numbers (in the order given).
Cloud<1> voronoi_cloud(double length, const std::vector<double>& positions);

/// The particles j of [first, last) lie in the support of one point: |X_j - X| < R.
struct Window {
  Index first, last;
  Index count() const { return last - first; }
};

/// Particles at r = R (within 1e-12, relative) are outside: W(R) = 0, so nothing is lost and rounding decides
/// nothing.
double inner_radius(double R);

/// The window around any point x: two bisections.
Window window_at(const Cloud<1>& cloud, double R, double x);

/// The window around any point x of [0, length]. InputError if x lies outside or fewer than 2 particles lie
/// in it: no gradient exists there.
Window support_of(const Cloud<1>& cloud, double R, double length, double x);

/// The windows of all particles in linear time. InputError if a particle has no neighbour but itself, with
/// its number, position and number of neighbours: no gradient exists there.
std::vector<Window> windows(const Cloud<1>& cloud, double R);

/// What a user should know although it can be computed: R is the spacing, aliased waves.
std::vector<std::string> warnings(const Discretisation& discretisation, const std::vector<TestField>& fields);

}  // namespace plumb::oned
