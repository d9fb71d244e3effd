// Loads of manufactured solutions under plane stress: F_33 varies in space, so
// Div P needs its derivatives.
#include <gtest/gtest.h>

#include "mms/manufactured.hpp"

namespace plumb::mms {
namespace {

const Elastic rubber{17e6, 0.45, 1100};

TEST(PlaneStressSolution, DivergenceIsThatOfTheStressField) {
  for (const char* law : {"neo-hookean", "mooney-rivlin", "polyconvex", "saint-venant-kirchhoff",
                          "neo-hookean-logarithmic", "linear-elastic"}) {
    const Manufactured<2> m =
        manufactured<2>("generalized-vortex", {{"amplitude", 0.5}}, rubber, {law, {}, Plane::stress});
    const Vec<2> X(0.9, 0.4);
    const double t = 0.3 * m.period, h = 1e-3;
    Vec<2> expected = Vec<2>::Zero();  // central differences of fourth order
    for (int A = 0; A < 2; ++A) {
      const auto stress = [&](double k) -> Vec<2> {
        Vec<2> Y = X;
        Y[A] += k * h;
        return m.first_piola(m.motion(Y, t).F).col(A);
      };
      expected += (8 * (stress(1) - stress(-1)) - (stress(2) - stress(-2))) / (12 * h);
    }
    const Vec<2> found = m.stress_divergence(m.motion(X, t));
    EXPECT_GT(found.norm(), 1e3) << law;  // the field has a load there
    // h^4/30 times the fifth derivative of a wave number below 10, and
    // round-off of 1e-16/h
    EXPECT_LT((found - expected).norm(), 1e-7 * (found.norm() + rubber.young)) << law;
  }
}

// Small motions see the constants of plane stress: a standing wave of the sheet
// is slower than that of the slab, and needs no load.
TEST(PlaneStressSolution, SmallStandingWaveIsFreeOfLoadsWithTheSheetsPeriod) {
  const std::map<std::string, double> small{{"amplitude", 1e-7}};
  const Manufactured<2> slab = manufactured<2>("standing-wave", small, rubber);
  const Manufactured<2> sheet =
      manufactured<2>("standing-wave", small, rubber, {"neo-hookean", {}, Plane::stress});
  const double nu = rubber.poisson, E = rubber.young, rho = rubber.density;
  const double ratio = std::sqrt(rubber.wave_speed() * rubber.wave_speed() / (E / (rho * (1 - nu * nu))));
  EXPECT_NEAR(sheet.period / slab.period, ratio, 1e-12);
  const Vec<2> X = sheet.domain.box.origin + 0.3 * sheet.domain.box.size;
  const double t = 0.2 * sheet.period;
  const Motion<2> motion = sheet.motion(X, t);
  // what is left is of second order in the amplitude
  EXPECT_LT(sheet.body_force(X, t).norm(), 1e-5 * rho * motion.acceleration.norm());
  EXPECT_GT(slab.density * motion.acceleration.norm(), 0);
}

}  // namespace
}  // namespace plumb::mms
