#pragma once
#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/actions/actions.hpp"
#include "lib/geometry/cloud.hpp"
#include "lib/material/law.hpp"
#include "lib/measures/energy.hpp"
#include "lib/particles/role.hpp"
#include "lib/particles/snapshot.hpp"
#include "lib/particles/trouble.hpp"

/// What a folder of schemes/ must have to run in the harness.
namespace plumb {

/// A body before it moves: its particles and what they are made of.
template <int d>
struct Specimen {
  Cloud<d> cloud;
  LawChoice law;
  Elastic elastic;
};

/// Displacement [m] and velocity [m/s] of every particle at the start.
template <int d>
struct InitialMotion {
  std::vector<Vec<d>> u, v;
  std::vector<double> temperature = {};  ///< [K]; without entries the law's own

  std::optional<double> temperature_of(Index i) const {
    if (temperature.empty()) return std::nullopt;
    return temperature[static_cast<std::size_t>(i)];
  }
};

/// How many neighbours the particles of a scheme have now.
struct NeighbourCounts {
  Index pairs = 0;  ///< ordered pairs
  Index most = 0;   ///< of one particle
};

/// One line of what a scene solves: "force", "adjoint: minus the derivative ..", "THEORY (5.1), (5.3)".
struct Statement {
  std::string topic, text, theory;

  template <class Self, class Visit>
  static void members(Self& self, Visit&& visit) {
    visit("topic", self.topic);
    visit("text", self.text);
    visit("theory", self.theory);
  }
};

/// A state lists its fields: visit(FieldInfo, Field&).
template <class S>
concept SchemeState = requires(S& state) {
  { state.time } -> std::convertible_to<double>;
  { state.step } -> std::convertible_to<long>;
  state.fields([](const FieldInfo&, auto&) {});
};

/// A scheme for bodies in d dimensions: "mixed", "updated", "eulerian" and "element" are such, and as_simulation() of
/// run/any_scheme.hpp makes a Simulation of each. "tlsph" is older and fuses force and step (loops, time): as_simulation()
/// of scene/simulation.hpp makes its Simulation. "implicit" seeks equilibria of a body of "tlsph" or "element"
/// (scene/go_implicitly.hpp). A scheme is one folder. `advance` makes one step of dt and leaves the
/// state as it was if there is trouble. A scheme may also have, and then the harness uses them:
///   const Slots& layout() const;            where a particle stands in its fields (not a Layout of a cloud);
///                                           without it: at its number
///   NeighbourCounts neighbours() const;
///   static constexpr int evaluations_per_step;
///   std::vector<std::string> warnings() const;
template <class M, int d>
concept Scheme = SchemeState<typename M::State> && requires(M& m, typename M::State& state, double dt) {
  { M::name } -> std::convertible_to<std::string_view>;
  typename M::Options;
  { m.start(InitialMotion<d>{}) } -> std::same_as<typename M::State>;
  { m.step_limit(state) } -> std::convertible_to<double>;  // [s]
  { m.advance(state, dt) } -> std::same_as<std::optional<Trouble>>;
  { m.snapshot(state) } -> std::same_as<Snapshot<d>>;
  { m.energy(state) } -> std::same_as<Energy>;
  { m.account() } -> std::same_as<std::vector<Statement>>;
};

}  // namespace plumb
