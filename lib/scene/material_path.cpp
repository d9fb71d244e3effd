#include "lib/scene/material_path.hpp"

#include <fmt/format.h>

#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

#include "lib/core/error.hpp"
#include "lib/scene/readers.hpp"

namespace plumb {
namespace {

/// What is not named of the third direction stays as it is in `rest`.
template <class Entries, class Value>
Mat<3> in_3d(const Entries& rows, const Mat<3>& rest, Value&& value) {
  Mat<3> full = rest;
  for (std::size_t a = 0; a < rows.size(); ++a)
    for (std::size_t b = 0; b < rows.size(); ++b)
      full(static_cast<Index>(a), static_cast<Index>(b)) = value(rows[a][b]);
  return full;
}

PathPiece read_piece(const Section& section, int& dimension) {
  PathPiece piece;
  piece.duration = section.number_or({"duration", "time that the piece takes"}, piece.duration,
                                     quantity::time, Sign::positive);
  piece.steps = section.integer_or({"steps", "increments of equal length"}, piece.steps, 1);
  const bool by_gradient = section.has("gradient"), by_deformation = section.has("deformation");
  if (by_gradient == by_deformation)
    section.fail(by_gradient ? "deformation" : "gradient",
                 by_gradient ? "contradicts gradient" : "missing key",
                 by_gradient ? "the motion is given by one of them"
                             : "neither gradient nor deformation says how the point moves",
                 by_gradient ? "leave one of them out" : "add deformation = [[\"1 + t\", 0], [0, 1]]");
  std::size_t rows = 0;
  if (by_gradient) {
    const auto L =
        section.number_rows({"gradient", "velocity gradient, constant: rows of numbers"}, quantity::rate);
    piece.gradient = in_3d(L, Mat<3>::Zero(), [](double value) { return value; });
    rows = L.size();
  } else {
    piece.deformation = section.formula_rows(
        {"deformation", "deformation gradient: rows of formulas of the time t since the path began"},
        quantity::number);
    rows = piece.deformation.size();
  }
  if (dimension == 0) dimension = static_cast<int>(rows);
  if (static_cast<int>(rows) != dimension)
    section.fail(by_gradient ? "gradient" : "deformation",
                 fmt::format("{} rows after pieces of {}", rows, dimension), "all have the same dimension");
  section.reject_unknown();
  return piece;
}

Mat<3> deformation_at(const PathPiece& piece, double t) {
  return in_3d(piece.deformation, Mat<3>::Identity(), [t](const Expression& formula) {
    return formula.at({0, 0, 0}, t);
  });
}

PathRow row_of(const MaterialPoint& point, double t, const Mat<3>& F) {
  PathRow row{t, point(F)};
  const double J = determinant<3, double>(row.state.F);
  if (!(J > 0))
    throw InputError(fmt::format("det F = {:.6g} at t = {:.6g} s", J, t),
                     std::isnan(J) ? "no F_33 makes P_33 zero there" : "the point is turned inside out",
                     "end the path earlier");
  if (!row.state.cauchy.allFinite())
    throw InputError(fmt::format("a stress that is not finite at t = {:.6g} s", t),
                     "the law has no value there", "end the path earlier");
  return row;
}

}  // namespace

MaterialPath parse_material_path(const std::string& text, const std::string& file_name,
                                 const std::vector<std::string>& overrides) {
  return material_path_of(parse_document(text, file_name, overrides));
}

MaterialPath material_path_of(const TomlValue& document, KeyNotes* notes) {
  const Section root(document, "", notes);
  root.mark_known({"material", "path"});
  for (const char* other : {"scene", "study"})
    if (!document.find("path") && document.find(other))
      root.fail(other, fmt::format("this file is a {}", other), "a path has [path]",
                other == std::string("scene") ? "plumb run is for scenes" : "plumb mms is for studies");
  root.reject_unknown();
  MaterialPath path;
  path.dimension = 0;
  if (root.is_array("path"))
    for (const Section& section :
         root.sections({"path", "how the point is deformed; several [[path]] follow each other"}))
      path.pieces.push_back(read_piece(section, path.dimension));
  else
    path.pieces.push_back(read_piece(root.section("path"), path.dimension));
  if (path.pieces.empty()) root.fail("path", "no path", "there is nothing to follow", "add [path]");
  path.material =
      read_material(root.section({"material", "the law and its numbers"}), path.dimension, MaterialOf::point);
  return path;
}

MaterialPath read_material_path(const std::string& path, const std::vector<std::string>& overrides) {
  return parse_material_path(read_text(path), path, overrides);
}

std::vector<PathRow> follow(const MaterialPath& path, std::optional<long> steps) {
  const MaterialPoint point = make_point(path.material.law(), path.material.elastic());
  Mat<3> F = Mat<3>::Identity();
  double start = 0;
  std::vector<PathRow> rows;
  if (!path.pieces.front().gradient) F = deformation_at(path.pieces.front(), 0);
  rows.push_back(row_of(point, 0, F));
  for (const PathPiece& piece : path.pieces) {
    const long count = steps.value_or(piece.steps);
    const double dt = piece.duration / static_cast<double>(count);
    const Mat<3> turn = piece.gradient ? Mat<3>((*piece.gradient * dt).exp()) : Mat<3>::Identity();
    for (long n = 1; n <= count; ++n) {
      const double t = start + piece.duration * static_cast<double>(n) / static_cast<double>(count);
      F = piece.gradient ? Mat<3>(turn * F) : deformation_at(piece, t);
      rows.push_back(row_of(point, t, F));
    }
    start += piece.duration;
  }
  return rows;
}

}  // namespace plumb
