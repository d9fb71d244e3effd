#pragma once
#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "reports/picture.hpp"

/// Deformed bodies as pictures: the particles that a run wrote, and their surface seen from one side.
namespace plumb::reports {

using Point = std::array<double, 3>;

/// The particles of a run at one time, and one quantity on them.
struct BodyState {
  double time = 0;                         ///< [s]
  std::vector<Point> reference, position;  ///< X and x [m]
  std::vector<double> value;
};

/// The states that `plumb run` with output.vtk = true wrote into `folder` (particles.pvd and its files), with
/// the field of that name ("von Mises stress [Pa]").
/// @throws MissingResult if a file or a field is not there or cannot be read.
std::vector<BodyState> read_states(const std::filesystem::path& folder, const std::string& field);

/// The state in the table that `plumb run --csv` writes; a plane one gets z = 0.
/// @throws MissingResult if a column is not there.
BodyState last_state(const std::map<std::string, std::vector<double>>& table, double time,
                     const std::string& field);

/// How a body is drawn: the axis to the right, the axis upwards, the axis along which one looks ('x', 'y',
/// 'z'; its sign follows), and from where: turned by `azimuth`, seen from `elevation` above [degrees]. A
/// plane body is drawn as it is.
struct View {
  char right = 'z', up = 'y', near = 'x';
  double azimuth = 28, elevation = 22;
};

/// What the quantity is called, how it is scaled and where its colours end.
struct ColourScale {
  std::string label, unit;
  double scale = 1;  ///< shown value = scale * value
  double low = 0, high = 1;
};

/// The surface through the outer particles of a lattice; single particles as squares where the reference is
/// no lattice. `edge` is the spacing [m]. All pictures of one `extent` have the same scale.
/// @throws InputError if there is no particle.
Picture body_picture(const std::string& title, const BodyState& state, const View& view,
                     const ColourScale& quantity, double edge, const std::vector<BodyState>& extent);

}  // namespace plumb::reports
