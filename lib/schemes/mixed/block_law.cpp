#include "lib/schemes/mixed/block_law.hpp"

#include "lib/core/error.hpp"
#include "lib/material/laws.hpp"
#include "lib/material/models/polyconvex.hpp"
#include "lib/material/tangent.hpp"
#include "lib/schemes/gather.hpp"
#include "lib/schemes/tensors.hpp"

namespace plumb {
namespace {

/// Calls use.operator()<W>(slot) for the slots from begin to end, in packs as long as they are whole.
template <class Use>
void in_packs(Index begin, Index end, Use&& use) {
  Index i = begin;
  for (; i + native_width <= end; i += native_width) use.template operator()<native_width>(i);
  for (; i < end; ++i) use.template operator()<1>(i);
}

template <int W>
double sum_of(const Pack<W>& values) {
  double sum = 0;
  for (int lane = 0; lane < W; ++lane) sum += values[lane];
  return sum;
}

template <int d>
Mat<d> gradient_of(const Field& F, Index i) {
  Mat<d> A;
  for (int a = 0; a < d; ++a)
    for (int b = 0; b < d; ++b) A(a, b) = F[a * d + b][i];
  return A;
}
template <int d>
Mat<3> whole_gradient(const Field& F, Index i) {
  return in_3d<d, double>(gradient_of<d>(F, i), 1);
}

template <int d, class M>
BlockLaw<d> tied_law(const M& law) {
  BlockLaw<d> made;
  made.stress = [law](const MixedState<d>&, const Field& F, Index begin, Index end, Field& P) {
    in_packs(begin, end,
             [&]<int W>(Index i) { store_tensor<d, W>(law.first_piola(load_tensor<d, W>(F, i)), P, i); });
  };
  made.energy = [law](const MixedState<d>&, const Field& F, const double* volume, Index begin, Index end) {
    double sum = 0;
    in_packs(begin, end, [&]<int W>(Index i) {
      sum += sum_of<W>(law.energy(load_tensor<d, W>(F, i)) * Pack<W>::load(volume + i));
    });
    return sum;
  };
  made.whole = [law](const MixedState<d>&, const Field& F, Index i) -> WholePoint {
    if constexpr (requires { law.law; }) {  // plane stress
      const Mat<2> in_plane = gradient_of<2>(F, i);
      const Mat<3> thick = M::with_thickness(in_plane, law.thickness(in_plane));
      return {thick, law.law.first_piola(thick)};
    } else {
      const Mat<3> thick = whole_gradient<d>(F, i);
      return {thick, law.first_piola(thick)};
    }
  };
  return made;
}

/// P = Sigma_F + Sigma_H x F + Sigma_J H, (6) of paper 003, with H and J of the state.
template <int d>
BlockLaw<d> evolved_law(const Polyconvex& law) {
  BlockLaw<d> made;
  made.stress = [law](const MixedState<d>& state, const Field& F, Index begin, Index end, Field& P) {
    in_packs(begin, end, [&]<int W>(Index i) {
      using Real = Pack<W>;
      const Mat<3, Real> whole = in_3d<d, Real>(load_tensor<d, W>(F, i), Real(1));
      const Mat<3, Real> H = load_tensor<3, W>(state.H, i);
      const auto sigma = law.conjugates<Real>(whole, H, Real::load(state.J[0] + i));
      const Mat<3, Real> cross = tensor_cross<Real>(sigma.H, whole);
      for (int a = 0; a < d; ++a)
        for (int b = 0; b < d; ++b) (sigma.F(a, b) + cross(a, b) + sigma.J * H(a, b)).store(P[a * d + b] + i);
    });
  };
  made.of_volume = [law](const MixedState<d>& state, const Field& F, Index begin, Index end, Field& sigma) {
    for (Index i = begin; i < end; ++i)
      sigma[0][i] =
          law.conjugates<double>(whole_gradient<d>(F, i), gradient_of<3>(state.H, i), state.J[0][i]).J;
  };
  made.energy = [law](const MixedState<d>& state, const Field& F, const double* volume, Index begin,
                      Index end) {
    double sum = 0;
    in_packs(begin, end, [&]<int W>(Index i) {
      using Real = Pack<W>;
      const Mat<3, Real> whole = in_3d<d, Real>(load_tensor<d, W>(F, i), Real(1));
      sum += sum_of<W>(law.energy<Real>(whole, load_tensor<3, W>(state.H, i), Real::load(state.J[0] + i)) *
                       Real::load(volume + i));
    });
    return sum;
  };
  made.whole = [law](const MixedState<d>& state, const Field& F, Index i) -> WholePoint {
    const Mat<3> thick = whole_gradient<d>(F, i), H = gradient_of<3>(state.H, i);
    const auto sigma = law.conjugates<double>(thick, H, state.J[0][i]);
    return {thick, sigma.F + tensor_cross<double>(sigma.H, thick) + sigma.J * H};
  };
  return made;
}

/// Stages map back from the history of the step's start; it is committed once, with the F of the step's end.
template <int d, class M>
BlockLaw<d> history_law(const M& law) {
  using History = typename M::History;
  BlockLaw<d> made;
  made.history = history_values<History>();
  for (const HistoryValue& value : made.history) made.history_components += value.components();
  const int work = made.history_components++;
  made.plastic_work = work;
  made.history.push_back({"plastic work", "J/m^3", work, false});
  made.stress = [law](const MixedState<d>& state, const Field& F, Index begin, Index end, Field& P) {
    for (Index i = begin; i < end; ++i) {
      History history;
      load_history(history, state.history, i);
      const Mat<3> stress = law.stress(whole_gradient<d>(F, i), history).P;
      for (int a = 0; a < d; ++a)
        for (int b = 0; b < d; ++b) P[a * d + b][i] = stress(a, b);
    }
  };
  const auto sum_of = [](const auto& density) {
    return
        [density](const MixedState<d>& state, const Field& F, const double* volume, Index begin, Index end) {
          double sum = 0;
          for (Index i = begin; i < end; ++i) {
            if (volume[i] == 0) continue;
            History history;
            load_history(history, state.history, i);
            sum += volume[i] * density(whole_gradient<d>(F, i), history);
          }
          return sum;
        };
  };
  made.energy = sum_of([law](const Mat<3>& F, const History& history) { return law.energy(F, history); });
  made.potential =
      sum_of([law](const Mat<3>& F, const History& history) { return law.potential(F, history); });
  made.tangent = [law](const MixedState<d>& state, const Mat<d>& F, Index i) {
    History history;
    load_history(history, state.history, i);
    return part_in<d>(law.tangent(in_3d<d, double>(F, 1), history));
  };
  made.whole = [law](const MixedState<d>& state, const Field& F, Index i) -> WholePoint {
    History history;
    load_history(history, state.history, i);
    const Mat<3> thick = whole_gradient<d>(F, i);
    return {thick, law.stress(thick, history).P};
  };
  made.commit = [law, work](MixedState<d>& state, const Field& F, Index begin, Index end) {
    for (Index i = begin; i < end; ++i) {
      History history;
      load_history(history, state.history, i);
      state.history[work][i] += law.stress(whole_gradient<d>(F, i), history).plastic_work;
      store_history(history, state.history, i);
    }
  };
  return made;
}

/// Calls use(Type<M>) with the law of that name if it has a history.
template <class Use>
bool with_history_law(std::string_view name, Use&& use) {
  bool found = false;
  with_named(MaterialCatalogue{}, name, [&]<class M>(Type<M> type) {
    if constexpr (HistoryLaw<M>) {
      use(type);
      found = true;
    }
  });
  return found;
}

}  // namespace

template <int d>
BlockLaw<d> block_law(const LawChoice& law, const Elastic& elastic, bool evolves_HJ) {
  if (evolves_HJ) {
    // neo-Hookean is the polyconvex law whose share is 0
    LawChoice choice = law;
    if (law.name == "neo-hookean") choice.name = "polyconvex";
    if (choice.name != Polyconvex::name || (d == 2 && law.plane == Plane::stress))
      throw InputError(
          law.name + " is not a law of F, H and J", "H and J are unknowns of their own",
          "name polyconvex or neo-hookean under plane strain, or set [mixed] kinematics = \"tied\"");
    require_law(choice, elastic);
    return evolved_law<d>(make_law<Polyconvex>(elastic, choice));
  }
  BlockLaw<d> made;
  if (with_history_law(law.name, [&]<class M>(Type<M>) {
        if (d == 2 && law.plane == Plane::stress)
          throw InputError(law.name + " under plane stress", "laws with history are for plane strain in 2D",
                           "leave out [material] plane");
        made = history_law<d>(make_law<M>(elastic, law));
      }))
    return made;
  with_elastic_law<d>(law, elastic, [&](const auto& elastic_law) { made = tied_law<d>(elastic_law); });
  return made;
}

template <int d>
void start_history(const LawChoice& law, MixedState<d>& state, Index slots) {
  with_history_law(law.name, [&]<class M>(Type<M>) {
    typename M::History fresh;
    for (Index i = 0; i < slots; ++i) store_history(fresh, state.history, i);
  });
}

template BlockLaw<1> block_law<1>(const LawChoice&, const Elastic&, bool);
template BlockLaw<2> block_law<2>(const LawChoice&, const Elastic&, bool);
template BlockLaw<3> block_law<3>(const LawChoice&, const Elastic&, bool);
template void start_history<1>(const LawChoice&, MixedState<1>&, Index);
template void start_history<2>(const LawChoice&, MixedState<2>&, Index);
template void start_history<3>(const LawChoice&, MixedState<3>&, Index);

}  // namespace plumb
