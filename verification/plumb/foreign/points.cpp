#include "verification/plumb/foreign/points.hpp"

#include <fmt/format.h>

#include <cmath>

#include "lib/core/error.hpp"
#include "lib/geometry/clipped_cells.hpp"
#include "lib/geometry/neighbours.hpp"
#include "mms/annulus.hpp"

namespace plumb::app {
namespace {

template <int d>
std::string place(const Vec<d>& X) {
  std::string text;
  for (int a = 0; a < d; ++a) text += fmt::format("{}{:g}", a > 0 ? ", " : "", X[a]);
  return "(" + text + ")";
}

template <int d>
std::vector<Vec<d>> vectors_of(const std::vector<double>& values, std::size_t components) {
  std::vector<Vec<d>> all;
  for (std::size_t k = 0; k < values.size() / components; ++k) {
    Vec<d> v;
    for (std::size_t a = 0; a < d; ++a) v[static_cast<int>(a)] = values[k * components + a];
    all.push_back(v);
  }
  return all;
}

/// The first column of one of the names that is a vector.
template <int d>
std::vector<Vec<d>> vector_column(const PointFile& points, const std::vector<std::string>& names) {
  for (const std::string& name : names)
    for (const PointColumn& column : points.columns)
      if (column.components >= d && column.components <= 3 && points.find({name}) != nullptr &&
          points.find({name})->name == column.name)
        return vectors_of<d>(column.values, static_cast<std::size_t>(column.components));
  return {};
}

/// Tensors of d^2 or 9 numbers row by row, or of 6 in VTK's sequence (xx, yy, zz, xy, yz, xz).
template <int d>
std::vector<Mat<d>> tensor_column(const PointFile& points, const std::vector<std::string>& names) {
  const PointColumn* column = points.find(names);
  if (column == nullptr) return {};
  const auto n = static_cast<std::size_t>(column->components);
  if (n != d * d && n != 4 && n != 6 && n != 9) return {};
  if (n == 4 && d != 2) return {};
  constexpr std::size_t symmetric[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
  std::vector<Mat<d>> all;
  for (std::size_t k = 0; k < points.count; ++k) {
    Mat<d> M;
    for (std::size_t i = 0; i < d; ++i)
      for (std::size_t A = 0; A < d; ++A) {
        const std::size_t at = n == 6 ? symmetric[i][A] : i * (n == 9 ? 3 : d) + A;
        M(static_cast<int>(i), static_cast<int>(A)) = column->values[k * n + at];
      }
    all.push_back(M);
  }
  return all;
}

template <int d>
void refuse_outside(const ForeignField<d>& field, const mms::Domain<d>& domain) {
  const double slack = 1e-6 * domain.length();  // positions of single precision
  for (std::size_t k = 0; k < field.X.size(); ++k)
    if (!(domain.depth(field.X[k]) >= -slack))
      throw InputError(fmt::format("{}: point {} at {} lies outside of the solution's domain", field.file, k,
                                   place<d>(field.X[k])),
                       "reference positions are compared",
                       "say --positions current if the file has those of the moved body, or --rest FILE with "
                       "the body at rest");
}

/// Mean distance of nearest neighbours.
template <int d>
double spacing_of(const ForeignField<d>& field, const mms::Domain<d>& domain) {
  const auto n = static_cast<double>(field.X.size());
  if (field.X.size() < 2) throw InputError(field.file + " has one point", "a level has more", "");
  const double volume = domain.box.size.prod(), guess = 1.5 * std::pow(volume / n, 1.0 / d);
  const NeighbourSearch<d> search(field.X);
  std::vector<Index> found;
  double sum = 0;
  for (std::size_t k = 0; k < field.X.size(); ++k) {
    double nearest = std::numeric_limits<double>::infinity();
    for (double R = guess; !(nearest < R); R *= 2) {
      search.within(field.X[k], R, found);
      for (const Index j : found)
        if (j != static_cast<Index>(k))
          nearest = std::min(nearest, (field.X[static_cast<std::size_t>(j)] - field.X[k]).norm());
    }
    if (nearest < 1e-8 * guess)
      throw InputError(fmt::format("{}: two points are at {}", field.file, place<d>(field.X[k])),
                       "points must be apart", "write each point once");
    sum += nearest;
  }
  return sum / n;
}

template <int d>
std::vector<double> voronoi(const ForeignField<d>& field, const mms::Domain<d>& domain) {
  std::vector<Vec<d>> inside = field.X;  // points on a face may lie beyond it by a rounding
  for (Vec<d>& X : inside)
    X = X.cwiseMax(domain.box.origin).cwiseMin(Vec<d>(domain.box.origin + domain.box.size));
  if constexpr (d == 2)
    if (domain.shape == mms::Domain<d>::Shape::annulus)
      return clipped_cells<2>(inside, mms::annulus_shape(domain.inner, domain.outer)).volume;
  return voronoi_volumes<d>(inside, domain.box);
}

/// Reference positions and displacements, by whatever the file has.
template <int d>
void place_points(const PointFile& points, const PointOptions& options, ForeignField<d>& field) {
  const std::vector<Vec<d>> at = vectors_of<d>(points.positions, 3);
  field.displacement = vector_column<d>(points, {"displacement", "displacements", "disp", "u"});
  field.X = vector_column<d>(points, {"reference", "reference position"});
  if (!options.rest.empty()) {
    const PointFile rest = read_points(options.rest);
    if (rest.count != points.count)
      throw InputError(
          fmt::format("{} has {} points, {} has {}", options.rest, rest.count, field.file, points.count),
          "the body at rest has the same points", "");
    field.X = vectors_of<d>(rest.positions, 3);
  }
  const bool moved = options.positions.empty()
                         ? field.file.ends_with(".vtp") || points.find({"type"}) != nullptr
                         : options.positions == "current";
  if (!field.X.empty()) {
    if (field.displacement.empty())
      for (std::size_t k = 0; k < at.size(); ++k) field.displacement.push_back(at[k] - field.X[k]);
    return;
  }
  if (field.displacement.empty())
    throw InputError(fmt::format("{} has no displacement", field.file),
                     fmt::format("its columns are {}", join(points.names())),
                     "name one \"displacement\", or give the body at rest with --rest FILE");
  field.X = at;
  for (std::size_t k = 0; moved && k < at.size(); ++k) field.X[k] -= field.displacement[k];
}

}  // namespace

int dimension_of(const PointFile& points) {
  bool line = points.axes != 2;
  for (std::size_t k = 0; line && k < points.positions.size(); k += 3)
    line = points.positions[k + 1] == 0 && points.positions[k + 2] == 0;
  if (line) return 1;
  for (std::size_t k = 2; k < points.positions.size(); k += 3)
    if (points.positions[k] != 0) return 3;
  return 2;
}

template <int d>
ForeignField<d> field_as_it_is(const PointFile& points, const std::string& file,
                               const PointOptions& options) {
  ForeignField<d> field;
  field.file = file;
  field.time = points.time;
  place_points<d>(points, options, field);
  field.velocity = vector_column<d>(points, {"velocity", "velocities", "v"});
  field.F = tensor_column<d>(points, {"F", "deformation gradient"});
  field.P = tensor_column<d>(points, {"P", "first piola"});
  field.cauchy = tensor_column<d>(points, {"cauchy", "stress", "sigma"});
  const PointColumn* volume = points.find({"volume", "volumes", "weight"});
  if (volume != nullptr && volume->components == 1) field.volume = volume->values;
  for (const double V : field.volume)
    if (!(V > 0)) throw InputError(file + " has a volume that is not positive", "", "");
  return field;
}

template <int d>
ForeignField<d> foreign_field(const PointFile& points, const std::string& file, const mms::Domain<d>& domain,
                              const PointOptions& options) {
  ForeignField<d> field = field_as_it_is<d>(points, file, options);
  refuse_outside<d>(field, domain);
  field.spacing = spacing_of<d>(field, domain);
  field.estimated_volumes = field.volume.empty();
  if (field.estimated_volumes) field.volume = voronoi<d>(field, domain);
  return field;
}

template ForeignField<1> field_as_it_is<1>(const PointFile&, const std::string&, const PointOptions&);
template ForeignField<2> field_as_it_is<2>(const PointFile&, const std::string&, const PointOptions&);
template ForeignField<3> field_as_it_is<3>(const PointFile&, const std::string&, const PointOptions&);
template ForeignField<1> foreign_field<1>(const PointFile&, const std::string&, const mms::Domain<1>&,
                                          const PointOptions&);
template ForeignField<2> foreign_field<2>(const PointFile&, const std::string&, const mms::Domain<2>&,
                                          const PointOptions&);
template ForeignField<3> foreign_field<3>(const PointFile&, const std::string&, const mms::Domain<3>&,
                                          const PointOptions&);

}  // namespace plumb::app
