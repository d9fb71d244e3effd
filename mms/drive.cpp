#include "mms/drive.hpp"

#include <algorithm>
#include <cmath>

#include "mms/mirrored.hpp"
#include "plumbline/boundary/supports.hpp"

namespace plumb::mms {
namespace {

/// One component of one particle that follows the solution at `at`.
template <int d>
struct Driven {
  Index slot;
  int component;
  Vec<d> at;   ///< point of the face [m]
  bool still;  ///< the solution does not move there: no evaluation is needed
};

/// One particle under the traction of one face.
template <int d>
struct Loaded {
  Index slot;
  Vec<d> at, normal;
  double per_volume;  ///< A/V [1/m]
};

/// Everything one block needs, sorted by slot.
template <int d>
struct Drive {
  Manufactured<d> solution;
  std::vector<Index> particle_of;  ///< per slot; -1 for empty slots. Empty if there is no body force
  std::vector<Driven<d>> driven;
  std::vector<Loaded<d>> loaded;

  template <class Entry>
  static auto first_in(const std::vector<Entry>& entries, Index slot) {
    return std::lower_bound(entries.begin(), entries.end(), slot,
                            [](const Entry& entry, Index value) { return entry.slot < value; });
  }

  void apply(const Solid<d>& solid, const Block& block, double time, BlockForce<d>& force) const {
    if (!particle_of.empty())
      for (Index slot = block.begin(); slot < block.end(); ++slot) {
        const Index i = particle_of[static_cast<std::size_t>(slot)];
        if (i < 0) continue;
        const Vec<d> s = solution.body_force(solid.cloud.X[static_cast<std::size_t>(i)], time);
        for (int k = 0; k < d; ++k) force(k, slot) += s[k];
      }
    for (auto at = first_in(loaded, block.begin()); at != loaded.end() && at->slot < block.end(); ++at) {
      const Vec<d> t = solution.traction(at->at, time, at->normal);
      for (int k = 0; k < d; ++k) force(k, at->slot) += at->per_volume * t[k];
    }
    for (auto at = first_in(driven, block.begin()); at != driven.end() && at->slot < block.end(); ++at)
      force(at->component, at->slot) =
          at->still ? 0 : solution.density * solution.motion(at->at, time).acceleration[at->component];
  }

  /// Exact values of prescribed components; those that never move need it at the start only.
  void impose(State<d>& state, bool still_ones) const {
    for (const Driven<d>& entry : driven) {
      if (entry.still && !still_ones) continue;
      const Motion<d> motion = solution.motion(entry.at, state.time);
      state.u[entry.component][entry.slot] = motion.displacement[entry.component];
      state.v[entry.component][entry.slot] = motion.velocity[entry.component];
    }
  }
};

/// True if this component is zero (to rounding) at seven times that share no period.
template <int d>
bool is_still(const Manufactured<d>& solution, const Vec<d>& at, int component) {
  for (int k = 1; k <= 7; ++k)
    if (std::abs(solution.displacement(at, 0.137 * k * solution.period)[component]) >
        1e-13 * solution.domain.length())
      return false;
  return true;
}

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
void add_face(const Solid<d>& solid, int face, const DriveOptions& options, Drive<d>& drive) {
  const int axis = face / 2;
  const bool upper = face % 2;
  const Cloud<d>& cloud = solid.cloud;
  const FaceCondition condition = drive.solution.domain.faces[static_cast<std::size_t>(face)];
  if (options.layout == Layout::mirror && is_roller(condition)) return;  // images hold it
  Vec<d> normal = Vec<d>::Zero();
  normal[axis] = upper ? 1 : -1;
  for (const Index i : particles_on_face(cloud, axis, upper, options.layout)) {
    const Index slot = solid.bonds.slots.of(i);
    Vec<d> at = cloud.X[i];
    at[axis] = cloud.box.origin[axis] + (upper ? cloud.box.size[axis] : 0);
    bool any_traction = false;
    for (int k = 0; k < d; ++k) {
      const Known known = k == axis ? condition.normal : condition.tangential;
      if (known == Known::displacement)
        drive.driven.push_back({slot, k, at, is_still(drive.solution, at, k)});
      else
        any_traction = true;
    }
    if (any_traction && options.body_force)  // the printed linear field has zero tractions where it has any
      drive.loaded.push_back({slot, at, normal, face_share(cloud, i, axis, options.layout) / cloud.V[i]});
  }
}

/// All components of the outermost layer and of every particle within the band.
template <int d>
void add_band(const Solid<d>& solid, double width, Drive<d>& drive) {
  const Cloud<d>& cloud = solid.cloud;
  const double outermost = 0.5 * cloud.spacing * (1 + 1e-6);  // cells: half a spacing; nodes: 0
  const double depth = std::max(outermost, width * (1 + 1e-9));
  for (Index i = 0; i < cloud.size(); ++i)
    if (drive.solution.domain.depth(cloud.X[i]) <= depth)
      for (int k = 0; k < d; ++k)
        drive.driven.push_back(
            {solid.bonds.slots.of(i), k, cloud.X[i], is_still(drive.solution, cloud.X[i], k)});
}

/// Drops the tractions that vanish at seven times (roller faces without shear, free circles): no work for
/// them.
template <int d>
void drop_zero_tractions(Drive<d>& drive, double modulus) {
  std::erase_if(drive.loaded, [&](const Loaded<d>& entry) {
    for (int k = 1; k <= 7; ++k) {
      Vec<d> t = drive.solution.traction(entry.at, 0.137 * k * drive.solution.period, entry.normal);
      for (auto at = drive.first_in(drive.driven, entry.slot);
           at != drive.driven.end() && at->slot == entry.slot; ++at)
        t[at->component] = 0;
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

template <int d>
std::shared_ptr<Drive<d>> make_drive(const Solid<d>& solid, const Manufactured<d>& solution,
                                     const DriveOptions& options) {
  auto made = std::make_shared<Drive<d>>();
  made->solution = solution;
  if (options.held_band)
    add_band(solid, *options.held_band, *made);
  else if (solution.domain.shape == Domain<d>::Shape::box)
    for (int face = 0; face < 2 * d; ++face) add_face(solid, face, options, *made);
  const auto by_slot = [](const auto& a, const auto& b) { return a.slot < b.slot; };
  std::stable_sort(made->driven.begin(), made->driven.end(), by_slot);
  std::stable_sort(made->loaded.begin(), made->loaded.end(), by_slot);
  drop_zero_tractions(*made, solution.density * solid.elastic.wave_speed() * solid.elastic.wave_speed());
  if (options.body_force) {
    made->particle_of.assign(static_cast<std::size_t>(solid.bonds.slots.count()), -1);
    for (Index i = 0; i < solid.cloud.size(); ++i)
      made->particle_of[static_cast<std::size_t>(solid.bonds.slots.of(i))] = i;
  }
  return made;
}

}  // namespace

template <int d>
Stepper<d> drive(Solid<d>& solid, State<d>& state, Stepper<d> stepper, const Manufactured<d>& solution,
                 const DriveOptions& options) {
  const auto made = make_drive(solid, solution, options);
  set_exact_state(solid, solution, state);
  made->impose(state, true);
  Term<d> term;
  term.name = "manufactured loads";
  term.bytes = made->particle_of.size() * sizeof(Index) + made->driven.size() * sizeof(Driven<d>) +
               made->loaded.size() * sizeof(Loaded<d>);
  term.second = [made](const Solid<d>& body, const Block& block, const State<d>&, double time,
                       BlockForce<d>& force) { made->apply(body, block, time, force); };
  add_term(solid, std::move(term));
  const auto inner = stepper.step;
  stepper.step = [made, inner](Solid<d>& body, State<d>& current, double dt) {
    if (!inner(body, current, dt)) return false;
    made->impose(current, false);
    return true;
  };
  return stepper;
}

template Stepper<2> drive<2>(Solid<2>&, State<2>&, Stepper<2>, const Manufactured<2>&, const DriveOptions&);
template Stepper<3> drive<3>(Solid<3>&, State<3>&, Stepper<3>, const Manufactured<3>&, const DriveOptions&);

}  // namespace plumb::mms
