// [body] file = "..": particles that another program placed.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "lib/geometry/clipped_cells.hpp"
#include "lib/geometry/cloud_checks.hpp"
#include "lib/geometry/neighbours.hpp"
#include "lib/geometry/position_text.hpp"
#include "lib/input/point_file.hpp"
#include "lib/scene/cloud_file.hpp"
#include "lib/scene/readers.hpp"
#include "lib/scene/tlsph.hpp"

namespace plumb {
namespace {

namespace fs = std::filesystem;

void refuse_keys_of_lattices(const Section& section) {
  for (const char* key : {"layout", "cloud", "jitter", "seed", "particles"})
    if (section.has(key))
      section.fail(key, "contradicts file", "the file says where the particles are", "leave one of them out");
}

/// Positions in metres, `dimension` numbers each.
std::vector<double> positions_of(const Section& section, const PointFile& file, double metre, int dimension) {
  std::vector<double> points;
  for (std::size_t k = 0; k < file.count; ++k) {
    if (dimension == 2 && file.positions[3 * k + 2] != 0)
      section.fail("file", fmt::format("point {} has z = {}", k + 1, file.positions[3 * k + 2]),
                   "the scene is in 2D", "give dimension = 3, or points with z = 0");
    for (int a = 0; a < dimension; ++a)
      points.push_back(metre * file.positions[3 * k + static_cast<std::size_t>(a)]);
  }
  return points;
}

/// Volumes in m^d, if the file has them.
std::vector<double> volumes_of(const Section& section, const PointFile& file, double metre, int dimension) {
  const PointColumn* column = file.find({"volume", "volumes"});
  if (column == nullptr) return {};
  std::vector<double> volumes;
  for (std::size_t k = 0; k < file.count; ++k) {
    if (column->components != 1 || !(column->values[k] > 0))
      section.fail("file", fmt::format("the volume of point {} is not positive", k + 1),
                   "every particle has one", "leave the column out: volumes are then those of Voronoi cells");
    volumes.push_back(column->values[k] * std::pow(metre, dimension));
  }
  return volumes;
}

/// The box around the points, as the body's box.
void bound(Body& body, int dimension) {
  body.origin.assign(static_cast<std::size_t>(dimension), std::numeric_limits<double>::infinity());
  std::vector<double> high(static_cast<std::size_t>(dimension), -std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < body.points.size(); ++k) {
    const std::size_t a = k % static_cast<std::size_t>(dimension);
    body.origin[a] = std::min(body.origin[a], body.points[k]);
    high[a] = std::max(high[a], body.points[k]);
  }
  body.size.clear();
  for (std::size_t a = 0; a < high.size(); ++a) body.size.push_back(high[a] - body.origin[a]);
}

template <int d>
std::vector<Vec<d>> points_of(const Body& body) {
  std::vector<Vec<d>> X;
  for (std::size_t k = 0; k < body.points.size(); k += d)
    X.push_back(Eigen::Map<const Vec<d>>(body.points.data() + k));
  return X;
}

/// Mean distance of nearest neighbours; refuses points that coincide or lie outside of the shape.
template <int d>
double checked_spacing(const Section& section, const Body& body) {
  const std::vector<Vec<d>> X = points_of<d>(body);
  const Shape<d> shape = shape_of<d>(body);
  const double guess = 1.5 * std::pow(shape.box.size.prod() / static_cast<double>(X.size()), 1.0 / d);
  if (!(guess > 0)) section.fail("file", "the points lie in a line or plane", "a body has a volume", "");
  const NeighbourSearch<d> search(X);
  std::vector<Index> found;
  double sum = 0;
  for (std::size_t k = 0; k < X.size(); ++k) {
    if (shape.distance(X[k]) > 1e-6 * guess)
      section.fail("file",
                   fmt::format("point {} at {} lies outside of the shape", k + 1, position_text<d>(X[k])),
                   "the shape bounds the particles' cells", "");
    double nearest = std::numeric_limits<double>::infinity();
    for (double R = guess; !(nearest < R); R *= 2) {
      search.within(X[k], R, found);
      for (const Index j : found) {
        const double r = (X[static_cast<std::size_t>(j)] - X[k]).norm();
        if (j != static_cast<Index>(k) && r < 1e-6 * guess)
          section.fail(
              "file",
              fmt::format("points {} and {} are both at {}", std::min<Index>(j, static_cast<Index>(k)) + 1,
                          std::max<Index>(j, static_cast<Index>(k)) + 1, position_text<d>(X[k])),
              "particles must be apart", "take one of them out");
        if (j != static_cast<Index>(k)) nearest = std::min(nearest, r);
      }
    }
    sum += nearest;
  }
  return sum / static_cast<double>(X.size());
}

/// Refuses a cloud whose Voronoi cells would fill what no particle is near to.
template <int d>
void refuse_gaps(const Section& section, const Body& body) {
  const auto gap = widest_gap<d>(points_of<d>(body), shape_of<d>(body), *body.spacing);
  if (!gap) return;
  section.fail(
      "file",
      fmt::format(
          "there is a hole at {}: the nearest particle is {:.3g} m away, where particles are {:.3g} m apart",
          position_text<d>(gap->at), gap->radius, gap->spacing),
      "the cells of the particles around would fill it",
      "describe it by shape or [[body.hole]], give volumes, or add the particles that are missing");
}

}  // namespace

std::string file_beside_scene(const Section& section) {
  const std::string name =
      section.text({"file", "triangles of a closed surface (STL), relative to the scene"});
  const fs::path beside = fs::path(section.where("file").file).parent_path() / name;
  return fs::exists(beside) ? beside.string() : name;
}

double metres_of_unit(const Section& section) {
  if (!section.has("unit")) return 1;
  try {
    return parse_quantity(
        "1 " + section.text(
                   {"unit",
                    "what one unit of the file's lengths is, such as \"mm\"; a metre where it is left out"}),
        quantity::length);
  } catch (const InputError& error) {
    section.fail("unit", error.problem(), error.why(), error.suggestion());
  }
}

void read_cloud_file(const Section& section, Body& body, int dimension) {
  if (dimension == 0)
    section.fail("file", "in a study",
                 "the body of a study is the domain of its solution on a sequence of spacings",
                 "clouds of other programs are judged by plumb campaign and plumb judge --particles");
  refuse_keys_of_lattices(section);
  body.file = file_beside_scene(section);
  body.cloud = "file";
  const double metre = metres_of_unit(section);
  const PointFile file = read_points(body.file);
  if (file.count < 2) section.fail("file", "it holds one point", "a body has more", "");
  body.points = positions_of(section, file, metre, dimension);
  body.volumes = volumes_of(section, file, metre, dimension);
  if (body.shape == "box" && body.size.empty()) bound(body, dimension);
  const auto given = section.optional_number("spacing", quantity::length, Sign::positive);
  const double measured =
      dimension == 2 ? checked_spacing<2>(section, body) : checked_spacing<3>(section, body);
  body.spacing = measured;
  if (body.volumes.empty()) dimension == 2 ? refuse_gaps<2>(section, body) : refuse_gaps<3>(section, body);
  body.spacing = given.value_or(measured);
  body.particles.clear();
  for (const double length : body.size) body.particles.push_back(std::lround(length / *body.spacing) + 1);
}

template <int d>
Cloud<d> cloud_of_file(const Body& body) {
  Cloud<d> cloud;
  const Shape<d> shape = shape_of<d>(body);
  cloud.X = points_of<d>(body);
  cloud.box = shape.box;
  cloud.spacing = *body.spacing;
  if (!shape.clip) find_lattice<d>(cloud);
  const Vec<d> high = shape.box.origin + shape.box.size;
  for (Vec<d>& X : cloud.X) X = X.cwiseMax(shape.box.origin).cwiseMin(high);  // beyond a face by a rounding
  cloud.V = !body.volumes.empty() ? body.volumes
            : shape.clip          ? clipped_cells<d>(cloud.X, shape).volume
                                  : voronoi_volumes<d>(cloud.X, shape.box);
  return cloud;
}

template Cloud<2> cloud_of_file<2>(const Body&);
template Cloud<3> cloud_of_file<3>(const Body&);

}  // namespace plumb
