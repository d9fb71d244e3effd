#pragma once
#include <optional>
#include <vector>

#include "lib/actions/actions.hpp"
#include "lib/schemes/tlsph/loops/solid.hpp"

namespace plumb {

/// Finds the forces on a body without what its supports add, and from them the forces of the supports,
/// THEORY (5.9). It costs an evaluation, so it is for records, not for steps.
template <int d>
class OpenForces {
 public:
  /// Remembers the terms that the body has now, but its supports.
  OpenForces(const Solid<d>& solid, const Actions<d>& actions);

  /// Returns the force per reference volume of every slot in this state [N/m^d]; nullopt if some J is not
  /// positive. The work of the steps does not count it.
  std::optional<Field> at(const Solid<d>& solid, Workspace<d>& workspace, State<d>& state) const;
  /// Returns the part of it that the loads have. `workspace`: as at() left it, for pressures that follow.
  Field of_loads(const Solid<d>& solid, const Workspace<d>& workspace, const State<d>& state) const;
  /// Returns the force of the supports of each boundary on the body [N] (per metre of thickness in 2D), in
  /// the order of Actions::held. A component that two boundaries hold belongs to the later one. `open`: as
  /// at() found it.
  std::vector<Vec<d>> reactions(const Solid<d>& solid, const State<d>& state, const Field& open) const;

  /// Calls use(component, slot) for every held component.
  template <class Use>
  void for_each_held(Use&& use) const {
    for (const auto& entry : held_) use(entry.component, entry.slot);
  }

 private:
  struct Entry {
    Index slot;
    int component;
    std::size_t boundary;  ///< in Actions::held
    Vec<d> at;
  };
  std::vector<Term<d>> terms_;
  Actions<d> actions_;  ///< without its places
  std::vector<Entry> held_;
};

}  // namespace plumb
