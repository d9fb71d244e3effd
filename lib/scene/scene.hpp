#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lib/actions/contact_options.hpp"
#include "lib/actions/load_options.hpp"
#include "lib/actions/relaxation_options.hpp"
#include "lib/geometry/shape.hpp"
#include "lib/input/expression.hpp"
#include "lib/material/law.hpp"
#include "lib/run/output_options.hpp"
#include "lib/schemes/default_cfl.hpp"
#include "lib/schemes/element/element_options.hpp"
#include "lib/schemes/eulerian/eulerian_options.hpp"
#include "lib/schemes/implicit/implicit_options.hpp"
#include "lib/schemes/mixed/mixed_options.hpp"
#include "lib/schemes/tlsph/parts/damping.hpp"
#include "lib/schemes/tlsph/parts/dissipation_options.hpp"
#include "lib/schemes/tlsph/parts/hourglass_options.hpp"
#include "lib/schemes/tlsph/parts/jst_options.hpp"
#include "lib/schemes/tlsph/parts/projection_options.hpp"
#include "lib/schemes/updated/updated_options.hpp"

/// The scene file as plain values, in SI units. A section that is left out is a thing that is not built:
/// nullopt or an empty list. Names (kernel, pair, ..) have been checked against the catalogues by the reader
/// (read_scene.hpp).
namespace plumb {

/// A shape of the catalogue (geometry/shapes) with its lengths [m].
struct ShapeChoice {
  std::string name;
  ShapeLengths lengths;
};

/// [body]: particles that fill a shape.
struct Body {
  std::string name = "body";       ///< what [[contact]] calls it
  std::string shape = "box";       ///< a name of the catalogue
  ShapeLengths lengths;            ///< [m] of a shape other than a box
  std::vector<ShapeChoice> holes;  ///< [[body.hole]]: what is taken off the shape
  std::string cloud = "lattice";   ///< lattice | blue-noise: random points that keep a distance
  std::vector<double>
      origin;  ///< [m] lowest corner; default: zeros. Shapes other than boxes: of the box around
  std::vector<double> size;  ///< [m] edge lengths; as many as the dimension. Likewise
  std::optional<double>
      spacing;  ///< d [m], equal in all directions. A scene that was read always has it; a study has none
  std::vector<long> particles;  ///< particles along each edge (node: cells + 1), at most if the shape is not
                                ///< a box. A scene that was read always has them
  Layout layout =
      Layout::node;  ///< node: boundary conditions act where they are stated; cell is first order only there
  double jitter = 0.0;  ///< random displacement of interior particles, as a fraction of d, in [0, 0.5)
  std::optional<Expression> finer;  ///< condition on X, Y, Z: cells have half the spacing where it holds
  std::uint64_t seed = 1;           ///< of the jitter: the same seed gives the same cloud
  std::string file;                 ///< particles come from there; empty: they fill the shape
  std::vector<double> points;       ///< [m] of the file, as many numbers each as the dimension
  std::vector<double> volumes;      ///< [m^d] of the file; empty: those of Voronoi cells within the shape
};

/// The body with spacing d [m] and the number of particles along each edge filled in.
/// Throws InputError when d does not divide the size; it then names the nearest spacings that do.
Body with_spacing(Body body, double d);

/// [material]: one law for the whole body. (`MaterialModel` is the concept that models meet.)
struct MaterialChoice {
  std::string model = "neo-hookean";
  double young = 0.0;                             ///< E [Pa] > 0, required
  double poisson = 0.0;                           ///< -1 < nu < 0.5, required
  double density = 0.0;                           ///< rho of the reference [kg/m^3] > 0, required
  std::map<std::string, double> parameters = {};  ///< the law's own that are given, in SI units
  Plane plane = Plane::strain;                    ///< of bodies in 2D

  Elastic elastic() const { return {young, poisson, density}; }
  LawChoice law() const { return {model, parameters, plane}; }
};

/// [compatible]: how the table of gradient = "compatible" is made (THEORY chapter 11).
struct Compatible {
  std::string table = "auto";       ///< auto | closed-form | projected: closed form wherever there is one
  std::string start = "improved";   ///< standard | improved: the table that is projected, or whose weights
                                    ///< inside of a lattice are closed at its faces
  std::string volumes = "unknown";  ///< unknown | fixed: volumes found with the area vectors, or Voronoi's
  std::string surface = "shape";    ///< shape | estimated: the body's own, or one guessed from the particles
  std::string cache;                ///< folder of tables that were projected before; empty: none is kept
};

/// [method] and the sections of its optional parts: the scheme, for scenes and studies alike. The adjoint
/// force needs no dissipation to be stable, so velocity Verlet with one evaluation a step serves. Compatible
/// bonds are exact for affine motion and uniform stress, at the surface too. The reader's defaults depend on
/// the rest of the scene (default_gradient, default_beta): compatible bonds need particles on the surface and
/// the adjoint force, and beta 1.2 where a surface cuts the cloud.
struct Method {
  std::string scheme = "tlsph";  ///< a name of scheme_names()
  /// "000", "001", "002", "003", "004": keys that are not given are those of that paper; empty: of no paper.
  std::string paper;
  std::string kernel = "cubic";
  double beta = 0.9;  ///< h/d: the least neighbours with no near-zero modes
  std::string pair =
      "W1";  ///< W1 | W0 | none: W1 meets 000 (5a), (5b), (9a), (9b) at every particle; none: W with L^-1
  long nearest = 0;  ///< support = "nearest:12": each particle's reaches to that neighbour; 0: beta, of all
  bool by_spacing = false;  ///< support = "spacing": each particle's is beta times the spacing around it
  std::string gradient = "compatible";  ///< standard | improved | bond38 | compatible
  Compatible compatible;                ///< of gradient = "compatible" only
  std::string momentum =
      "adjoint";  ///< symmetrised: 000 (22) | adjoint: energy and angular momentum exact | variational
  std::string integrator = "verlet";        ///< rk3 | verlet
  std::optional<double> cfl = default_cfl;  ///< alpha_CFL of 000 (31); nullopt if time_step is set
  std::optional<double> time_step;          ///< fixed [s]; nullopt if cfl is set
  std::string wave_speed =
      "linear";  ///< linear | stretch | stretch-inverse: 000 (32): linear costs nothing and is constant
  std::optional<JstOptions> jst;                  ///< absent: no dissipation
  std::optional<DissipationOptions> dissipation;  ///< absent: pairs take no energy
  std::optional<HourglassOptions> hourglass;      ///< absent: no hourglass energy
  std::optional<ProjectionOptions> projection;    ///< absent: the force may have a torque
  std::optional<DampingOptions> damping;          ///< absent: no damping
  MixedOptions mixed;                             ///< of scheme "mixed" only
  ImplicitOptions implicit;         ///< of scheme "implicit", and of elements that Newton's method moves
  UpdatedOptions updated;           ///< of scheme "updated" only
  EulerianOptions eulerian;         ///< of scheme "eulerian" only
  ElementOptions element;           ///< of scheme "element" only
  std::vector<std::string> unused;  ///< sentences: keys that are given and that this scheme does not look at
};

/// Calls use(part) for every optional part of a method, in the order in which their terms act. Readers,
/// set-up and `plumb explain` know the parts from here only.
template <class AnyMethod, class Use>
void for_each_part(AnyMethod& method, Use&& use) {
  use(method.jst);
  use(method.dissipation);
  use(method.hourglass);
  use(method.projection);  // takes the torque off what stands before it
  use(method.damping);
}

/// [initial]: at most one of velocity and spin is given.
struct Initial {
  std::vector<Expression> displacement;  ///< [m] in X, Y, Z; as many as the dimension, or empty
  std::vector<Expression> velocity;      ///< [m/s] in X, Y, Z; as many as the dimension, or empty
  std::optional<std::array<double, 3>>
      spin;  ///< angular velocity [rad/s] about the centre of mass; 2D: (0, 0, w), 1D: none
  std::optional<Expression> temperature;  ///< [K] in X, Y, Z, for a law that has one
};

/// One face of the box: axis 0, 1, 2 and side -1 or +1 ("z-" is {2, -1}).
struct Face {
  int axis = 0;
  int side = -1;
  friend bool operator==(const Face&, const Face&) = default;
};

/// Tells what a boundary prescribes.
enum class BoundaryKind {
  clamped,       ///< velocity zero
  roller,        ///< normal velocity zero; faces only
  velocity,      ///< velocity prescribed
  displacement,  ///< displacement prescribed
  traction,      ///< loaded by a force per reference area, which keeps its direction
  pressure,      ///< loaded by a pressure, which follows the surface
};

/// Says whether a boundary of this kind loads the body; otherwise it holds it.
inline bool is_load(BoundaryKind kind) {
  return kind == BoundaryKind::traction || kind == BoundaryKind::pressure;
}

/// [[boundary]]: exactly one of face and where is given.
struct Boundary {
  std::optional<Face> face;
  std::optional<Expression> where;  ///< condition on X, Y, Z
  BoundaryKind kind = BoundaryKind::clamped;
  std::vector<Expression> velocity;  ///< [m/s] in X, Y, Z, t; kind velocity only: as many as the dimension
  std::vector<Expression> displacement;  ///< [m], likewise
  std::vector<Expression> traction;      ///< [Pa], likewise
  std::optional<Expression> pressure;    ///< [Pa], positive into the body; kind pressure only
  std::optional<double> ramp;            ///< [s]: what is prescribed grows smoothly from 0 in this time
};

/// A scene: everything a run needs. At least one of end_time and max_steps is given.
struct Scene {
  std::string name;
  int dimension = 0;               ///< 1 (uniaxial strain), 2 (plane strain) or 3
  std::optional<double> end_time;  ///< [s]
  std::optional<long> max_steps;
  Body body;
  std::vector<Body> others;  ///< of [[body]]: those after the first one
  MaterialChoice material;
  Method method;
  std::optional<LoadOptions> load;  ///< [load]; absent: no body forces
  std::optional<Initial> initial;   ///< absent: at rest
  std::vector<Boundary> boundaries;
  std::vector<ContactOptions> contacts;         ///< [[contact]]; empty: no walls
  std::optional<RelaxationOptions> relaxation;  ///< absent: the run ends at its time, at rest or not
  std::optional<Output> output;                 ///< absent: the summary only
  /// [output] exact: displacement [m] in X, Y, Z, t that the end of the run is held against; as many as the dimension, or empty.
  std::vector<Expression> exact;
};

}  // namespace plumb
