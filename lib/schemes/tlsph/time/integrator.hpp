#pragma once
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "lib/core/error.hpp"
#include "lib/schemes/tlsph/loops/solid.hpp"
#include "lib/schemes/tlsph/time/catalogue.hpp"  // made by CMake from integrators/*.hpp

namespace plumb {

/// Advances a body by dt. `step` names the particle where J is not positive or not a number, if any;
/// the state is then the one before the step. `order` is the order in dt that the scheme claims; a test
/// measures it. A new integrator is one file in integrators/. One that carries something from step to step
/// beside the state has `carried` and `carry` as in ChosenIntegrator, or a continued run differs.
template <class S, int d>
concept Integrator = std::constructible_from < S,
        const Solid<d>
& > &&requires(S& integrator, const Solid<d>& solid, Workspace<d>& workspace, State<d>& state, double dt) {
  { S::name } -> std::convertible_to<std::string_view>;
  { S::order } -> std::convertible_to<int>;
  { S::evaluations_per_step } -> std::convertible_to<int>;
  { integrator.step(solid, workspace, state, dt) } -> std::same_as<Outcome>;
  { integrator.bytes() } -> std::convertible_to<std::size_t>;
  { S::vectors_moved } -> std::convertible_to<int>;
};

/// Holds the bounds of lambda dt up to which an integrator bears a damped motion (negative real lambda) and
/// an undamped one (imaginary lambda).
struct StabilityLimits {
  double real_axis;
  double imaginary_axis;
};

/// Finds the limits of the integrator of that name. InputError names the nearest valid one.
inline StabilityLimits stability_limits(std::string_view integrator) {
  StabilityLimits limits{};
  const bool known = with_named(IntegratorCatalogue{}, integrator, [&]<class T>(Type<T>) {
    limits = {T::real_axis, T::imaginary_axis};
  });
  if (!known) throw unknown_name("integrator", integrator, names_of(IntegratorCatalogue{}));
  return limits;
}

/// An integrator chosen at run time.
template <int d>
struct ChosenIntegrator {
  std::string_view name;
  int order;
  int evaluations_per_step;
  std::size_t bytes;
  std::function<Outcome(const Solid<d>&, State<d>&, double dt)> step;
  std::shared_ptr<Workspace<d>> workspace;  ///< of the evaluations of its steps
  /// What it carries from step to step beside the state; null before the first step. Empty: it carries
  /// nothing.
  std::function<const Field*()> carried = {};
  std::function<void(const Field&)> carry = {};  ///< takes that of an earlier run, to continue it
  /// Weighs the forces of a step's evaluations in the change of v over dt; a single one counts at both ends of
  /// the step. Empty: unknown, and there is no budget.
  std::vector<double> weights = {};
  /// Vectors per particle that it reads and writes at every evaluation, for THEORY (10.8).
  int vectors_moved = 0;
};

/// Makes the integrator of that name for a body. InputError names the nearest valid name.
template <int d>
ChosenIntegrator<d> integrator_named(std::string_view name, const Solid<d>& solid) {
  ChosenIntegrator<d> integrator{};
  integrator.workspace = std::make_shared<Workspace<d>>();
  const bool known = with_named(IntegratorCatalogue{}, name, [&]<class T>(Type<T>) {
    using S = typename T::template Integrator<d>;
    static_assert(Integrator<S, d>);
    const auto s = std::make_shared<S>(solid);
    integrator.name = S::name;
    integrator.order = S::order;
    integrator.evaluations_per_step = S::evaluations_per_step;
    integrator.bytes = s->bytes();
    integrator.step = [s, workspace = integrator.workspace](const Solid<d>& body, State<d>& state,
                                                            double dt) {
      return s->step(body, *workspace, state, dt);
    };
    if constexpr (requires { s->carried(); }) {
      integrator.carried = [s] { return s->carried(); };
      integrator.carry = [s](const Field& field) { s->carry(field); };
    }
    integrator.vectors_moved = S::vectors_moved;
    if constexpr (requires { S::weights; })
      integrator.weights.assign(std::begin(S::weights), std::end(S::weights));
  });
  if (!known) throw unknown_name("integrator", name, names_of(IntegratorCatalogue{}));
  return integrator;
}

}  // namespace plumb
