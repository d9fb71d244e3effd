#include "mms/finite_equilibrium.hpp"

#include <fmt/format.h>

#include "lib/core/error.hpp"
#include "lib/schemes/implicit/equilibrium.hpp"
#include "mms/static_surface.hpp"

namespace plumb::mms {
namespace {

/// The surface goes to its place, and the force grows, in one unit of time.
template <int d>
Actions<d> actions_of(const Study& study, const Solid<d>& solid, const Manufactured<d>& solution,
                      double time) {
  Actions<d> actions;
  Held<d> surface{"surface", {}, {}, false};
  CurvedSurface<d> whole = whole_surface<d>(study, solution, solid);
  for (const Index i : whole.displaced)
    for (int k = 0; k < d; ++k) surface.places.push_back({i, k, solid.cloud.X[i]});
  surface.motion = [displacement = solution.motion, time](const Vec<d>& at, int component, double share) {
    const double u = displacement(at, time).displacement[component];
    return HeldMotion{share * u, u, 0};
  };
  actions.held.push_back(std::move(surface));
  if (!whole.pulled.empty()) {
    SurfaceLoad<d> traction{"traction", std::move(whole.pulled), {}, {}, true};
    traction.traction = [&solution, time](const Vec<d>& at, const Vec<d>& normal, double) -> Vec<d> {
      return solution.traction(at, time, normal);
    };
    actions.surface.push_back(std::move(traction));
  }
  BodyForce<d> force{"force", {}, true};
  force.per_volume = [&solution, time](const Vec<d>& X, double) -> Vec<d> {
    return -solution.stress_divergence(solution.motion(X, time));
  };
  actions.body_forces.push_back(std::move(force));
  return actions;
}

}  // namespace

template <int d>
Eigen::VectorXd finite_equilibrium(const Study& study, TlsphBody<d>& body, const Manufactured<d>& solution,
                                   double time) {
  const Solid<d>& solid = body.solid;
  State<d> state = make_state(solid);
  const auto result = find_equilibrium<d>(solid, actions_of<d>(study, solid, solution, time), 1,
                                          study.method.implicit, state);
  if (!result.completed())
    throw InputError("no equilibrium is found", result.failure->in_words(), "take more [implicit] steps");
  Eigen::VectorXd u(d * solid.cloud.size());
  for (Index i = 0; i < solid.cloud.size(); ++i)
    u.template segment<d>(d * i) = vector_at<d>(state.u, solid.bonds.slots.of(i));
  return u;
}

template Eigen::VectorXd finite_equilibrium<1>(const Study&, TlsphBody<1>&, const Manufactured<1>&, double);
template Eigen::VectorXd finite_equilibrium<2>(const Study&, TlsphBody<2>&, const Manufactured<2>&, double);
template Eigen::VectorXd finite_equilibrium<3>(const Study&, TlsphBody<3>&, const Manufactured<3>&, double);

}  // namespace plumb::mms
