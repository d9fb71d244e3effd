// The same scene in other units and at other scales is the same scene: no absolute threshold stands anywhere.
#include "lib/scene/read_scene.hpp"
#include "lib/scene/tlsph.hpp"
#include "lib/spectrum/spectrum.hpp"
#include "lib/stability/stability_study.hpp"
#include "places.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace plumb::units_study {

namespace {

/// (length, mass, time) of one unit in SI.
struct Units {
  double length, mass, time;
};
/// mm-tonne-s; a millionth and a million of everything.
constexpr Units others[] = {{1e-3, 1e3, 1}, {1e-6, 1e-6, 1e-6}, {1e6, 1e6, 1e6}};

/// A formula in X, Y, Z [m], for coordinates in other units, times `factor`.
Expression scaled(const Expression& formula, double length, double factor, int dimension) {
  std::string text;
  for (const char c : formula.text()) {
    const bool axis = c == 'X' || c == 'Y' || c == 'Z';
    text += axis ? fmt::format("({}*{:.17g})", c, length) : std::string(1, c);
  }
  return Expression(factor == 1 ? text : fmt::format("{:.17g}*({})", factor, text), dimension);
}

void scale(std::vector<double>& lengths, double unit) {
  for (double& length : lengths) length /= unit;
}

void scale(Body& body, double unit) {
  scale(body.size, unit);
  scale(body.origin, unit);
  *body.spacing /= unit;
  for (auto& [name, lengths] : body.lengths) scale(lengths, unit);
  for (auto& hole : body.holes)
    for (auto& [name, lengths] : hole.lengths) scale(lengths, unit);
}

Scene scaled(const Scene& si, const Units& u) {
  Scene scene = si;
  const double speed = u.time / u.length;
  scale(scene.body, u.length);
  scene.material.young *= u.length * u.time * u.time / u.mass;
  scene.material.density *= u.length * u.length * u.length / u.mass;
  *scene.end_time /= u.time;
  if (scene.method.time_step) *scene.method.time_step /= u.time;
  for (auto& formula : scene.initial->velocity) formula = scaled(formula, u.length, speed, scene.dimension);
  if (scene.initial->spin)
    for (double& rate : *scene.initial->spin) rate *= u.time;
  for (auto& boundary : scene.boundaries) {
    if (boundary.where) boundary.where = scaled(*boundary.where, u.length, 1, scene.dimension);
    for (auto& formula : boundary.velocity) formula = scaled(formula, u.length, speed, scene.dimension);
  }
  return scene;
}

/// Largest difference of two fields over the largest value, the first one in units of `unit`.
template <int d>
double difference(const Field& one, const Field& si, double unit, const Solid<d>& solid) {
  double most = 0, apart = 0;
  for (Index p = 0; p < solid.cloud.size(); ++p) {
    const Index i = solid.bonds.slots.of(p);
    for (int k = 0; k < d; ++k) {
      most = std::max(most, std::abs(si[k][i]));
      apart = std::max(apart, std::abs(one[k][i] * unit - si[k][i]));
    }
  }
  return apart / most;
}

/// What rounding may do to a run. Particles are put on a curved surface along its normal, which comes from
/// differences over 1e-6 spacings: 1e-16/1e-6 of it is rounding, whatever the unit.
double rounding(const Scene& scene) {
  return scene.body.holes.empty() ? 1e-12 : 1e-8;
}

/// Runs both and compares every particle; small bodies also by their spectrum.
template <int d>
void expect_the_same(const Scene& si, const Units& u) {
  TlsphBody<d> reference = make_tlsph<d>(si), other = make_tlsph<d>(scaled(si, u));
  REQUIRE(other.solid.cloud.size() == reference.solid.cloud.size());
  const auto ended = run<d>(reference.solid, reference.state, reference.integrator, reference.control);
  const auto ended_too = run<d>(other.solid, other.state, other.integrator, other.control);
  REQUIRE(ended.completed());
  REQUIRE(ended_too.completed());
  CHECK(reference.state.step > 30);
  CHECK(other.state.step == reference.state.step);
  CHECK(ended_too.dt.first * u.time == Approx(ended.dt.first).epsilon(rounding(si)));
  CHECK(difference<d>(other.state.u, reference.state.u, u.length, reference.solid) < rounding(si));
  CHECK(difference<d>(other.state.v, reference.state.v, u.length / u.time, reference.solid) < rounding(si));
}

template <int d>
void expect_the_same_spectrum(const Scene& si, const Units& u) {
  const TlsphBody<d> one = make_tlsph<d>(si), two = make_tlsph<d>(scaled(si, u));
  LinearOperator<d> reference(one.solid, one.supports), other(two.solid, two.supports);
  const Spectrum a = spectrum_of(reference), b = spectrum_of(other);
  CHECK(b.largest == Approx(a.largest).epsilon(rounding(si)));
  REQUIRE(a.lowest_nonrigid());
  CHECK(b.lowest_nonrigid().value() ==
        Approx(*a.lowest_nonrigid()).epsilon(10 * rounding(si)));  // rounding is of the largest one
  CHECK(b.rigid.size() == a.rigid.size());
  CHECK(b.low.near_zero_not_rigid == a.low.near_zero_not_rigid);
}

/// Overrides; what begins with a bracket is a section of its own.
Scene scene_with(const char* text, const std::vector<std::string>& changes) {
  std::string all = text;
  std::vector<std::string> overrides;
  for (const auto& change : changes)
    change.front() == '[' ? void(all += change) : overrides.push_back(change);
  return parse_scene(all, "units.toml", overrides);
}

constexpr const char* plate = R"toml([scene]
dimension = 2
end_time = "4 ms"
[body]
size = [0.9, 0.7]
origin = [-0.3, 0.1]
spacing = 0.1
[material]
young = "17 MPa"
poisson = 0.45
density = 1100
[method]
gradient = "improved"
cfl = 0.3
[initial]
velocity = ["2*sin(3*X+2*Y)", "3*cos(2*X-Y)"]
[[boundary]]
where = "X < -0.24"
kind = "clamped"
)toml";

/// Overrides that bring every term, form and kind of cloud into a scene.
const std::vector<std::vector<std::string>> plates = {
    {},
    {"body.jitter=0.2", "method.pair=W0", "method.kernel=quintic"},
    {"body.layout=cell", "method.gradient=standard", "method.wave_speed=stretch"},
    {"method.gradient=bond38", "method.beta=1.2", "method.wave_speed=stretch-inverse"},
    {"method.momentum=symmetrised", "method.integrator=rk3", "jst.eta4=0.125"},
    {"method.momentum=symmetrised", "jst.eta2=0.01", "jst.outer=transpose", "jst.laplacian_factor=1"},
    {"hourglass.alpha=1", "body.jitter=0.2"},
    {"[projection]\n", "method.momentum=symmetrised", "method.integrator=rk3"},
    {"[projection]\n", "method.momentum=symmetrised", "method.integrator=verlet", "jst.eta4=0.125"},
    {"method.gradient=compatible"},
    {"method.gradient=compatible", "body.jitter=0.2", "hourglass.alpha=1"},
    {"method.gradient=compatible", "body.jitter=0.2", "compatible.start=standard",
     "compatible.volumes=fixed"},
    {"method.momentum=variational", "body.jitter=0.2"},
    {"material.model=mooney-rivlin", "method.time_step=1e-4"},
    {"body.hole=[{shape='ball', centre=[0.15, 0.45], radius=0.15}]", "method.gradient=compatible",
     "method.beta=1.2"}};

}  // namespace

TEST_CASE("every term in other units and at other scales gives the same motion", "[units]") {
  for (const auto& overrides : plates) {
    const Scene si = scene_with(plate, overrides);
    for (const Units& u : others) {
      INFO(fmt::format("{}, length {:g}", fmt::join(overrides, " "), u.length));
      expect_the_same<2>(si, u);
    }
  }
}

TEST_CASE("the spectrum is the same in other units and at other scales", "[units]") {
  for (const auto& overrides : plates) {
    if (!overrides.empty() && overrides.front() == "[projection]\n") continue;  // of states, not of forces
    const Scene si = scene_with(plate, overrides);
    for (const Units& u : others) {
      INFO(fmt::format("{}, length {:g}", fmt::join(overrides, " "), u.length));
      expect_the_same_spectrum<2>(si, u);
    }
  }
}

TEST_CASE("bodies in space and on rollers are the same in other units and at other scales", "[units]") {
  constexpr const char* cube = R"toml([scene]
dimension = 3
end_time = "8 ms"
[body]
size = [0.6, 0.5, 0.4]
spacing = 0.1
[material]
young = "17 MPa"
poisson = 0.3
density = 1100
[method]
gradient = "improved"
cfl = 0.3
[initial]
spin = [10, 20, 30]
)toml";
  const std::string rollers =
      "[[boundary]]\nface = 'x-'\nkind = 'roller'\n[[boundary]]\nface = 'y-'\nkind = 'roller'\n";
  const std::string pull = "[[boundary]]\nface = 'x+'\nkind = 'velocity'\nvelocity = ['2', '0', '3*Y']\n";
  const std::vector<std::vector<std::string>> bodies = {
      {},
      {"body.jitter=0.2", "hourglass.alpha=1", "body.cloud=blue-noise"},
      {rollers, "body.layout=mirror", "initial.velocity=['0', '3*X*Y', '5*Z']", "jst.eta4=0.125"},
      {rollers + pull, "method.momentum=symmetrised", "method.integrator=rk3", "jst.eta4=0.125"},
      {"[projection]\n", "method.momentum=symmetrised", "jst.eta4=0.125"},
      {"method.gradient=compatible", "body.jitter=0.2", "hourglass.alpha=0.5"}};
  for (const auto& overrides : bodies) {
    const Scene si = scene_with(cube, overrides);
    for (const Units& u : others) {
      INFO(fmt::format("{}, length {:g}", fmt::join(overrides, " "), u.length));
      expect_the_same<3>(si, u);
    }
  }
}

TEST_CASE("the schemes of the maps of stability end alike in other units and at other scales", "[units]") {
  const StabilityStudy study =
      read_stability_study(PLUMBLINE_SOURCE_DIR "/verification/stability/bending-cfl-nu.toml");
  for (const auto& variant : study.variants) {
    const auto overrides = overrides_of(study, variant, "0.45", 0.3);
    auto short_run = overrides;
    const bool nodes = std::ranges::find(overrides, "body.layout=node") != overrides.end();
    short_run.insert(short_run.end(), {"scene.end_time=10 ms", nodes ? "body.spacing=0.3333333333333333"
                                                                     : "body.particles=[4, 4, 24]"});
    const Scene si = varied_scene(study, short_run, 0.3);
    const auto reference = try_scene(si, study.bounds, [] { return true; });
    for (const Units& u : others) {
      const auto other = try_scene(scaled(si, u), study.bounds, [] { return true; });
      INFO(variant.name << ", length " << u.length);
      CHECK(other->cause == reference->cause);
      CHECK(other->steps == reference->steps);
      // Rounding of the scale factors, grown over some hundred steps of a smooth motion.
      CHECK(other->time * u.time == Approx(reference->time).epsilon(1e-12));
      CHECK(other->stretch == Approx(reference->stretch).epsilon(1e-12));
      CHECK(other->energy == Approx(reference->energy).epsilon(1e-12));
      CHECK(other->hourglass == Approx(reference->hourglass).epsilon(1e-11));
    }
  }
}

}  // namespace plumb::units_study
