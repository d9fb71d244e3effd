#pragma once
#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "lib/core/field.hpp"
#include "lib/schemes/scheme.hpp"

/// Runge-Kutta stages over whatever a state integrates in time.
namespace plumb {

/// The fields of a state that evolve, in their order.
template <SchemeState S>
std::vector<Field*> evolving(S& state) {
  std::vector<Field*> found;
  state.fields([&](const FieldInfo& info, Field& field) {
    if (info.role == Role::evolves) found.push_back(&field);
  });
  return found;
}

/// Gives a state the evolving fields, and only these, of another one.
template <SchemeState S>
void copy_evolving(S& from, S& to) {
  const auto source = evolving(from), target = evolving(to);
  for (std::size_t n = 0; n < source.size(); ++n) *target[n] = *source[n];
}

/// U <- kept U0 + fresh (U + dt R), field by field, over the first `slots` slots.
inline void blend(const std::vector<Field*>& U, const std::vector<Field*>& U0, const std::vector<Field*>& R,
                  Index slots, double kept, double fresh, double dt) {
  constexpr Index piece = 2048;
#pragma omp parallel for schedule(static) if (slots > 2 * piece)
  for (Index first = 0; first < slots; first += piece) {
    const Index end = std::min(first + piece, slots);
    for (std::size_t n = 0; n < U.size(); ++n)
      for (int k = 0; k < U[n]->components(); ++k) {
        double* u = (*U[n])[k];
        const double* u0 = (*U0[n])[k];
        const double* r = (*R[n])[k];
#pragma omp simd
        for (Index i = first; i < end; ++i) u[i] = kept * u0[i] + fresh * (u[i] + dt * r[i]);
      }
  }
}

/// Weights of the rates of the three stages in the step of ssp_rk3_step().
inline constexpr std::array<double, 3> ssp_rk3_weights = {1.0 / 6, 1.0 / 6, 2.0 / 3};

/// One step of the three-stage scheme (61) of paper 003, which keeps order 3 for loads that vary in time: its
/// stages stand at t, t + dt and t + dt/2. THEORY (7.1). `rates(state, time, rate)` fills the evolving fields
/// of `rate` and returns what is wrong; the state is then as it was. `before` and `rate` are room of the same
/// shape.
template <SchemeState S, class Rates>
std::optional<Trouble> ssp_rk3_step(S& state, S& before, S& rate, Index slots, double dt, Rates&& rates) {
  struct Stage {
    double kept, fresh, time;
  };
  constexpr Stage stages[] = {{0, 1, 0}, {3.0 / 4, 1.0 / 4, 1}, {1.0 / 3, 2.0 / 3, 1.0 / 2}};
  copy_evolving(state, before);
  const auto U = evolving(state), U0 = evolving(before), R = evolving(rate);
  for (const Stage& stage : stages) {
    if (auto trouble = rates(state, state.time + stage.time * dt, rate)) {
      copy_evolving(before, state);
      return trouble;
    }
    blend(U, U0, R, slots, stage.kept, stage.fresh, dt);
  }
  state.time += dt;
  ++state.step;
  return std::nullopt;
}

}  // namespace plumb
