// A small program of somebody else's: the first-order correction at the corner of a 2D lattice, by the
// installed package.
#include <cmath>
#include <cstdio>

#include "plumbline/kernel/correction.hpp"
#include "plumbline/schemes/tlsph/bonds/estimator.hpp"

int main() {
  const double spacing = 0.2;
  std::vector<plumb::Neighbour<2>> corner;
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b) corner.push_back({{a * spacing, b * spacing}, spacing * spacing});

  const auto kernel = plumb::kernel_named<2>("cubic");
  const auto corrected = plumb::correct<2>(plumb::Correction::W1, kernel, 0.9 * spacing, corner);
  const auto table = plumb::estimator_named<2>("improved")(corner, corrected);
  plumb::Mat<2> gradient = plumb::Mat<2>::Zero();  // of the map x = X: the identity
  for (std::size_t j = 0; j < corner.size(); ++j) gradient += corner[j].separation * table[j].transpose();

  std::printf("alpha = %.11f, beta = %.11f, F_xx = %.15f\n", corrected.alpha, corrected.beta[0],
              gradient(0, 0));
  const bool right = std::abs(corrected.alpha - 1.75308788617) < 1e-11 &&  // 12 digits are known
                     (gradient - plumb::Mat<2>::Identity()).norm() < 1e-13;
  return right ? 0 : 1;
}
