#pragma once
#include <memory>
#include <string>
#include <vector>

#include "lib/actions/actions.hpp"
#include "lib/run/simulation.hpp"
#include "lib/scene/make_cloud.hpp"
#include "lib/scene/scene.hpp"
#include "lib/schemes/tlsph/boundary/supports.hpp"
#include "lib/schemes/tlsph/compatible/compatible.hpp"
#include "lib/schemes/tlsph/parts/jst.hpp"
#include "lib/schemes/tlsph/run/solid_run.hpp"

namespace plumb {

/// A total Lagrangian body made ready to run. What the scene does not name is not in it.
template <int d>
struct TlsphBody {
  Solid<d> solid;
  State<d> state;
  ChosenIntegrator<d> integrator;
  StepControl control;
  Actions<d> actions;                                  ///< what acts from outside
  std::vector<Support<d>> supports;                    ///< the components that `actions` holds
  std::vector<std::string> warnings;                   ///< for people: settings that work but may surprise
  std::shared_ptr<const CompatibleReport> compatible;  ///< what the projection did; null without one
};

/// Set-up choices of [method] and [jst] for a cloud.
template <int d>
BondOptions<d> bond_options(const Scene& scene, double spacing);

/// Builds the whole scene. Throws InputError.
template <int d>
TlsphBody<d> make_tlsph(const Scene& scene);

/// Makes the body out of particles that [body] cannot describe. gradient = "compatible" needs their surface; if it is
/// not given it is estimated from the particles (shape_around), with a warning.
template <int d>
TlsphBody<d> make_tlsph(const Scene& scene, Cloud<d> cloud, std::optional<Surface<d>> surface = std::nullopt);

/// Lists the arrays that the body holds, with their bytes.
template <int d>
std::vector<ArrayEntry> arrays_of(const TlsphBody<d>& simulation);

}  // namespace plumb
