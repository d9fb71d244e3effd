#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lib/run/saved_state.hpp"
#include "lib/scene/tlsph.hpp"
#include "lib/schemes/tlsph/boundary/external_work.hpp"
#include "lib/schemes/tlsph/boundary/open_forces.hpp"
#include "lib/schemes/tlsph/boundary/relaxation.hpp"
#include "lib/schemes/tlsph/measures/budget_file.hpp"
#include "lib/schemes/tlsph/time/closest_pairs.hpp"

namespace plumb {

/// A body with what follows it through a run. It lives as long as the functions of the simulation.
template <int d>
struct Followed {
  std::shared_ptr<TlsphBody<d>> body;
  ClosestPairs<d> closest;
  std::shared_ptr<const OpenForces<d>> forces;  ///< null without supports or relaxation
  std::optional<Relaxation<d>> relaxation;
  std::optional<double> residual;  ///< of the last step, if it was looked at
  std::optional<BudgetFile<d>> budget;
  std::optional<ExternalWork<d>> work;  ///< nothing before begin()
  std::vector<KeptWork> work_before;    ///< of an earlier part of the run
  bool goes_on = false;                 ///< there was one
};

/// Components of a field on slots, particle by particle.
template <int d>
SavedField gathered(const std::string& name, const Solid<d>& solid, const Field& field, int first = 0,
                    int components = d) {
  SavedField saved{name, components,
                   std::vector<double>(static_cast<std::size_t>(solid.cloud.size() * components))};
  for (Index i = 0; i < solid.cloud.size(); ++i)
    for (int k = 0; k < components; ++k)
      saved.values[i * components + k] = field[first + k][solid.bonds.slots.of(i)];
  return saved;
}

/// All that the body and what follows it need to go on bit for bit.
template <int d>
SavedState save(const Followed<d>& followed);

/// Goes on from there. Throws InputError if it does not fit.
template <int d>
void restore(Followed<d>& followed, const SavedState& saved);

}  // namespace plumb
