#pragma once
#include <optional>
#include <string>
#include <vector>

#include "lib/input/point_file.hpp"
#include "mms/domain.hpp"

namespace plumb::app {

/// How a file of points is to be read.
struct PointOptions {
  std::string positions;  ///< reference | current; empty: current in .vtp files and dumps, else reference
  std::string rest;       ///< a file with the same points at rest; empty: none
};

/// What another program says at its points, in the words of the solutions.
template <int d>
struct ForeignField {
  std::string file;
  std::optional<double> time;      ///< [s], where the file says it
  std::vector<Vec<d>> X;           ///< reference positions [m]
  std::vector<double> volume;      ///< [m^d]; of Voronoi cells where the file has none
  bool estimated_volumes = false;  ///< they are those of Voronoi cells
  double spacing = 0;              ///< mean distance of nearest neighbours [m]
  std::vector<Vec<d>> displacement;
  std::vector<Vec<d>> velocity;  ///< empty: not in the file. Likewise the others
  std::vector<Mat<d>> F, P, cauchy;
};

/// 1 if the file has one coordinate of its points, or three of which the last two are 0 everywhere; 3 if a point has a third
/// one; else 2.
int dimension_of(const PointFile& points);

/// What the file says, without volumes that it does not have and without a spacing. Throws InputError for
/// points without displacement.
template <int d>
ForeignField<d> field_as_it_is(const PointFile& points, const std::string& file, const PointOptions& options);

/// The same with volumes and spacing, in the domain of a solution. Throws InputError with the place for
/// points that coincide, lie outside of the domain, or have no displacement.
template <int d>
ForeignField<d> foreign_field(const PointFile& points, const std::string& file, const mms::Domain<d>& domain,
                              const PointOptions& options);

}  // namespace plumb::app
