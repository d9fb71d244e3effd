// Spectrum of the linearised operator (THEORY, section 9) against values found by independent calculation
// and against closed forms.
#include "lib/spectrum/spectrum.hpp"

#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>
#include <cmath>

#include "lib/scene/tlsph.hpp"
#include "lib/spectrum/lattice_symbol.hpp"

namespace plumb::spectrum_study {
namespace {

Scene block(int dimension, int n, double poisson) {
  Scene scene;
  scene.name = "free block";
  scene.dimension = dimension;
  scene.end_time = 1;
  scene.body.size.assign(dimension, 1.0);
  scene.body.spacing = 1.0 / n;
  scene.body.layout = Layout::cell;
  scene.material = {"neo-hookean", 17e6, poisson, 1100};
  return scene;
}

template <int d>
LinearOperator<d> operator_of(const Scene& scene) {
  const TlsphBody<d> simulation = make_tlsph<d>(scene);
  return {simulation.solid, simulation.supports};
}

/// A cube of 4^3 cells, W1, symmetrised, beta 0.9, nu 0.495.
Scene paper_cube(double eta4) {
  Scene scene = block(3, 4, 0.495);
  scene.method.gradient = "standard";
  scene.method.momentum = "symmetrised";
  if (eta4 > 0) scene.method.jst = JstOptions{0, eta4};
  return scene;
}

double growth(const Scene& scene) {
  auto op = operator_of<3>(scene);
  return spectrum_of(op).growth.rate;
}

TEST_CASE("the symmetrised form lets a free cube grow, JST only slows it", "[spectrum]") {
  // two significant digits are known: half a unit of the last one
  CHECK(growth(paper_cube(0)) == Approx(0.088).margin(0.0005));
  CHECK(growth(paper_cube(1.0 / 64)) == Approx(0.030).margin(0.0005));
  CHECK(growth(paper_cube(1.0 / 8)) == Approx(0.0043).margin(0.00005));
}

TEST_CASE("the adjoint form has real eigenvalues and no growth", "[spectrum]") {
  for (const char* gradient : {"standard", "improved"}) {
    Scene scene = paper_cube(0);
    scene.method.momentum = "adjoint";
    scene.method.gradient = gradient;
    auto op = operator_of<3>(scene);
    const Spectrum s = spectrum_of(op);
    CHECK(s.growth.rate == 0);
    CHECK(s.rigid.size() == 6);
    CHECK(s.asymmetry < 1e-15);
    // by the solver for general matrices, which does not know that it is symmetric
    const Eigen::VectorXcd all =
        Eigen::EigenSolver<Eigen::MatrixXd>(Eigen::MatrixXd(op.stiffness_matrix()), false).eigenvalues();
    CHECK(all.imag().cwiseAbs().maxCoeff() / s.largest < 1e-15);
  }
}

TEST_CASE("modes of nearly no energy appear for beta 1.2, with the standard gradient only", "[spectrum]") {
  double lowest[2];
  for (const double beta : {0.9, 1.2})
    for (const bool improved : {false, true}) {
      Scene scene = block(2, 10, 0.3);
      scene.method.beta = beta;
      scene.method.gradient = improved ? "improved" : "standard";
      auto op = operator_of<2>(scene);
      const Spectrum s = spectrum_of(op);
      CHECK(s.rigid.size() == 3);
      CHECK(s.low.near_zero_not_rigid == Count{beta == 1.2 && !improved ? 3 : 0, false});
      REQUIRE(s.lowest_nonrigid());
      lowest[improved] = *s.lowest_nonrigid();
      if (beta == 1.2) CHECK(s.low.modes[0].unexplained > 0.9);
    }
  // about fivefold on larger blocks; for this block it is 3.90
  CHECK(lowest[1] / lowest[0] > 3.5);
  CHECK(lowest[1] / lowest[0] < 6);
}

TEST_CASE("the iterations for larger bodies find what the full problem has", "[spectrum]") {
  for (const char* momentum : {"adjoint", "symmetrised"}) {
    Scene scene = block(2, 12, 0.4);
    scene.method.momentum = momentum;
    auto op = operator_of<2>(scene);
    const Spectrum full = spectrum_of(op), ends = spectrum_of(op, {.dense_limit = 10, .low_modes = 24});
    REQUIRE(full.complete);
    REQUIRE_FALSE(ends.complete);
    // 1e-7: the accuracy asked of the iteration is 1e-10 in the shifted problem
    CHECK(ends.largest == Approx(full.largest).epsilon(1e-7));
    CHECK(ends.lowest_nonrigid().value() == Approx(full.lowest_nonrigid().value()).epsilon(1e-7));
    CHECK(ends.rigid.size() == full.rigid.size());
    // power iteration stops at 1e-4
    CHECK(largest_eigenvalue(op) == Approx(full.largest).epsilon(1e-3));
  }
}

TEST_CASE("the solver's loops and the assembled matrix are the same operator", "[spectrum]") {
  Scene scene = block(3, 4, 0.45);
  scene.body.layout = Layout::node;
  scene.body.jitter = 0.2;
  Boundary clamp;
  clamp.face = Face{2, -1};
  scene.boundaries.push_back(clamp);
  auto op = operator_of<3>(scene);
  Eigen::VectorXd a(op.size());
  for (Index n = 0; n < a.size(); ++n) a[n] = std::sin(1.7 * static_cast<double>(n * n + 1));
  const Eigen::VectorXd by_loops = op.stiffness(a);
  // rounding of sums of some hundred terms
  CHECK((by_loops - op.stiffness_matrix() * a).norm() < 1e-13 * by_loops.norm());
  CHECK(op.rigid_motions().cols() == 0);
}

template <int d>
BondOptions<d> options_of(const char* estimator, const char* momentum) {
  BondOptions<d> options;
  options.kernel = kernel_named<d>("cubic");
  options.pair = Correction::W1;
  options.estimator = estimator_named<d>(estimator);
  options.momentum = momentum_form_named<d>(momentum);
  return options;
}

TEST_CASE("symbols on the line are those of an independent derivation", "[spectrum][symbol]") {
  const LatticeSymbol<1> standard(options_of<1>("standard", "adjoint"), 2.0),
      improved(options_of<1>("improved", "adjoint"), 2.0), bond(options_of<1>("bond", "adjoint"), 2.0),
      narrow(options_of<1>("improved", "adjoint"), 0.9);
  for (int n = 1; n <= 31; ++n) {
    const double theta = 0.1 * n;
    const Vec<1> t(theta);
    const double c = std::cos(theta), s = std::sin(theta);
    // margins: rounding of a sum of eight terms
    CHECK(standard.gradient(t)[0] == Approx(s * std::pow(std::cos(theta / 2), 4)).margin(1e-14));
    CHECK(improved.gradient(t)[0] == Approx(s * (5 + 3 * c + c * c) / 9).margin(1e-14));
    CHECK(bond.gradient(t)[0] == Approx(s * (17 + 6 * c + c * c) / 36).margin(1e-14));
    CHECK(narrow.gradient(t)[0] == Approx(s).margin(1e-14));
  }
}

template <int d>
void alternating_motion_is_not_seen() {
  for (const char* estimator : {"standard", "improved"}) {
    const LatticeSymbol<d> symbol(options_of<d>(estimator, "adjoint"), 1.2);
    for (int corner = 1; corner < (1 << d); ++corner) {
      Vec<d> theta;
      for (int k = 0; k < d; ++k) theta[k] = (corner >> k & 1) ? M_PI : 0;
      CHECK(symbol.gradient(theta).norm() < 1e-13);
    }
    // consistent: exact for long waves, with an error of second order
    const Vec<d> theta = Vec<d>::LinSpaced(0.01, 0.02);
    CHECK((symbol.gradient(theta) - theta).norm() < std::pow(theta.norm(), 3));
    CHECK((symbol.gradient(theta) - symbol.divergence(theta)).norm() < 1e-14);
  }
}

TEST_CASE("no estimator sees the alternating motion, in any dimension", "[spectrum][symbol]") {
  alternating_motion_is_not_seen<1>();
  alternating_motion_is_not_seen<2>();
  alternating_motion_is_not_seen<3>();
}

template <int d>
void symbol_matches_interior(const char* gradient, const char* momentum) {
  Scene scene = block(d, d == 2 ? 15 : 9, 0.4);
  scene.method.gradient = gradient;
  scene.method.momentum = momentum;
  auto op = operator_of<d>(scene);
  const LatticeSymbol<d> symbol(options_of<d>(gradient, momentum), scene.method.beta);
  const Vec<d> theta = Vec<d>::LinSpaced(0.7, 2.1), middle = Vec<d>::Constant(0.5);
  const Vec<d> direction = Vec<d>::LinSpaced(1, -0.4);
  Eigen::VectorXd a(op.size());
  const auto& X = op.solid().cloud.X;
  for (Index n = 0; n < op.size(); ++n) {
    const auto& [particle, axis] = op.components()[n];
    a[n] = direction[axis] * std::cos(theta.dot(X[particle] - middle) / op.solid().cloud.spacing);
  }
  const Eigen::VectorXd Ka = op.stiffness(a);
  const Vec<d> expected = symbol.dynamical_matrix(theta, op.solid().elastic) * direction;
  for (Index n = 0; n < op.size(); ++n)  // the middle particle: its neighbours' neighbours are inside
    if ((X[op.components()[n].particle] - middle).norm() < 1e-6)
      CHECK(Ka[n] == Approx(expected[op.components()[n].axis]).margin(1e-13));
}

TEST_CASE("inside a body the operator acts on a wave as its symbol says", "[spectrum][symbol]") {
  for (const char* gradient : {"standard", "improved"})
    for (const char* momentum : {"adjoint", "symmetrised"}) {
      symbol_matches_interior<2>(gradient, momentum);
      symbol_matches_interior<3>(gradient, momentum);
    }
}

}  // namespace
}  // namespace plumb::spectrum_study
