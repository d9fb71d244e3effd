// Somebody else's scheme: a bar of masses and springs that yield.
#pragma once
#include <cmath>

#include "plumbline/core/field.hpp"
#include "plumbline/schemes/scheme.hpp"

using plumb::Field, plumb::Index, plumb::Role;

struct Springs {  // unit length and area, E = rho = 1, both ends held; a spring of strain e has the stress e
                  // - plastic strain
  static constexpr std::string_view name = "springs";
  static constexpr int evaluations_per_step = 1;
  struct Options {
    double yield = 1e9;  // [Pa]
  } options;
  Index n;  // springs
  struct State {
    Field u, v, plastic, heat;
    double time = 0;
    long step = 0;
    void fields(auto&& visit) {
      visit(plumb::FieldInfo{"displacement", "m"}, u);
      visit(plumb::FieldInfo{"velocity", "m/s"}, v);
      visit(plumb::FieldInfo{"plastic strain", "", Role::history}, plastic);
      visit(plumb::FieldInfo{"heat", "J/m^3", Role::history}, heat);
    }
  };
  double d() const { return 1.0 / static_cast<double>(n); }
  double mass(Index i) const { return i == 0 || i == n ? d() / 2 : d(); }
  double stress(const State& s, Index i) const { return (s.u[0][i + 1] - s.u[0][i]) / d() - s.plastic[0][i]; }

  State start(const plumb::InitialMotion<1>& motion) const {
    State s{Field(1, n + 1, 0), Field(1, n + 1, 0), Field(1, n + 1, 0), Field(1, n + 1, 0)};
    for (std::size_t i = 0; i < motion.u.size(); ++i) s.u[0][i] = motion.u[i][0];
    for (std::size_t i = 0; i < motion.v.size(); ++i) s.v[0][i] = motion.v[i][0];
    return s;
  }
  double step_limit(const State&) const { return 0.4 * d(); }
  void kick(State& s, double dt) const {
    for (Index i = 1; i < n; ++i) s.v[0][i] += dt * (stress(s, i) - stress(s, i - 1)) / mass(i);
  }
  void yield(State& s) const {  // the stress goes back to the yield stress; what is lost is heat
    for (Index i = 0; i < n; ++i) {
      const double t = stress(s, i), over = std::abs(t) - options.yield;
      if (over <= 0) continue;
      s.plastic[0][i] += std::copysign(over, t);
      s.heat[0][i] += (t * t - options.yield * options.yield) / 2;
    }
  }
  std::optional<plumb::Trouble> advance(State& s, double dt) const {
    kick(s, dt / 2);
    for (Index i = 1; i < n; ++i) s.u[0][i] += dt * s.v[0][i];
    yield(s);
    kick(s, dt / 2);
    s.time += dt;
    ++s.step;
    return std::nullopt;
  }
  plumb::Snapshot<1> snapshot(const State& s) const {
    plumb::Snapshot<1> shown{.time = s.time, .step = s.step};
    shown.more.push_back({"plastic strain", "", {}});
    for (Index i = 0; i <= n; ++i) {
      const double t = stress(s, std::min(i, n - 1));
      shown.X.emplace_back(static_cast<double>(i) * d());
      shown.u.emplace_back(s.u[0][i]);
      shown.x.push_back(shown.X.back() + shown.u.back());
      shown.v.emplace_back(s.v[0][i]);
      shown.mass.push_back(mass(i));
      shown.volume.push_back(mass(i));
      shown.cauchy.push_back(plumb::Vec<3>(t, 0, 0).asDiagonal());
      shown.more[0].values.push_back(s.plastic[0][i]);
    }
    return shown;
  }
  plumb::Energy energy(const State& s) const {
    plumb::Energy e{0, 0, {}, 0.0};
    for (Index i = 0; i <= n; ++i) e.kinetic += mass(i) * s.v[0][i] * s.v[0][i] / 2;
    for (Index i = 0; i < n; ++i)
      e.strain += d() * stress(s, i) * stress(s, i) / 2, *e.dissipated += d() * s.heat[0][i];
    return e;
  }
  std::vector<plumb::Statement> account() const {
    return {{"force", "springs that yield between masses", ""}};
  }
};
