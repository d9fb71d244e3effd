#pragma once
#include <cmath>
#include <string>

#include "lib/input/expression.hpp"
#include "lib/output/hdf5_image.hpp"
#include "lib/output/sealed.hpp"
#include "lib/run/checkpoint.hpp"
#include "lib/scene/read_scene.hpp"
#include "lib/scene/study.hpp"
#include "oned/field.hpp"
#include "tests/fuzz/points.hpp"

namespace plumb::fuzz {

inline bool good(double value) {
  return value > 0 && std::isfinite(value);
}

inline void material_and_method(const MaterialChoice& m, const Method& method) {
  promise(good(m.young) && good(m.density), "stiffness or density");
  promise(m.poisson > -1 && m.poisson < 0.5, "Poisson's ratio");
  promise(good(method.beta), "beta");
  promise(method.cfl.has_value() != method.time_step.has_value(), "cfl and time step");
  for (const auto& step : {method.cfl, method.time_step}) promise(!step || good(*step), "size of the step");
}

inline void terms(const std::optional<JstOptions>& jst, const std::optional<HourglassOptions>& hourglass) {
  if (jst)
    for (const double value : {jst->eta2, jst->eta4, jst->laplacian_factor})
      promise(std::isfinite(value) && value >= 0, "dissipation");
  if (hourglass) promise(std::isfinite(hourglass->alpha) && hourglass->alpha >= 0, "hourglass energy");
}

/// Formulas have a finite value or are refused where they are used.
inline void formulas(const std::vector<Expression>& list, int dimension) {
  promise(list.empty() || list.size() == static_cast<std::size_t>(dimension), "number of components");
  for (const auto& formula : list) promise(std::isfinite(formula.at({0.3, -1.7, 2.5})), "value of a formula");
}

inline void motion(const Scene& s) {
  if (s.initial) {
    promise(s.initial->velocity.empty() == s.initial->spin.has_value(), "velocity and spin");
    formulas(s.initial->velocity, s.dimension);
    if (s.initial->spin)
      for (const double w : *s.initial->spin) promise(std::isfinite(w), "spin");
  }
  for (const auto& boundary : s.boundaries) {
    promise(boundary.face.has_value() != boundary.where.has_value(), "face and where");
    promise(!boundary.face || (boundary.face->axis >= 0 && boundary.face->axis < s.dimension), "face");
    promise((boundary.kind == BoundaryKind::velocity) == !boundary.velocity.empty(), "prescribed velocity");
    formulas(boundary.velocity, s.dimension);
  }
}

inline void wanted_output(const Scene& s) {
  if (!s.output) return;
  for (const auto& interval : {s.output->every, s.output->checkpoint})
    promise(!interval || good(*interval), "interval");
  for (const auto& probe : s.output->probes) {
    promise(probe.at.size() == static_cast<std::size_t>(s.dimension), "place of a probe");
    for (const double x : probe.at) promise(std::isfinite(x), "place of a probe");
  }
}

inline void scene(const std::string& bytes) {
  const Scene s = parse_scene(bytes, "scene.toml");
  promise(s.dimension == 2 || s.dimension == 3, "dimension");
  promise(s.end_time || s.max_steps, "no end");
  promise(!s.end_time || good(*s.end_time), "end time");
  promise(!s.max_steps || *s.max_steps > 0, "number of steps");
  promise(s.body.size.size() == static_cast<std::size_t>(s.dimension) &&
              s.body.particles.size() == s.body.size.size(),
          "body");
  double particles = 1;
  for (const long n : s.body.particles) particles *= static_cast<double>(n);
  promise(particles >= 1 && particles <= 1.1e9, "number of particles");
  promise(good(s.body.spacing.value_or(0)) && s.body.jitter >= 0 && s.body.jitter < 0.5, "spacing or jitter");
  for (const double size : s.body.size) promise(good(size), "size");
  for (const double x : s.body.origin) promise(std::isfinite(x), "origin");
  material_and_method(s.material, s.method);
  terms(s.method.jst, s.method.hourglass);
  motion(s);
  wanted_output(s);
}

inline void study(const std::string& bytes) {
  const Study s = parse_study(bytes, "study.toml");
  promise(!s.spacings.empty() && s.time.has_value() != s.periods.has_value(), "spacings or time");
  for (const double d : s.spacings) promise(good(d), "a spacing");
  for (const auto& time : {s.time, s.periods}) promise(!time || good(*time), "time");
  for (const auto& [name, value] : s.parameters) promise(std::isfinite(value), "a parameter");
  material_and_method(s.material, s.method);
  terms(s.method.jst, s.method.hourglass);
}

inline void expression(const std::string& bytes) {
  const Expression e(bytes, 3);
  promise(std::isfinite(e.at({0.3, -1.7, 2.5})), "value");
}

inline void field(const std::string& bytes) {
  const oned::TestField f = oned::parse_field(bytes);
  for (const double number : oned::values(f, {Vec<1>(0.7)})) promise(std::isfinite(number), "value");
  for (const double number : oned::derivatives(f, {Vec<1>(0.7)})) promise(std::isfinite(number), "slope");
}

/// A whole checkpoint of two particles, without its seal.
inline const std::string& whole_checkpoint() {
  static const std::string whole = [] {
    Checkpoint c;
    c.program = "plumb";
    c.scene = {{"scene.name", "two"}, {"method.cfl", "0.5"}};
    c.dimension = 2;
    c.state.now.step = 7;
    for (const char* name : {"displacement", "velocity", "integrator"})
      c.state.fields.push_back({name, 2, {0.25, -0.5, 1, 3}});
    c.record.particle_times = {0, 0.125};
    return std::string(unsealed(bytes_of(c)));
  }();
  return whole;
}

/// The file with bytes exchanged: three of the input say where and for what.
inline std::string patched(const std::string& bytes, std::string file) {
  for (std::size_t n = 0; n + 2 < bytes.size(); n += 3) {
    const auto at = static_cast<unsigned char>(bytes[n]) * 256U + static_cast<unsigned char>(bytes[n + 1]);
    file[at % file.size()] = bytes[n + 2];
  }
  return file;
}

/// An HDF5 file of points: as it is, or, where it begins with another byte, a whole one of three points with
/// bytes exchanged as the input says.
inline void hdf5(const std::string& bytes) {
  static const std::string three = [] {
    Hdf5Image image;
    image.write("position", {0, 0, 1, 0, 0, 1}, 2);
    image.write("displacement", {0.5, 0, 1, 0, 0, 1}, 2);
    image.write("volume", std::vector<double>{1, 2, 3});
    return image.bytes();
  }();
  whole(parse_points(bytes.starts_with('\x89') ? bytes : patched(bytes, three), "file.h5"));
}

/// The first byte chooses: the file as it is, the rest behind a valid seal, or a whole checkpoint with the
/// changes that the rest says, so that the readers behind the seal and behind HDF5's first block are met.
inline void checkpoint(const std::string& bytes) {
  const char way = bytes.empty() ? ' ' : bytes[0];
  const Checkpoint c = checkpoint_of(way == 's'   ? sealed(bytes.substr(1))
                                     : way == 'p' ? sealed(patched(bytes.substr(1), whole_checkpoint()))
                                                  : bytes,
                                     "file");
  promise(!c.state.fields.empty() && is_finite(c), "state");
}

}  // namespace plumb::fuzz
