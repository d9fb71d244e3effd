#pragma once
#include <vector>

#include "lib/geometry/cloud.hpp"

namespace plumb {

/// Cells between the nodes of a lattice, with all that a material needs of them. Nodes are particles; a cell
/// has (degree + 1)^d of them. Nodes may have been moved: the cells are isoparametric.
template <int d>
struct ElementMesh {
  int nodes = 0, points = 0;   ///< of one cell; points are where the law is asked
  std::vector<Index> node;     ///< per cell and node: its particle
  std::vector<double> weight;  ///< per cell and point [m^d]
  std::vector<Vec<d>> slope;   ///< per cell, point and node: gradient of its shape function [1/m]
  std::vector<double> shape;   ///< per point and node: value of its shape function
  std::vector<double>
      springs;  ///< per cell, node by node: hourglass stiffness over alpha mu [m^(d-2)]; empty: none
  std::vector<double> volume;  ///< lumped, per particle [m^d]

  Index cells() const { return static_cast<Index>(node.size()) / nodes; }
};

/// The cells of a node lattice. `one_point`: a single point per cell, where the slopes are the mean ones, and
/// springs. InputError if the cloud is no node lattice of a box, has a number of cells that the degree does
/// not divide, or a cell is folded.
template <int d>
ElementMesh<d> make_element_mesh(const Cloud<d>& cloud, int degree, bool one_point);

}  // namespace plumb
