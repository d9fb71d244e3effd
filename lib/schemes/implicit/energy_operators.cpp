#include "lib/schemes/implicit/energy_operators.hpp"

#include <algorithm>
#include <cmath>

#include "lib/core/error.hpp"
#include "lib/schemes/tlsph/loops/operator_rows.hpp"

namespace plumb {
namespace {

/// Sums of some ten rounded products.
constexpr double rounded = 1e-12;

template <int d>
PlaceGradients<d> gradients_of(const Solid<d>& solid, const OperatorRows<d>& rows) {
  PlaceGradients<d> G(solid.cloud.size(), solid.bonds.mirror.has_value());
  G.reserve(solid.cloud.size(), solid.cloud.size() + solid.bonds.pairs);
  Shares<d> shares;
  std::vector<PlaceShare<d>> place;
  for (Index i = 0; i < solid.cloud.size(); ++i) {
    rows.gradient(i, shares);
    place.clear();
    for (const Share<d>& share : shares) place.push_back({share.other, share.table});
    G.add(place);
  }
  return G;
}

/// The force has an energy if D is the transposed of V G, the adjoint form, THEORY (5.3). Each force is compared as it is read, for
/// large clouds have no room for D.
template <int d>
void require_energy(const Solid<d>& solid, const OperatorRows<d>& rows, const PlaceGradients<d>& G) {
  std::vector<char> met(static_cast<std::size_t>(G.shares()), 0);
  double difference = 0, size = 0;
  Shares<d> shares;
  for (Index i = 0; i < solid.cloud.size(); ++i) {
    rows.force(i, shares);
    for (const Share<d>& share : shares) {
      Mat<d> expected = Mat<d>::Zero();
      if (const auto n = G.number(share.other, i)) {
        expected = solid.cloud.V[share.other] * G.slope(*n);
        met[static_cast<std::size_t>(*n)] = 1;
      }
      difference += (share.table - expected).squaredNorm();
      size += share.table.squaredNorm();
    }
  }
  for (Index q = 0; q < G.places(); ++q)
    G.for_each(q, [&](std::int64_t n, const PlaceShare<d>& share) {
      if (!met[static_cast<std::size_t>(n)]) difference += (solid.cloud.V[q] * share.slope).squaredNorm();
    });
  if (std::sqrt(difference) <= rounded * std::sqrt(size)) return;
  throw InputError(
      "this internal force has no energy",
      "equilibrium is sought as a stationary point of the energy, and the force is not its derivative",
      "use momentum = \"adjoint\"");
}

}  // namespace

template <int d>
Eigen::VectorXd EnergyOperators<d>::forces(const Eigen::VectorXd& P, const Eigen::VectorXd& u) const {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, d, d == 1 ? Eigen::ColMajor : Eigen::RowMajor>;
  Eigen::VectorXd all = gradient.forces(weight, P);
  if (has_terms())
    Eigen::Map<Rows>(all.data(), all.size() / d, d) +=
        half_of_terms.template selfadjointView<Eigen::Lower>() *
        Eigen::Map<const Rows>(u.data(), u.size() / d, d);
  return all;
}

template <int d>
Eigen::VectorXd EnergyOperators<d>::largest_of_terms(const Eigen::VectorXd& u) const {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(u.size());
  for (Index c = 0; c < half_of_terms.cols(); ++c)
    for (SparseMatrix::InnerIterator it(half_of_terms, c); it; ++it)
      for (int k = 0; k < d; ++k) {
        const double value = std::abs(it.value());
        all[d * it.row() + k] += value * std::abs(u[d * c + k]);
        if (it.row() != c) all[d * c + k] += value * std::abs(u[d * it.row() + k]);
      }
  return all;
}

template <int d>
EnergyOperators<d> energy_operators(const Solid<d>& solid, const std::vector<Term<d>>& terms) {
  const OperatorRows<d> rows(solid);
  EnergyOperators<d> made;
  made.half_of_terms = half_of_terms(solid, terms);  // first: lists of entries are the largest of all
  made.gradient = gradients_of(solid, rows);
  require_energy(solid, rows, made.gradient);
  made.identity = gradients_of_reference(solid);
  made.weight = Eigen::Map<const Eigen::VectorXd>(solid.cloud.V.data(), solid.cloud.size());
  return made;
}

#define PLUMBLINE_INSTANTIATE(d)      \
  template struct EnergyOperators<d>; \
  template EnergyOperators<d> energy_operators<d>(const Solid<d>&, const std::vector<Term<d>>&);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
