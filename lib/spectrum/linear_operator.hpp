#pragma once
#include <Eigen/SparseCore>
#include <vector>

#include "lib/schemes/tlsph/boundary/supports.hpp"
#include "lib/schemes/tlsph/loops/linearise.hpp"

namespace plumb {

/// The equations of motion linearised about the reference state at rest, applied by the solver's own loops
/// (bond table, force weights, terms) with the small-strain stress lambda tr(e) I + 2 mu e. Dimensionless:
/// lengths in spacings d, times in d/c_p, so that a'' = -K a - C a' for the displacements a of all free
/// components and the eigenvalues of K are (omega d / c_p)^2. Supported components are held at zero.
/// THEORY (9.1).
template <int d>
class LinearOperator {
 public:
  /// Takes the body as built, with its terms; `supports` as in the scene.
  LinearOperator(Solid<d> solid, const std::vector<Support<d>>& supports);

  /// A free component: particle and direction.
  struct Component {
    Index particle;
    int axis;
  };
  const std::vector<Component>& components() const { return components_; }
  Index size() const { return static_cast<Index>(components_.size()); }
  const Solid<d>& solid() const { return solid_; }
  /// d/c_p [s]: one unit of time.
  double time_unit() const { return solid_.cloud.spacing / solid_.elastic.wave_speed(); }
  /// Some term acts on velocities: C is not zero.
  bool damped() const { return damped_; }

  /// K a.
  Eigen::VectorXd stiffness(const Eigen::VectorXd& a);
  /// C b.
  Eigen::VectorXd damping(const Eigen::VectorXd& b);
  /// K put together from the bond table (linearise.hpp): another way to the same operator.
  Eigen::SparseMatrix<double> stiffness_matrix() const;
  /// C column by column. Entries below 1e-15 of the largest one are rounding and left out.
  Eigen::SparseMatrix<double> damping_matrix();

  /// Square roots of the masses of all free components, in units of the mean: R K R^-1 is symmetric if the
  /// force derives from an energy.
  Eigen::VectorXd root_masses() const;
  /// An orthonormal basis of the small rigid motions that the supports allow: columns, as many as there are.
  Eigen::MatrixXd rigid_motions() const;

 private:
  Eigen::VectorXd response(const Eigen::VectorXd* a, const Eigen::VectorXd* b);

  Solid<d> solid_;
  Sweeps<d> own_sweeps_;  ///< of the material itself
  State<d> state_;
  Workspace<d> workspace_;
  std::vector<Component> components_;
  Eigen::VectorXd at_rest_;  ///< response of the reference state: not zero if F(X) is not I
  bool damped_ = false;
};

}  // namespace plumb
