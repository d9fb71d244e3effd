#pragma once
#include <concepts>
#include <string_view>

#include "lib/material/law.hpp"

/// Laws whose stress depends on what was before: plasticity. They work in three
/// dimensions; plane strain in 2D.
namespace plumb {

/// What a law with history says about one increment.
struct Response {
  Mat<3> P;                 ///< first Piola-Kirchhoff stress [Pa]
  double equivalent = 0;    ///< q [Pa], the stress that the law compares with its yield stress
  double plastic_work = 0;  ///< of the increment, per reference volume [Pa]; never negative
  int iterations = 0;       ///< of the return mapping; 0: the increment was elastic
};

/// A law with history: `History` is a struct whose fields(visit) calls
/// visit(name, unit, value) for each of its values, a double or a Mat<3>.
/// stress() moves the history from the end of the last increment to the end of
/// this one; whoever integrates in stages gives it a copy and keeps that of the
/// last stage. potential() is what an increment that starts from `before` stores and dissipates: its derivative by F is P, and
/// tangent() is dP/dF. F
/// must have a positive determinant.
template <class M>
concept HistoryLaw = requires(const M& law, const Mat<3>& F, typename M::History& history,
                              const typename M::History& before) {
  { M::name } -> std::convertible_to<std::string_view>;
  { law.stress(F, history) } -> std::same_as<Response>;
  { law.energy(F, before) } -> std::convertible_to<double>;
  { law.potential(F, before) } -> std::convertible_to<double>;
  { law.tangent(F, before) } -> std::convertible_to<Mat<9>>;
  history.fields([](std::string_view, std::string_view, auto&) {});
};

}  // namespace plumb
