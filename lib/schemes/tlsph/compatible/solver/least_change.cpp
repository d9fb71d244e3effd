#include "lib/schemes/tlsph/compatible/solver/least_change.hpp"

#include <algorithm>

#include "lib/core/error.hpp"
#include "lib/linear/cholesky.hpp"
#include "lib/schemes/tlsph/compatible/solver/conjugate_gradients.hpp"
#include "lib/schemes/tlsph/compatible/solver/quadratic_fields.hpp"

namespace plumb {
namespace {

/// Added to the diagonal, whose entries are of order 1. The smallest eigenvalues that matter belong to cubic
/// fields and are of order (spacing/size)^6, 6e-14 for 160 particles across; a refinement multiplies their
/// part of the residual by shift/(eigenvalue + shift). Rounding may turn a pivot negative: then ten times as
/// much.
constexpr double least_shift = 1e-14, most_shift = 1e-10;
/// Rounding of the sums of some 30 terms of order 1 that make a constraint.
constexpr double round_off = 1e-14;
/// What iterations aim at: a fifth of what is promised. Each solution of theirs takes off six digits, beyond
/// which the residual that they carry along is no longer the true one (1e-16 of multipliers up to 1e6).
constexpr double iterated_goal = 2e-13, digits = 1e-4;
constexpr int most_refinements = 60;
/// Particles from which on iterations take less time in 3D; in 2D factors are cheap. Measured, THEORY
/// chapter 11.
constexpr Index iterative_from_fixed = 8000, iterative_from_unknown = 1500;

/// Particles on all crossings of planes, and no bond that passes over a plane: then fields of one coordinate
/// are in the null space, which iterations do not bear (THEORY chapter 11).
template <int d>
bool is_thin_lattice(const BondOperator<d>& N) {
  Index crossings = 1;
  for (int k = 0; k < d; ++k) {
    std::vector<double> planes;
    for (const auto& X : N.X) planes.push_back(X[k]);
    std::sort(planes.begin(), planes.end());
    // 1e-6 spacings: the same plane, but for the rounding of coordinates
    const auto end =
        std::unique(planes.begin(), planes.end(), [](double a, double b) { return b - a < 1e-6; });
    crossings *= end - planes.begin();
    if (crossings > N.particles()) return false;
  }
  for (Index i = 0; i < N.particles(); ++i)
    for (Index b = N.begin[i]; b < N.begin[i + 1]; ++b)
      if (2 * N.half(i, b).cwiseAbs().maxCoeff() > 1.5) return false;
  return true;
}

/// Factorises the matrix with the least shift that works.
void factorise(Cholesky& factor, const Eigen::SparseMatrix<double>& matrix) {
  factor.analyse(matrix);
  double shift = least_shift;
  while (shift <= most_shift) {
    if (factor.factorise(matrix, shift)) return;
    shift *= 10;
  }
  throw InputError("the compatible projection has no solution", "its matrix cannot be factorised",
                   "use a larger beta");
}

/// All components at once, or one right-hand side per component.
template <int d>
Multipliers<d> solve(const Cholesky& factor, const Multipliers<d>& right, bool coupled) {
  const auto n = static_cast<Index>(right.size());
  const Index parts = coupled ? d : 1;  // NOLINT(bugprone-branch-clone): alike in 1D only
  Eigen::MatrixXd packed(n * parts * (d + 1), d / parts);
  const auto place = [&](Index i, int a) {
    return packed.block(coupled ? (i * d + a) * (d + 1) : i * (d + 1), coupled ? 0 : a, d + 1, 1);
  };
  for (Index i = 0; i < n; ++i)
    for (int a = 0; a < d; ++a) place(i, a) = right[i].row(a).transpose();
  packed = factor.solve(packed);
  Multipliers<d> x(right.size(), MultiplierBlock<d>::Zero());
  for (Index i = 0; i < n; ++i)
    for (int a = 0; a < d; ++a) x[i].row(a) = place(i, a).transpose();
  return x;
}

/// A table that is changed step by step, and taken back if a step made it worse.
template <int d>
struct Refinement {
  AreaTable<d>& table;
  const BondOperator<d>& N;
  Multipliers<d> wrong, total;
  LeastChange found{};

  Refinement(AreaTable<d>& t, const BondOperator<d>& n) : table(t), N(n), wrong(missing(t)) {
    total.assign(wrong.size(), MultiplierBlock<d>::Zero());
    found.start_residual = found.residual = largest<d>(wrong);
  }

  /// Whether another step is worth while: the residual is `enough` times the one before, or less.
  bool step(Multipliers<d> x, double enough) {
    ++found.refinements;
    add_multipliers(table, N, x);
    const double before = found.residual;
    Multipliers<d> now = missing(table);
    const double residual = largest<d>(now);
    if (!(residual < before)) {
      for (auto& block : x) block = -block;
      add_multipliers(table, N, x);
      return false;
    }
    wrong = std::move(now);
    found.residual = residual;
    for (std::size_t i = 0; i < x.size(); ++i) total[i] += x[i];
    return residual < enough * before;
  }
};

template <int d>
void solve_directly(Refinement<d>& refinement) {
  Cholesky factor;
  const auto matrix = normal_matrix(refinement.table, refinement.N);
  factorise(factor, matrix);
  refinement.found.unknowns = matrix.rows();
  while (refinement.found.residual > round_off && refinement.found.refinements < most_refinements)
    if (!refinement.step(solve<d>(factor, refinement.wrong, refinement.N.volume_weight > 0), 1)) return;
}

template <int d>
void iterate(Refinement<d>& refinement) {
  const auto& N = refinement.N;
  const Multilevel<d> levels = multilevel(N);
  const QuadraticFields<d> quadratic = quadratic_fields<d>(N);
  LeastChange& found = refinement.found;
  found.levels = static_cast<int>(levels.levels.size()) + 1;
  found.unknowns = N.particles() * d * (d + 1);
  Multipliers<d> x;
  Directions<d> directions;
  while (found.residual > iterated_goal && found.refinements < most_refinements) {
    Multipliers<d> right = refinement.wrong;
    remove_null_part<d>(quadratic, N.X, right);
    const double goal = std::max(digits * found.residual, iterated_goal / 2);
    found.iterations += solve_by_iterations(N, levels, std::move(right), goal, directions, x);
    if (!refinement.step(x, 0.5)) return;
  }
}

}  // namespace

template <int d>
LeastChange least_change(AreaTable<d>& table, const std::vector<Vec<d>>& X, double volume_weight,
                         ProjectionSolver solver) {
  const BondOperator<d> N = bond_operator(table, X, volume_weight);
  Refinement<d> refinement(table, N);
  const Index enough = volume_weight > 0 ? iterative_from_unknown : iterative_from_fixed;
  const bool suits = d == 3 && table.particles() >= enough && !is_thin_lattice(N);
  if (solver == ProjectionSolver::iterative || (solver == ProjectionSolver::automatic && suits))
    iterate(refinement);
  else
    solve_directly(refinement);
  for (const auto& pair : table.pairs)
    refinement.found.largest_change =
        std::max(refinement.found.largest_change, image<d>(pair, refinement.total).norm());
  return refinement.found;
}

template LeastChange least_change<1>(AreaTable<1>&, const std::vector<Vec<1>>&, double, ProjectionSolver);
template LeastChange least_change<2>(AreaTable<2>&, const std::vector<Vec<2>>&, double, ProjectionSolver);
template LeastChange least_change<3>(AreaTable<3>&, const std::vector<Vec<3>>&, double, ProjectionSolver);

}  // namespace plumb
