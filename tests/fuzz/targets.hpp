#pragma once
#include <cmath>
#include <stdexcept>
#include <string>

#include "oned/field.hpp"
#include "plumbline/core/error.hpp"
#include "plumbline/output/checkpoint.hpp"
#include "plumbline/output/sealed.hpp"
#include "plumbline/scene/expression.hpp"
#include "plumbline/scene/read_scene.hpp"
#include "plumbline/scene/study.hpp"

/// What may be fed with any bytes: each function reads them as the program would. InputError is the one right answer to
/// bytes that cannot be used; anything else that is thrown, and anything accepted that breaks its promise, is a fault.
namespace plumb::fuzz {

/// `what` must hold of whatever was accepted.
inline void promise(bool holds, const char* what) {
  if (!holds) throw std::logic_error(std::string("accepted, but ") + what);
}

inline void material_and_method(const MaterialChoice& m, const Method& method) {
  promise(m.young > 0 && std::isfinite(m.young) && m.density > 0 && std::isfinite(m.density), "stiffness or density");
  promise(m.poisson > -1 && m.poisson < 0.5, "Poisson's ratio");
  promise(method.beta > 0 && std::isfinite(method.beta), "beta");
  promise(method.cfl.has_value() != method.time_step.has_value(), "cfl and time step");
}

inline void scene(const std::string& bytes) {
  const Scene s = parse_scene(bytes, "scene.toml");
  promise(s.dimension == 2 || s.dimension == 3, "dimension");
  promise(s.end_time || s.max_steps, "no end");
  promise(!s.end_time || (*s.end_time > 0 && std::isfinite(*s.end_time)), "end time");
  promise(s.body.size.size() == static_cast<std::size_t>(s.dimension) && s.body.particles.size() == s.body.size.size(), "body");
  double particles = 1;
  for (const long n : s.body.particles) particles *= static_cast<double>(n);
  promise(particles >= 1 && particles <= 1.1e9, "number of particles");
  material_and_method(s.material, s.method);
}

inline void study(const std::string& bytes) {
  const Study s = parse_study(bytes, "study.toml");
  promise(!s.spacings.empty() && s.time.has_value() != s.periods.has_value(), "spacings or time");
  material_and_method(s.material, s.method);
}

inline void expression(const std::string& bytes) {
  const Expression e(bytes, 3);
  promise(std::isfinite(e.at({0.3, -1.7, 2.5})), "value");
}

inline void field(const std::string& bytes) {
  const oned::Field f = oned::parse_field(bytes);
  oned::value(f, 0.7);
  oned::derivative(f, 0.7);
}

/// The first byte chooses: the file as it is, or the rest behind a valid seal, so that the reader behind it is met.
inline void checkpoint(const std::string& bytes) {
  const bool seal = !bytes.empty() && bytes[0] == 's';
  const Checkpoint c = checkpoint_of(seal ? sealed(bytes.substr(1)) : bytes, "file");
  promise(c.displacement.size() == c.velocity.size() && is_finite(c), "state");
}

/// The call with its one right kind of refusal taken as an answer.
template <class Target>
void feed(Target&& target, const std::string& bytes) {
  try {
    target(bytes);
  } catch (const InputError&) {
    return;
  }
}

}  // namespace plumb::fuzz
