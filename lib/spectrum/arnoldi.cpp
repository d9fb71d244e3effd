#include "lib/spectrum/arnoldi.hpp"

#include <Spectra/GenEigsSolver.h>

#include <stdexcept>

namespace plumb {
namespace {

/// A map as Spectra wants it.
class Product {
 public:
  using Scalar = double;

  explicit Product(const LinearMap& map) : map_(map) {}

  Index rows() const { return map_.size; }
  Index cols() const { return map_.size; }
  void perform_op(const double* in, double* out) const {
    Eigen::Map<Eigen::VectorXd>(out, rows()) = map_.image(Eigen::Map<const Eigen::VectorXd>(in, rows()));
  }

 private:
  const LinearMap& map_;
};

}  // namespace

Eigen::MatrixXd outer_span(const LinearMap& map, bool grows) {
  const int wanted = static_cast<int>(std::min<Index>(20, map.size - 2));
  Product product(map);
  Spectra::GenEigsSolver<Product> solver(product, wanted, krylov_space(map.size, wanted));
  solver.init();
  const auto found = solver.compute(Spectra::SortRule::LargestMagn, grows ? 100 : 2, 1e-8);
  if (grows && found == 0) throw std::runtime_error("the iteration for growing motion did not converge");
  return real_span(solver.eigenvectors());
}

}  // namespace plumb
