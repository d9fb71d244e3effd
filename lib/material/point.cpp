#include "lib/material/point.hpp"

#include <cmath>

#include "lib/material/laws.hpp"
#include "lib/material/rate_models.hpp"

namespace plumb {
namespace {

template <class M>
MaterialPoint elastic_point(const M& law, Plane plane) {
  return [law, plane](const Mat<3>& given) {
    PointState state;
    state.F = given;
    if (plane == Plane::stress) {
      const Mat<2> in_plane = given.topLeftCorner<2, 2>();
      state.F = PlaneStress<M>::with_thickness(in_plane, PlaneStress<M>(law).thickness(in_plane));
    }
    const double J = determinant<3, double>(state.F);
    state.cauchy = law.first_piola(state.F) * state.F.transpose() / J;
    state.equivalent = von_mises(state.cauchy);
    return state;
  };
}

template <HistoryLaw M>
MaterialPoint history_point(const M& law) {
  return [law, history = typename M::History()](const Mat<3>& F) mutable {
    const double J = determinant<3, double>(F);
    const Response response = law.stress(F, history);
    PointState state{F, response.P * F.transpose() / J, response.equivalent, {}, {}, {}, response.iterations};
    if constexpr (requires { history.plastic_strain; }) state.plastic_strain = history.plastic_strain;
    if constexpr (requires { history.temperature; }) state.temperature = history.temperature;
    if constexpr (requires { history.damage; }) state.damage = history.damage;
    return state;
  };
}

}  // namespace

double von_mises(const Mat<3>& sigma) {
  const Mat<3> deviator = sigma - Mat<3>::Identity() * (sigma.trace() / 3);
  return std::sqrt(1.5) * deviator.norm();
}

MaterialPoint make_point(const LawChoice& choice, const Elastic& elastic) {
  require_law(choice, elastic);
  if (needs_rates(choice.name))
    throw InputError(choice.name + " at one point", "its stress depends on the length of time steps",
                     "run a body of scheme = \"eulerian\" or \"updated\"");
  MaterialPoint point;
  with_named(MaterialCatalogue{}, choice.name, [&]<class M>(Type<M>) {
    const M law = make_law<M>(elastic, choice);
    if constexpr (HistoryLaw<M>) {
      if (choice.plane == Plane::stress)
        throw InputError("plane stress with " + choice.name, "it is for elastic laws", "use plane strain");
      point = history_point(law);
    } else {
      point = elastic_point(law, choice.plane);
    }
  });
  return point;
}

}  // namespace plumb
