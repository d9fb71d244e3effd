#pragma once
#include <Eigen/LU>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "lib/geometry/cloud.hpp"
#include "lib/geometry/ghosts.hpp"
#include "lib/kernel/kernel.hpp"

namespace plumb::test {

/// The choices of a scheme; names as in a scene file.
struct PlainChoices {
  std::string kernel = "cubic", pair = "W1", gradient = "improved", momentum = "adjoint";
  double beta = 0.9;
  struct Dissipation {
    double eta2, eta4, factor;
    bool transpose;
  };
  std::optional<Dissipation> jst;
  std::optional<double> hourglass;  ///< alpha
  bool projection = false;
  std::vector<Wall> walls;  ///< with mirror images behind them
};

/// A particle, or the image of one: R X_j about the walls.
template <int d>
struct Seen {
  Index real;
  Vec<d> signs;  ///< diagonal of R
  Vec<d> X;
};

/// What kernel, correction and estimator leave per particle, every sum over all particles and every formula
/// as it is derived rather than as the library evaluates it.
template <int d>
class PlainTable {
 public:
  using Vectors = std::vector<Vec<d>>;

  /// What the kernel and the estimator leave for one particle, per seen particle.
  struct Row {
    std::vector<double> weight;   ///< V_j W~_ij
    Vectors slope, stencil;       ///< V_j grad W~_ij and c_ij [1/m]
    std::vector<double> laplace;  ///< w_ij [1/m^(d+2)]
  };

  const Cloud<d>& cloud;
  PlainChoices choices;
  RadialKernel<d> kernel;
  double h;  ///< [m]
  std::vector<Seen<d>> seen;
  std::vector<Row> rows;

  PlainTable(const Cloud<d>& body, const PlainChoices& how)
      : cloud(body), choices(how), kernel(kernel_named<d>(how.kernel)), h(how.beta * body.spacing) {
    reflect();
    for (Index i = 0; i < size(); ++i) rows.push_back(row_of(i));
  }

  Index size() const { return cloud.size(); }
  double volume(std::size_t n) const { return cloud.V[seen[n].real]; }
  Vec<d> place(std::size_t n, const Vectors& u) const {
    return seen[n].X + seen[n].signs.cwiseProduct(u[seen[n].real]);
  }
  /// The image of particle i as particle `to` sees it when `n` is an image of `to`: the same walls.
  std::size_t back(Index i, std::size_t n) const { return n / size() * size() + i; }

 private:
  /// The particles, then their images behind every set of walls that are not opposite each other.
  void reflect() {
    for (std::size_t set = 0; set < std::size_t{1} << choices.walls.size(); ++set) {
      bool opposite = false;
      Vec<d> signs = Vec<d>::Ones(), twice = Vec<d>::Zero();
      for (std::size_t w = 0; w < choices.walls.size(); ++w)
        if (set >> w & 1) {
          const auto [axis, upper] = choices.walls[w];
          opposite = opposite || signs[axis] < 0;
          signs[axis] = -1;
          twice[axis] = 2 * (cloud.box.origin[axis] + (upper ? cloud.box.size[axis] : 0));
        }
      if (opposite) continue;
      for (Index j = 0; j < size(); ++j)
        seen.push_back({j, signs, Vec<d>(twice + signs.cwiseProduct(cloud.X[j]))});
    }
  }

  Row row_of(Index i) const {
    Row row = choices.pair == "W1" ? first_order(i) : shepard(i);
    row.stencil.assign(seen.size(), Vec<d>::Zero());
    for (std::size_t n = 0; n < seen.size(); ++n)
      // by the kernel itself: a corrected weight may vanish inside of the support, its slope does not
      if (kernel.w((seen[n].X - cloud.X[i]).norm() / h) != 0 && n != static_cast<std::size_t>(i))
        row.stencil[n] = estimate_of_unit(i, row, n);
    add_laplace(i, row);
    return row;
  }

  /// V W, its derivative with respect to X_i, and the polynomial (1, X_ij/h) whose weights sum as they
  /// should: the moving least-squares form of (2.2), differentiated by the product rule.
  Row first_order(Index i) const {
    using Moment = Eigen::Matrix<double, d + 1, d + 1>;
    using Basis = Eigen::Matrix<double, d + 1, 1>;
    Moment M = Moment::Zero();
    std::array<Moment, d> dM;
    dM.fill(Moment::Zero());
    std::vector<Basis> p(seen.size());
    Row plain = uncorrected(i);
    for (std::size_t n = 0; n < seen.size(); ++n) {
      p[n] << 1, (seen[n].X - cloud.X[i]) / h;
      M += plain.weight[n] * p[n] * p[n].transpose();
      for (int k = 0; k < d; ++k) {
        const Basis dp = -Basis::Unit(k + 1) / h;
        dM[k] += plain.slope[n][k] * p[n] * p[n].transpose() +
                 plain.weight[n] * (dp * p[n].transpose() + p[n] * dp.transpose());
      }
    }
    const Moment inverse = M.inverse();
    const Basis a = inverse.col(0);
    Row row = plain;
    for (std::size_t n = 0; n < seen.size(); ++n) {
      row.weight[n] = plain.weight[n] * p[n].dot(a);
      for (int k = 0; k < d; ++k)
        row.slope[n][k] = plain.slope[n][k] * p[n].dot(a) - plain.weight[n] * a[k + 1] / h -
                          plain.weight[n] * p[n].dot(inverse * dM[k] * a);
    }
    return row;
  }

  /// W over its sum, and that quotient's derivative times the matrix that makes it exact for linear fields.
  /// (2.4)-(2.6).
  Row shepard(Index i) const {
    Row row = uncorrected(i);
    double sum = 0;
    Vec<d> slope = Vec<d>::Zero();
    for (std::size_t n = 0; n < seen.size(); ++n) sum += row.weight[n], slope += row.slope[n];
    Mat<d> M = Mat<d>::Zero();
    for (std::size_t n = 0; n < seen.size(); ++n) {
      row.slope[n] = (sum * row.slope[n] - row.weight[n] * slope) / (sum * sum);
      row.weight[n] /= sum;
      M += row.slope[n] * (seen[n].X - cloud.X[i]).transpose();
    }
    for (auto& g : row.slope) g = M.inverse() * g;  // then sum g (x) X_ij is the identity
    return row;
  }

  Row uncorrected(Index i) const {
    Row row;
    for (std::size_t n = 0; n < seen.size(); ++n) {
      const Vec<d> X = seen[n].X - cloud.X[i];
      const double r = X.norm(), volume_n = volume(n);
      row.weight.push_back(volume_n * kernel.w(r / h) / std::pow(h, d));
      row.slope.push_back(r > 0 ? Vec<d>(-volume_n * kernel.dw(r / h) / std::pow(h, d + 1) * X / r)
                                : Vec<d>(Vec<d>::Zero()));
    }
    return row;
  }

  /// The estimated gradient at i of the field that is 1 at n and 0 elsewhere: c_in, by the literal pair forms
  /// (38), (39).
  Vec<d> estimate_of_unit(Index i, const Row& row, std::size_t n) const {
    const Vec<d> standard = row.slope[n];
    if (choices.gradient == "standard") return standard;
    Vec<d> sum = row.weight[i] * standard;  // the particle's own bond has the standard estimate
    for (std::size_t m = 0; m < seen.size(); ++m) {
      const Vec<d> X = seen[m].X - cloud.X[i];
      if (X.squaredNorm() == 0) continue;
      const double r = X.norm(), difference = m == n ? 1 : 0;
      const Vec<d> e = X / r;
      const Vec<d> along = difference / r * e;
      sum += row.weight[m] *
             (choices.gradient == "improved" ? Vec<d>(standard - standard.dot(e) * e + along) : along);
    }
    return sum;
  }

  void add_laplace(Index i, Row& row) const {
    std::vector<double> phi(seen.size(), 0.0);
    Vec<d> linear = Vec<d>::Zero();
    for (std::size_t n = 0; n < seen.size(); ++n) {
      const Vec<d> X = seen[n].X - cloud.X[i];
      const double r = X.norm();
      if (r == 0) continue;
      phi[n] = -(choices.jst ? choices.jst->factor : 0) * kernel.dw(r / h) / std::pow(h, d + 1) / r;
      linear += volume(n) * phi[n] * X;
    }
    for (std::size_t n = 0; n < seen.size(); ++n)
      row.laplace.push_back(n == static_cast<std::size_t>(i) ? 0
                                                             : phi[n] - linear.dot(row.slope[n]) / volume(n));
  }
};

}  // namespace plumb::test
