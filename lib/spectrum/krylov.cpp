#include "lib/spectrum/krylov.hpp"

#include <Spectra/GenEigsRealShiftSolver.h>
#include <Spectra/GenEigsSolver.h>
#include <Spectra/MatOp/SparseGenMatProd.h>
#include <Spectra/MatOp/SparseGenRealShiftSolve.h>
#include <Spectra/MatOp/SparseSymMatProd.h>
#include <Spectra/MatOp/SparseSymShiftSolve.h>
#include <Spectra/SymEigsShiftSolver.h>
#include <Spectra/SymEigsSolver.h>

#include <cmath>
#include <stdexcept>

#include "lib/spectrum/arnoldi.hpp"

namespace plumb {
namespace {

constexpr int most_restarts = 2000;
/// Relative accuracy of the eigenvalues: far below what any use of them needs.
constexpr double accuracy = 1e-10;

template <class Solver>
void iterate(Solver& solver, Spectra::SortRule rule) {
  solver.init();
  solver.compute(rule, most_restarts, accuracy);
  if (solver.info() != Spectra::CompInfo::Successful)
    throw std::runtime_error("the eigenvalue iteration did not converge");
}

template <class Solver>
double modulus(Solver&& solver) {
  iterate(solver, Spectra::SortRule::LargestMagn);
  return std::abs(solver.eigenvalues()[0]);
}

template <class Solver>
LowestMotions lowest(Solver&& solver) {
  iterate(solver, Spectra::SortRule::LargestMagn);
  const Eigen::MatrixXcd vectors = solver.eigenvectors().template cast<std::complex<double>>();
  return {real_span(vectors), solver.eigenvalues().cwiseAbs().maxCoeff()};
}

/// The motion after some steps of the leapfrog scheme from a state at rest. THEORY (9.6).
class Leapfrog {
 public:
  using Vector = Eigen::VectorXd;

  Leapfrog(const SparseMatrix& S, double step, int steps) : S_(S), square_(step * step), steps_(steps) {}

  Index rows() const { return S_.rows(); }
  /// The motion after all steps.
  Vector after(Vector before) const {
    Vector now = first(before);
    for (int n = 1; n < steps_; ++n) advance(before, now);
    return now;
  }

  Vector first(const Vector& start) const { return start - 0.5 * square_ * (S_ * start); }
  void advance(Vector& before, Vector& now) const {
    before = 2 * now - before - square_ * (S_ * now);
    before.swap(now);
  }

 private:
  Eigen::SparseMatrix<double, Eigen::RowMajor> S_;  // its product is shared among threads, with the same bits
  double square_;
  int steps_;
};

/// Steps until some motion has grown a thousandfold, or the most.
int steps_to_grow(const Leapfrog& leapfrog, int most) {
  Eigen::VectorXd before = broad_start(leapfrog.rows()), now = leapfrog.first(before);
  int steps = 1;
  for (; steps < most && now.norm() < 1e3; ++steps) leapfrog.advance(before, now);
  return steps;
}

}  // namespace

double largest_modulus(const SparseMatrix& S, bool symmetric) {
  if (symmetric) {
    Spectra::SparseSymMatProd<double> op(S);
    return modulus(Spectra::SymEigsSolver<decltype(op)>(op, 1, krylov_space(S.rows(), 1)));
  }
  Spectra::SparseGenMatProd<double> op(S);
  return modulus(Spectra::GenEigsSolver<decltype(op)>(op, 1, krylov_space(S.rows(), 1)));
}

LowestMotions lowest_motions(const SparseMatrix& S, bool symmetric, double largest, int count) {
  // a little below zero: rigid modes must not make the shifted matrix singular
  const double shift = -1e-7 * largest;
  const int space = krylov_space(S.rows(), count);
  if (symmetric) {
    Spectra::SparseSymShiftSolve<double> op(S);
    return lowest(Spectra::SymEigsShiftSolver<decltype(op)>(op, count, space, shift));
  }
  Spectra::SparseGenRealShiftSolve<double> op(S);
  return lowest(Spectra::GenEigsRealShiftSolver<decltype(op)>(op, count, space, shift));
}

GrowingMotions growing_motions(const SparseMatrix& S, bool symmetric, double largest) {
  // Half of the largest stable step: (9.6) then orders growth as time does, to 15 %.
  const double step = 1 / std::sqrt(largest);
  constexpr int most_steps = 800;
  const int steps = steps_to_grow(Leapfrog(S, step, most_steps), most_steps);
  const bool grows = steps < most_steps;
  GrowingMotions growing{Eigen::MatrixXd(S.rows(), 0), arnoldi_resolution / (step * steps)};
  // a symmetric operator has no complex pairs, and motions that grow slowly are among its lowest ones
  if (!grows && symmetric) return growing;
  const Leapfrog leapfrog(S, step, steps);
  growing.span =
      outer_span({S.rows(), [&](const Eigen::VectorXd& start) { return leapfrog.after(start); }}, grows);
  return growing;
}

}  // namespace plumb
