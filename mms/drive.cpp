#include "mms/drive.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <utility>

#include "lib/schemes/tlsph/boundary/apply_actions.hpp"
#include "lib/schemes/tlsph/boundary/supports.hpp"
#include "mms/mirrored.hpp"

namespace plumb::mms {
namespace {

/// True if this component is zero (to rounding) at seven times that share no period.
template <int d>
bool is_still(const Manufactured<d>& solution, const Vec<d>& at, int component) {
  for (int k = 1; k <= 7; ++k)
    if (std::abs(solution.displacement(at, 0.137 * k * solution.period)[component]) >
        1e-13 * solution.domain.length())
      return false;
  return true;
}

/// Holds components on the path of the solution. Those that never move need nothing after the start.
template <int d>
class HeldParts {
 public:
  explicit HeldParts(const Manufactured<d>& solution) : solution_(solution) {
    still_.name = moving_.name = "manufactured motion";
    still_.motion = moving_.motion = [solution](const Vec<d>& at, int k, double time) -> HeldMotion {
      const Motion<d> motion = solution.motion(at, time);
      return {motion.displacement[k], motion.velocity[k], motion.acceleration[k]};
    };
    moving_.steady = false;
  }

  void add(Index particle, int component, const Vec<d>& at) {
    (is_still(solution_, at, component) ? still_ : moving_).places.push_back({particle, component, at});
    held_.insert({particle, component});
  }
  bool holds(Index particle, int component) const { return held_.contains({particle, component}); }
  void add_to(Actions<d>& actions) && {
    for (Held<d>* part : {&still_, &moving_})
      if (!part->places.empty()) actions.held.push_back(std::move(*part));
  }

 private:
  const Manufactured<d>& solution_;
  Held<d> still_, moving_;
  std::set<std::pair<Index, int>> held_;
};

/// Share of particle i in a face normal to `axis`: V over its extent along the axis.
template <int d>
double face_share(const Cloud<d>& cloud, Index i, int axis, Layout layout) {
  const std::array<Index, d> cells = cells_of<d>(cloud.box, cloud.spacing);
  double area = 1;
  for (int a = 0; a < d; ++a) {
    if (a == axis) continue;
    const double cell = cloud.box.size[a] / static_cast<double>(cells[static_cast<std::size_t>(a)]);
    const double from_end = std::min(cloud.X[i][a] - cloud.box.origin[a],
                                     cloud.box.origin[a] + cloud.box.size[a] - cloud.X[i][a]);
    area *= layout == Layout::node && from_end < 1e-6 * cell ? cell / 2 : cell;
  }
  return area;
}

template <int d>
void add_face(const Cloud<d>& cloud, const Manufactured<d>& solution, int face, const DriveOptions& options,
              HeldParts<d>& parts, SurfaceLoad<d>& load) {
  const int axis = face / 2;
  const bool upper = face % 2;
  const FaceCondition condition = solution.domain.faces[static_cast<std::size_t>(face)];
  if (options.layout == Layout::mirror && is_roller(condition)) return;  // images hold it
  Vec<d> normal = Vec<d>::Zero();
  normal[axis] = upper ? 1 : -1;
  for (const Index i : particles_on_face(cloud, axis, upper, options.layout)) {
    Vec<d> at = cloud.X[i];
    at[axis] = cloud.box.origin[axis] + (upper ? cloud.box.size[axis] : 0);
    bool any_traction = false;
    for (int k = 0; k < d; ++k) {
      const Known known = k == axis ? condition.normal : condition.tangential;
      if (known == Known::displacement)
        parts.add(i, k, at);
      else
        any_traction = true;
    }
    if (any_traction && options.body_force)  // the printed linear field has zero tractions where it has any
      load.places.push_back({i, at, face_share(cloud, i, axis, options.layout) * normal});
  }
}

/// All components of the outermost layer and of every particle within the band.
template <int d>
void add_band(const Cloud<d>& cloud, const Manufactured<d>& solution, double width, HeldParts<d>& parts) {
  const double outermost = 0.5 * cloud.spacing * (1 + 1e-6);  // cells: half a spacing; nodes: 0
  const double depth = std::max(outermost, width * (1 + 1e-9));
  for (Index i = 0; i < cloud.size(); ++i)
    if (solution.domain.depth(cloud.X[i]) <= depth)
      for (int k = 0; k < d; ++k) parts.add(i, k, cloud.X[i]);
}

/// Drops the tractions that vanish at seven times (roller faces without shear, free circles): no work for
/// them.
template <int d>
void drop_zero_tractions(const Manufactured<d>& solution, const HeldParts<d>& parts, double modulus,
                         SurfaceLoad<d>& load) {
  std::erase_if(load.places, [&](const LoadedPlace<d>& place) {
    for (int k = 1; k <= 7; ++k) {
      Vec<d> t = solution.traction(place.at, 0.137 * k * solution.period, place.area.normalized());
      for (int component = 0; component < d; ++component)
        if (parts.holds(place.particle, component)) t[component] = 0;
      if (t.norm() > 1e-12 * modulus) return false;
    }
    return true;
  });
}

template <int d>
void set_exact_state(const Solid<d>& solid, const Manufactured<d>& solution, State<d>& state) {
  for (Index i = 0; i < solid.cloud.size(); ++i) {
    const Motion<d> motion = solution.motion(solid.cloud.X[i], state.time);
    set_vector<d>(state.u, solid.bonds.slots.of(i), motion.displacement);
    set_vector<d>(state.v, solid.bonds.slots.of(i), motion.velocity);
  }
}

}  // namespace

template <int d>
Actions<d> actions_of(const Cloud<d>& cloud, double modulus, const Manufactured<d>& solution,
                      const DriveOptions& options, const CurvedSurface<d>& curved) {
  HeldParts<d> parts(solution);
  SurfaceLoad<d> load;
  load.name = "manufactured traction";
  load.traction = [solution](const Vec<d>& at, const Vec<d>& normal, double time) -> Vec<d> {
    return solution.traction(at, time, normal);
  };
  if (options.held_band)
    add_band(cloud, solution, *options.held_band, parts);
  else if (options.faces && solution.domain.shape == Domain<d>::Shape::box)
    for (int face = 0; face < 2 * d; ++face) add_face(cloud, solution, face, options, parts, load);
  for (const Index i : curved.displaced)
    for (int k = 0; k < d; ++k)
      if (!parts.holds(i, k)) parts.add(i, k, cloud.X[i]);
  load.places.insert(load.places.end(), curved.pulled.begin(), curved.pulled.end());
  drop_zero_tractions(solution, parts, modulus, load);
  Actions<d> actions;
  if (options.body_force)
    actions.body_forces.push_back(
        {"manufactured load",
         [solution](const Vec<d>& X, double time) -> Vec<d> { return solution.body_force(X, time); }, false});
  if (!load.places.empty()) actions.surface.push_back(std::move(load));
  std::move(parts).add_to(actions);
  return actions;
}

namespace {

/// The actions as they are seen by somebody whose clock stands still between the starts of steps.
template <int d>
Actions<d> seen_at(const std::shared_ptr<const double>& start, Actions<d> actions) {
  for (auto& boundary : actions.held)
    boundary.motion = [start, inner = boundary.motion](const Vec<d>& at, int k, double) {
      return inner(at, k, *start);
    };
  for (auto& load : actions.surface)
    load.traction = [start, inner = load.traction](const Vec<d>& at, const Vec<d>& normal, double) -> Vec<d> {
      return inner(at, normal, *start);
    };
  for (auto& force : actions.body_forces)
    force.per_volume = [start, inner = force.per_volume](const Vec<d>& X, double) -> Vec<d> {
      return inner(X, *start);
    };
  return actions;
}

}  // namespace

template <int d>
ChosenIntegrator<d> drive(Solid<d>& solid, State<d>& state, ChosenIntegrator<d> integrator,
                          const Manufactured<d>& solution, const DriveOptions& options,
                          const CurvedSurface<d>& curved) {
  const double modulus = solution.density * std::pow(solid.elastic.wave_speed(), 2);
  const Actions<d> actions = actions_of(solid.cloud, modulus, solution, options, curved);
  set_exact_state(solid, solution, state);
  impose(solid, actions, state);
  if (!options.loads_at_step_start) {
    apply_actions(solid, actions);
    return with_prescribed_motion(std::move(integrator), actions);
  }
  const auto start = std::make_shared<double>(state.time);
  apply_actions(solid, seen_at<d>(start, actions));
  integrator = with_prescribed_motion(std::move(integrator), actions);
  integrator.step = [start, inner = integrator.step](const Solid<d>& body, State<d>& current, double dt) {
    *start = current.time;
    return inner(body, current, dt);
  };
  return integrator;
}

#define PLUMBLINE_INSTANTIATE(d)                                                                           \
  template Actions<d> actions_of<d>(const Cloud<d>&, double, const Manufactured<d>&, const DriveOptions&,  \
                                    const CurvedSurface<d>&);                                              \
  template ChosenIntegrator<d> drive<d>(Solid<d>&, State<d>&, ChosenIntegrator<d>, const Manufactured<d>&, \
                                        const DriveOptions&, const CurvedSurface<d>&);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb::mms
