// The operators alone, without time: errors of F, of Div P and of the Laplacian on an exact field, inside and
// near the boundary, on lattices and jittered clouds; and the integration constraint, that is the force which
// a uniform stress leaves. `plumb operators` prints the same.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <iostream>

#include "mms/operators.hpp"
#include "places.hpp"

namespace plumb::operators_study {

namespace {

using Overrides = std::vector<std::string>;

struct Measured {
  mms::OperatorResult result;

  const OrderFit& fit(const std::string& name, const std::string& part) const {
    for (const auto& one : result.fits)
      if (one.name == name && one.part == part) return one.fit;
    throw std::logic_error(name);
  }
  /// Largest defect of the integration constraint over all levels.
  double constraint() const {
    double worst = 0;
    for (const auto& level : result.levels) worst = std::max(worst, level.constraint);
    return worst;
  }
};

Measured run(const char* file, const Overrides& overrides) {
  Measured m{mms::run_operators(
      read_study(std::string(PLUMBLINE_SOURCE_DIR "/verification/studies/") + file, overrides))};
  std::string what = file;
  for (const auto& o : overrides) what += " " + o;
  std::cout << what << '\n';
  for (const auto& fit : m.result.fits) {
    std::cout << fmt::format("  {:<11}{:<9}", fit.name, fit.part);
    for (const double error : fit.fit.errors) std::cout << fmt::format(" {:.3e}", error);
    std::cout << fmt::format("  order {:.2f} [{:.2f}, {:.2f}] {}\n", fit.fit.order, fit.fit.lower,
                             fit.fit.upper, fit.verdict);
  }
  return m;
}

Measured plate(const Overrides& overrides) {
  return run("operators.toml", overrides);
}

Measured cube(Overrides overrides) {
  overrides.insert(overrides.end(), {"study.periods=0.25", "study.parameters.amplitude=0.02", "body.seed=5"});
  return run("trigonometric_cube.toml", overrides);
}

Measured ring(Overrides overrides) {
  overrides.emplace_back("study.spacings=[0.03125,0.0208333333333333,0.015625,0.0104166666666667,0.0078125]");
  return run("generalized_vortex.toml", overrides);
}

const std::string coarse_cube = "study.spacings=[0.0625,0.05,0.0416666666666667,0.03125]";
const std::string fine_cube = "study.spacings=[0.0625,0.0416666666666667,0.03125,0.0208333333333333]";
const double round_off = 1e-13;  // of some hundred terms of order 1

}  // namespace

TEST_CASE("Operators: on lattices second order inside, less where supports are cut", "[operators]") {
  for (const char* momentum : {"method.momentum=adjoint", "method.momentum=symmetrised"}) {
    const Measured flat = plate({momentum});
    CHECK(judge(flat.fit("F", "inside"), 2) == Verdict::pass);
    CHECK(judge(flat.fit("Div P", "inside"), 2) == Verdict::pass);
    CHECK(flat.fit("F", "boundary").order > 1);
    CHECK(flat.fit("F", "boundary").order < 1.7);
    CHECK(flat.fit("Div P", "boundary").order < 0.5);
    CHECK(flat.constraint() < round_off);
  }
  const Measured solid = cube({fine_cube});
  CHECK(judge(solid.fit("F", "inside"), 2) == Verdict::pass);
  CHECK(judge(solid.fit("Div P", "inside"), 2) == Verdict::pass);
  CHECK(solid.constraint() < round_off);
}

TEST_CASE("Operators: on jittered clouds F is of first order and Div P does not converge", "[operators]") {
  for (const char* estimator : {"method.gradient=standard", "method.gradient=improved"}) {
    const Measured flat = plate({"body.jitter=0.2", estimator});
    // at 0.1 m the second-order part is as large as that of the jitter
    CHECK(flat.fit("F", "inside").order == Approx(1).margin(0.25));
    CHECK(flat.fit("Div P", "inside").order < 0.25);
  }
  const Measured solid = cube({coarse_cube, "body.jitter=0.2"});
  CHECK(solid.fit("F", "inside").order == Approx(1).margin(0.3));
  CHECK(solid.fit("Div P", "inside").order < 0.25);
}

// |f| d / |P| of order p limits Div P to order p - 1: 0 means that a uniform stress leaves a force which
// grows as 1/d.
TEST_CASE("Operators: the integration constraint is met on lattices only, and limits the order elsewhere",
          "[operators]") {
  for (const char* momentum : {"method.momentum=adjoint", "method.momentum=symmetrised"}) {
    CHECK(ring({"body.layout=cell", momentum}).constraint() < round_off);  // inside it is a lattice
    const Measured flat = plate({"body.jitter=0.2", momentum});
    CHECK(flat.fit("constraint", "inside").order == Approx(0).margin(0.1));
    CHECK(flat.result.levels.back().constraint > 0.1);
    const Measured solid = cube({coarse_cube, "body.jitter=0.2", momentum});
    CHECK(solid.fit("constraint", "inside").order == Approx(0).margin(0.2));
    CHECK(ring({momentum}).fit("constraint", "inside").order > 1);
  }
}

// The variationally consistent force meets it on every cloud; Div P is then of order 0 instead of -1.
TEST_CASE("Operators: the variationally consistent force meets the integration constraint", "[operators]") {
  const Measured flat = plate({"body.jitter=0.2", "method.momentum=variational"});
  CHECK(flat.constraint() < round_off);
  CHECK(flat.fit("Div P", "inside").order == Approx(0).margin(0.25));
  const Measured solid = cube({coarse_cube, "body.jitter=0.2", "method.momentum=variational"});
  CHECK(solid.constraint() < round_off);
  CHECK(ring({"method.momentum=variational"}).constraint() < round_off);
}

}  // namespace plumb::operators_study
