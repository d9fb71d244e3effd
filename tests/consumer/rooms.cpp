// The rooms on top of the library, from the installed package: one header and one call of each.
#include <cmath>
#include <cstdio>

#include "mms/manufactured.hpp"
#include "oned/field.hpp"
#include "plumbline/schemes/tlsph/bonds/estimator.hpp"
#include "reports/picture.hpp"

int main() {
  const double slope = plumb::oned::derivative(plumb::oned::parse_field("poly:1,0,0,1"), 2);  // of X^3 + 1
  const auto solution = plumb::mms::solution_entry("affine-patch");
  const auto patch = plumb::mms::manufactured<2>(solution.name, {}, solution.material);
  const plumb::Vec<2> divergence = patch.stress_divergence(patch.motion(plumb::Vec<2>(0.3, 0.4), 0.01));
  const plumb::reports::Axis axis{"position", "m"};
  std::printf("slope %g, divergence %g, axis %s\n", slope, divergence.norm(), axis.label.c_str());
  // F is uniform: Div P = 0, to round-off of the bulk modulus
  const bool right =
      std::abs(slope - 12) < 1e-12 && divergence.norm() < 1e-9 * solution.material.bulk_modulus();
  return right ? 0 : 1;
}
