#pragma once
#include <functional>
#include <memory>
#include <optional>

#include "lib/schemes/element/element_mesh.hpp"
#include "lib/schemes/element/element_options.hpp"
#include "lib/schemes/mixed/block_law.hpp"
#include "lib/schemes/scheme.hpp"
#include "lib/schemes/tlsph/loops/linearise.hpp"

namespace plumb {

/// A body of finite elements as sparse matrices between nodes and points, with its law. Displacements,
/// forces: d x node + component. What is asked at points is a field by point.
template <int d>
struct ElementBody {
  using Rows =
      Eigen::SparseMatrix<double, Eigen::RowMajor>;  ///< a row has one thread: the same bits for any number

  Cloud<d> cloud;   ///< the nodes with their lumped volumes
  Elastic elastic;  ///< of small strains in d dimensions
  ElementMesh<d> mesh;
  BlockLaw<d> law;
  /// What points remember of a law with history, committed once a step; it belongs to the body: copies share it. Null: nothing.
  std::shared_ptr<MixedState<d>> memory;
  std::function<Tangent<d>(const Mat<d>&)> tangent;  ///< dP/dF of an elastic law [Pa]; empty with a memory
  double hourglass_modulus = 0;                      ///< alpha mu [Pa]
  Rows slopes;                                       ///< nodes -> slopes at row d x point + direction [1/m]
  Rows forces;                                       ///< the transposed, times weights [m^(d-1)]
  Rows springs;  ///< hourglass stiffness, node by node [N/m]; without entries if there is none
  Rows mean;     ///< points -> nodes: mean by shape function and weight

  Index points() const { return mesh.cells() * mesh.points; }
  /// F of all points.
  Field gradients(const Eigen::VectorXd& u) const;
  /// F of all nodes, as the mean of the points around them.
  Field nodal_gradients(const Field& F) const;
  /// Where J of a point is not positive, with the first node of its cell.
  std::optional<Trouble> trouble(const Field& F) const;
  /// Minus the internal force [N], with F of those displacements.
  Eigen::VectorXd residual(const Eigen::VectorXd& u, const Field& F) const;
  double strain_energy(const Field& F) const;  ///< [J]
  /// Sum of the potentials of the increment from the committed history [J]; the strain energy of a law without.
  double potential(const Field& F) const;
  /// dP/dF of the increment of a point from its committed history [Pa].
  Tangent<d> tangent_at(const Mat<d>& F, Index point) const;
  /// Moves the history of every point to F.
  void commit(const Field& F) const;
  double hourglass_energy(const Eigen::VectorXd& u) const;  ///< [J]
  /// The highest angular frequency of the stiffest cell [1/s]. THEORY (15.10).
  double highest_frequency() const;
};

/// Puts the body together. InputError as make_element_mesh(), and for a law that follows rates.
template <int d>
ElementBody<d> make_element_body(Specimen<d> specimen, const ElementOptions& options);

}  // namespace plumb
