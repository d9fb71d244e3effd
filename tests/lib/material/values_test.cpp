// Values of every elastic law at a stated deformation. They were found apart
// from this library, with 40 digits: W from the characteristic polynomial of C
// (logarithms of its roots for Hencky's law), P as its central difference with
// the step 1e-12. mu = 1 Pa, kappa = 5/3 Pa, so E = 5/2 Pa and nu = 1/4.
#include <gtest/gtest.h>

#include <cmath>

#include "lib/material/laws.hpp"

namespace plumb {
namespace {

const Elastic unit{2.5, 0.25, 1};

struct Values {
  const char* law;
  std::map<std::string, double> parameters;
  double W, P11, P12, P31, P33;   ///< at general()
  double thickness, in_plane[5];  ///< F_33 and W, P_11, P_12, P_21, P_22 under
                                  ///< plane stress at sheet()
};

const Values table[] = {
    {"neo-hookean",
     {},
     0.16257306666089764,
     0.22004977721095499,
     0.25064517204033119,
     -0.27292399259823247,
     0.3750774573083223,
     0.94553657875852542,
     {0.10485801618605676, 0.57666029387029998, 0.11542772319617001, 0.046458082544798051,
      -0.070882929093572269}},
    {"mooney-rivlin",
     {},
     0.16717260469565198,
     0.22536536314005258,
     0.28229655187187162,
     -0.27354795680081083,
     0.37224845128132832,
     0.94152105943152853,
     {0.10227116935948963, 0.55519382035555149, 0.11135253246162298, 0.045482318156187234,
      -0.072145582115689363}},
    {"mooney-rivlin",
     {{"ratio", 0.6}},
     0.17119720047606202,
     0.23001650082801296,
     0.30999150922446949,
     -0.27409392547806689,
     0.36977307100770859,
     0.93808797572465801,
     {0.099954828069873906, 0.53617420800993112, 0.10767267678537361, 0.044382576264311613,
      -0.072046804188809785}},
    {"polyconvex",
     {{"share", 0.4}},
     0.1736723445778775,
     0.2308357570354493,
     0.32343514296859679,
     -0.28087127276070438,
     0.37252396739110732,
     0.93806359207222145,
     {0.10004679589230316, 0.53738332704769981, 0.10801830495039902, 0.044832240602736783,
      -0.074018855164843401}},
    {"neo-hookean-logarithmic",
     {},
     0.17388526320783987,
     0.28049671651456809,
     0.26925379860440268,
     -0.29233839813920359,
     0.44590308186317062,
     0.941467870168254,
     {0.1109994517067129, 0.6296423735266946, 0.12551581928074385, 0.0489683614385123, -0.06829434935032994}},
    {"saint-venant-kirchhoff",
     {},
     0.235709375,
     0.68275,
     0.2765,
     -0.4955,
     1.01,
     0.90369611411506394,
     {0.16778333333333333, 1.1823333333333333, 0.22766666666666667, 0.064666666666666667, 0.013}},
    {"linear-elastic",
     {},
     0.1875,
     0.4,
     0.25,
     -0.3,
     0.6,
     0.93333333333333333,
     {0.11833333333333333, 0.73333333333333333, 0.1, 0.1, -0.066666666666666667}}};

Mat<3> general() {
  Mat<3> F;
  F << 1.1, 0.2, -0.1, 0.05, 0.9, 0.15, -0.2, 0.1, 1.2;
  return F;
}
Mat<2> sheet() {
  Mat<2> F;
  F << 1.3, 0.2, -0.1, 0.9;
  return F;
}

// Sums of numbers of size kappa, a few units in the last place of each.
constexpr double rounding = 4e-15;

TEST(MaterialValues, AtAGeneralDeformation) {
  for (const Values& v : table)
    with_elastic_law<3>({v.law, v.parameters}, unit, [&](const auto& law) {
      const Mat<3> P = law.first_piola(general());
      EXPECT_NEAR(law.energy(general()), v.W, rounding) << v.law;
      EXPECT_NEAR(P(0, 0), v.P11, rounding) << v.law;
      EXPECT_NEAR(P(0, 1), v.P12, rounding) << v.law;
      EXPECT_NEAR(P(2, 0), v.P31, rounding) << v.law;
      EXPECT_NEAR(P(2, 2), v.P33, rounding) << v.law;
    });
}

TEST(MaterialValues, UnderPlaneStress) {
  for (const Values& v : table)
    with_elastic_law<2>({v.law, v.parameters, Plane::stress}, unit, [&](const auto& law) {
      if constexpr (requires { law.thickness(sheet()); }) {
        EXPECT_NEAR(law.thickness(sheet()), v.thickness, rounding) << v.law;
      } else {
        FAIL() << v.law << " is not under plane stress";
      }
      const Mat<2> P = law.first_piola(sheet());
      EXPECT_NEAR(law.energy(sheet()), v.in_plane[0], rounding) << v.law;
      for (int n = 0; n < 4; ++n) EXPECT_NEAR(P(n / 2, n % 2), v.in_plane[n + 1], rounding) << v.law << n;
    });
}

TEST(MaterialValues,
     PolyconvexLawOfUntiedVariables) {  // at H, J of F: the conjugates that
                                        // paper 003's law has there
  const Polyconvex law(unit, {0.4});
  const Mat<3> F = general(), H = cofactor<3, double>(F);
  const double J = determinant<3, double>(F);
  const auto sigma = law.conjugates(F, H, J);
  EXPECT_NEAR(law.energy(F, H, J), 0.1736723445778775, rounding);
  EXPECT_NEAR(sigma.J, -1.18386452495774, 2e-14);  // given to 15 digits
  EXPECT_NEAR(sigma.H(0, 0), 0.379703165953449, rounding);
  EXPECT_NEAR(Polyconvex(unit).conjugates(F, H, J).J, -0.742627351930043, rounding);
  Mat<3> P = sigma.F + sigma.J * H;  // + Sigma_H x F, by the definition e_ijk e_IJK A_jJ B_kK
  const auto e = [](int a, int b, int c) { return 0.5 * (a - b) * (b - c) * (c - a); };
  for (int n = 0; n < 729; ++n) {
    const int i = n % 3, j = n / 3 % 3, k = n / 9 % 3, I = n / 27 % 3, K = n / 81 % 3, L = n / 243;
    P(i, I) += e(i, j, k) * e(I, K, L) * sigma.H(j, K) * F(k, L);
  }
  EXPECT_LT((P - law.first_piola(F)).norm(), 10 * rounding);
}

TEST(MaterialValues, PolyconvexWithoutShareIsNeoHookean) {
  const Mat<3> F = general();
  EXPECT_LT((Polyconvex(unit).first_piola(F) - NeoHookean(unit).first_piola(F)).norm(), rounding);
}

TEST(MaterialValues, MooneyRivlinIsNotPolyconvexAndPolyconvexIs) {
  // h^p J^-a with h = |cof F| is convex for h, J > 0 if and only if p >= 1 + a:
  // not the h^2 J^-4/3 of (4.4), but the h^3 J^-2 of (4.6), which is flat along
  // rays.
  const auto of_mooney = [](double h, double j) { return h * h * std::pow(j, -4.0 / 3); };
  const auto of_polyconvex = [](double h, double j) { return h * h * h / (j * j); };
  const auto hessian_determinant = [](const auto& g) {
    const double e = 1e-4;
    const auto at = [&](int a, int b) { return g(1.2 + a * e, 0.9 + b * e); };
    const double hh = at(1, 0) - 2 * at(0, 0) + at(-1, 0), jj = at(0, 1) - 2 * at(0, 0) + at(0, -1),
                 hj = 0.25 * (at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1));
    return (hh * jj - hj * hj) / std::pow(e, 4);
  };
  EXPECT_LT(hessian_determinant(of_mooney), -0.1);
  EXPECT_GT(hessian_determinant(of_polyconvex),
            -1e-3);  // 0; differences with the step 1e-4 leave 1e-6
}

TEST(MaterialValues, ParametersAreCheckedAtTheDoor) {
  const auto refused = [](const LawChoice& choice) {
    EXPECT_THROW(require_law(choice, unit), InputError) << choice.name;
  };
  refused({"mooney-rivlin", {{"ratio", -0.1}}});
  refused({"mooney-rivlin", {{"share", 0.1}}});
  refused({"polyconvex", {{"share", 1.1}}});
  refused({"neo-hookean", {{"ratio", 0.25}}});
  refused({"j2-logarithmic", {}});
  refused({"j2-logarithmic", {{"yield", 2.0}, {"saturation", 1.0}}});
  refused({"neohookean", {}});
  require_law({"j2-logarithmic", {{"yield", 2.0}, {"saturation", 3.0}}}, unit);
}

}  // namespace
}  // namespace plumb
