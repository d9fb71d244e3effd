#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "plumbline/geometry/shape.hpp"
#include "plumbline/material/law.hpp"
#include "plumbline/scene/expression.hpp"

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
  double jitter = 0.0;     ///< random displacement of interior particles, as a fraction of d, in [0, 0.5)
  std::uint64_t seed = 1;  ///< of the jitter: the same seed gives the same cloud
};

/// The body with spacing d [m] and the number of particles along each edge filled in.
/// Throws InputError when d does not divide the size; it then names the nearest spacings that do.
Body with_spacing(Body body, double d);

/// [material]: one law for the whole body. (`MaterialModel` is the concept that models meet.)
struct MaterialChoice {
  std::string model = "neo-hookean";
  double young = 0.0;    ///< E [Pa] > 0, required
  double poisson = 0.0;  ///< -1 < nu < 0.5, required
  double density = 0.0;  ///< rho of the reference [kg/m^3] > 0, required
  std::map<std::string, double> parameters = {};  ///< the law's own that are given, in SI units
  Plane plane = Plane::strain;                    ///< of bodies in 2D

  Elastic elastic() const { return {young, poisson, density}; }
  LawChoice law() const { return {model, parameters, plane}; }
};

/// [compatible]: how the table of gradient = "compatible" is made (THEORY chapter 11).
struct Compatible {
  std::string start = "improved";   ///< standard | improved: the table that is projected
  std::string volumes = "unknown";  ///< unknown | fixed: volumes found with the area vectors, or Voronoi's
  std::string surface = "shape";    ///< shape | estimated: the body's own, or one guessed from the particles
  std::string cache;                ///< folder of tables that were projected before; empty: none is kept
};

/// [method]: the scheme. The defaults are the ones method.md proposes for users: the adjoint force needs no
/// dissipation to be stable, so velocity Verlet with one evaluation a step serves. Paper mode is symmetrised,
/// rk3 and a [jst] section.
struct Method {
  std::string kernel = "cubic";
  double beta = 0.9;        ///< h/d: the least neighbours with no near-zero modes (method.md, section 1)
  std::string pair = "W1";  ///< W1 | W0: W1 meets (5a), (5b), (9a), (9b) at every particle
  std::string gradient = "improved";  ///< standard | improved | bond38 | compatible
  Compatible compatible;              ///< of gradient = "compatible" only
  std::string momentum =
      "adjoint";  ///< symmetrised (22) | adjoint: energy and angular momentum exact | variational
  std::string integrator = "verlet";  ///< rk3 | verlet
  std::optional<double> cfl =
      0.5;  ///< alpha_CFL (31); nullopt if time_step is set. 0.5: every measured variant is stable
  std::optional<double> time_step;  ///< fixed [s]; nullopt if cfl is set
  std::string wave_speed =
      "linear";  ///< linear | stretch | stretch-inverse (32): linear costs nothing and is constant
};

/// [jst]: Jameson-Schmidt-Turkel dissipation (28).
struct Jst {
  double eta2 = 0.0;         ///< second-order coefficient; 0: that term is not built
  double eta4 = 1.0 / 64.0;  ///< fourth-order coefficient, the paper's for the columns
  double laplacian_factor =
      2.0;  ///< of phi = -factor W'/r; the papers' own Laplacian is probably half of it: 1
  std::string outer = "symmetric";  ///< symmetric (28) | transpose: L^T V L, dissipative by construction
};

/// [hourglass]: the energy form (method.md, section 3).
struct Hourglass {
  double alpha = 0.5;  ///< coefficient; 0.5 to 1 kept the twisted column free of hourglass modes
};

/// [initial]: exactly one of the two is given.
struct Initial {
  std::vector<Expression> velocity;  ///< [m/s] in X, Y, Z; as many as the dimension, or empty
  std::optional<std::array<double, 3>>
      spin;  ///< angular velocity [rad/s] about the centre of mass; 2D: (0, 0, w)
};

/// One face of the box: axis 0, 1, 2 and side -1 or +1 ("z-" is {2, -1}).
struct Face {
  int axis = 0;
  int side = -1;
  friend bool operator==(const Face&, const Face&) = default;
};

enum class BoundaryKind {
  clamped,   ///< velocity zero
  roller,    ///< normal velocity zero; faces only
  velocity,  ///< velocity prescribed
};

/// [[boundary]]: exactly one of face and where is given.
struct Boundary {
  std::optional<Face> face;
  std::optional<Expression> where;  ///< condition on X, Y, Z
  BoundaryKind kind = BoundaryKind::clamped;
  std::vector<Expression> velocity;  ///< [m/s], kind velocity only: as many as the dimension
};

/// [[output.probe]]: follows the particle nearest to a reference point.
struct Probe {
  std::string name;
  std::vector<double> at;  ///< [m], as many as the dimension
};

/// [output]: nothing is written that is not asked for.
struct Output {
  std::optional<double> every;  ///< [s]; nullopt: the first and the last state only
  std::optional<double>
      checkpoint;       ///< [s] between files to resume from; they are also kept at every early end
  bool vtk = false;     ///< particles as .vtp with a .pvd
  bool series = false;  ///< energies, momenta and probes against time as CSV
  bool budget = false;  ///< momenta and energy by the cause that changed them, every step, as CSV
  std::vector<Probe> probes;
};

/// A scene: everything a run needs. At least one of end_time and max_steps is given.
struct Scene {
  std::string name;
  int dimension = 0;               ///< 2 (plane strain) or 3
  std::optional<double> end_time;  ///< [s]
  std::optional<long> max_steps;
  Body body;
  MaterialChoice material;
  Method method;
  std::optional<Jst> jst;
  std::optional<Hourglass> hourglass;
  bool projection = false;  ///< [projection], which has no keys: forces without torque (paper 003, (64)-(67))
  std::optional<Initial> initial;  ///< absent: at rest
  std::vector<Boundary> boundaries;
  std::optional<Output> output;  ///< absent: the summary only
};

}  // namespace plumb
