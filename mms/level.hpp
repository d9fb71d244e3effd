#pragma once
#include <vector>

#include "lib/output/sitting.hpp"
#include "lib/scene/study.hpp"
#include "lib/scene/tlsph.hpp"
#include "mms/manufactured.hpp"
#include "mms/norms.hpp"
#include "mms/study_level.hpp"

namespace plumb::mms {

/// What a run leaves: its numbers, and the field at its end.
template <int d>
struct LevelRun {
  StudyLevel level;
  Cloud<d> cloud;
  NodalValues<d> values;
  std::vector<Wall> walls;  ///< with images behind them
};

/// A body that follows a manufactured solution, ready to run by `integrator`, which drives it; that of the simulation does not.
/// A value: it may be moved.
template <int d>
struct DrivenBody {
  TlsphBody<d> simulation;
  ChosenIntegrator<d> integrator;
};

/// Returns what a total Lagrangian body of the study knows at its particles, the stress by the law of the solution; the
/// body's own stress is the same, or std::logic_error (require_same_law).
template <int d>
NodalValues<d> values_of_body(const Study& study, const Solid<d>& solid, const State<d>& state,
                              const Manufactured<d>& solution);

/// Which norms a study asks for.
bool wants_gauss(const Study& study);
bool wants_nodal(const Study& study);

/// End time of the study [s].
double end_time(const Study& study);

/// The study's solution. Throws InputError if it does not fit the study (dimension, parameters, box).
template <int d>
Manufactured<d> solution_of(const Study& study);

/// Throws InputError for a solution at rest: nothing of it depends on time.
template <int d>
void require_motion(const Manufactured<d>& solution) {
  if (solution.still)
    throw InputError(solution.name + " does not move", "it is an equilibrium", "Use plumb static.");
}

/// The exact displacement, gradient, velocity and stress at one time [s].
template <int d>
ExactField<d> exact_field(const Manufactured<d>& solution, double time);

/// The surface of the study's body around its particles.
template <int d>
Surface<d> surface_of(const Study& study, const Manufactured<d>& solution, const Cloud<d>& cloud);

/// The study's body with this spacing [m], at rest and without loads. Boxes are built as in any scene; annuli
/// as rings (layout node), as a clipped lattice (layout cell), or, if jittered or blue noise, as any shape is
/// filled.
template <int d>
TlsphBody<d> driven_simulation(const Study& study, const Manufactured<d>& solution, double spacing);

/// The scene of one level as the solution needs it: at rest, without loads and boundaries.
Scene scene_of_level(const Study& study, double spacing);

/// Says which loads drive a body.
struct Loading {
  bool body_force;  ///< the loads of finite strain; without them the body is that of the printed field
  bool at_step_start = false;  ///< loads see the time at which their step began: (30) as printed
};

/// Makes the study's body with this spacing [m] follow the solution.
template <int d>
DrivenBody<d> driven_body(const Study& study, const Manufactured<d>& solution, double spacing,
                          const Loading& loading);

/// What drives a body of the study, by its key `force`.
Loading loading_of(const Study& study);

/// Runs it to the end time, unless the sitting ends; norms are left to measure().
template <int d>
LevelRun<d> run_level(const Study& study, const Manufactured<d>& solution, double spacing,
                      const Loading& loading, Sitting& sitting);

/// The norms of a field against the exact one (NaN for a broken run), and of the exact one itself.
template <int d>
void measure(const Study& study, const ExactField<d>& exact, LevelRun<d>& run);

}  // namespace plumb::mms
