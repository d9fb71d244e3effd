#include "plumbline/spectrum/krylov.hpp"

#include <Spectra/GenEigsRealShiftSolver.h>
#include <Spectra/GenEigsSolver.h>
#include <Spectra/MatOp/SparseGenMatProd.h>
#include <Spectra/MatOp/SparseGenRealShiftSolve.h>
#include <Spectra/MatOp/SparseSymMatProd.h>
#include <Spectra/MatOp/SparseSymShiftSolve.h>
#include <Spectra/SymEigsShiftSolver.h>
#include <Spectra/SymEigsSolver.h>

#include <stdexcept>

namespace plumb {
namespace {

constexpr int most_restarts = 2000;
/// Relative accuracy of the eigenvalues: far below what any use of them needs.
constexpr double accuracy = 1e-10;

/// Size of the Krylov space: twice the number wanted and some, as the authors of ARPACK advise.
int space(Index unknowns, int count) {
  return static_cast<int>(std::min<Index>(unknowns, 2 * count + 20));
}

template <class Solver>
EigenPairs solved(Solver& solver, Spectra::SortRule rule) {
  solver.init();
  solver.compute(rule, most_restarts, accuracy);
  if (solver.info() != Spectra::CompInfo::Successful)
    throw std::runtime_error("the eigenvalue iteration did not converge");
  EigenPairs pairs;
  pairs.values = solver.eigenvalues().template cast<std::complex<double>>();
  pairs.vectors = solver.eigenvectors().real();
  return pairs;
}

}  // namespace

EigenPairs largest_pairs(const SparseMatrix& S, bool symmetric, int count) {
  if (symmetric) {
    Spectra::SparseSymMatProd<double> op(S);
    Spectra::SymEigsSolver<Spectra::SparseSymMatProd<double>> solver(op, count, space(S.rows(), count));
    return solved(solver, Spectra::SortRule::LargestMagn);
  }
  Spectra::SparseGenMatProd<double> op(S);
  Spectra::GenEigsSolver<Spectra::SparseGenMatProd<double>> solver(op, count, space(S.rows(), count));
  return solved(solver, Spectra::SortRule::LargestMagn);
}

EigenPairs lowest_pairs(const SparseMatrix& S, bool symmetric, double largest, int count) {
  // a little below zero: rigid modes must not make the shifted matrix singular
  const double shift = -1e-7 * largest;
  if (symmetric) {
    Spectra::SparseSymShiftSolve<double> op(S);
    Spectra::SymEigsShiftSolver<Spectra::SparseSymShiftSolve<double>> solver(op, count,
                                                                             space(S.rows(), count), shift);
    return solved(solver, Spectra::SortRule::LargestMagn);
  }
  Spectra::SparseGenRealShiftSolve<double> op(S);
  Spectra::GenEigsRealShiftSolver<Spectra::SparseGenRealShiftSolve<double>> solver(
      op, count, space(S.rows(), count), shift);
  return solved(solver, Spectra::SortRule::LargestMagn);
}

Eigen::VectorXcd most_imaginary(const SparseMatrix& S, int count) {
  Spectra::SparseGenMatProd<double> op(S);
  Spectra::GenEigsSolver<Spectra::SparseGenMatProd<double>> solver(op, count, space(S.rows(), 2 * count));
  solver.init();
  // 1e-6: this only counts pairs and bounds the growth from below
  solver.compute(Spectra::SortRule::LargestImag, most_restarts, 1e-6);
  return solver.eigenvalues();
}

}  // namespace plumb
