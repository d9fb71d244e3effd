#include "plumbline/schemes/implicit/discrete_energy.hpp"

#include "plumbline/core/error.hpp"
#include "plumbline/diagnostics/measures.hpp"
#include "plumbline/solid/evaluate.hpp"

namespace plumb {
namespace {

/// Sums of some ten rounded products.
constexpr double rounding = 1e-12;

/// The force has an energy if D is the transposed of V G, the adjoint form. THEORY (5.3).
template <int d>
void require_energy(const Solid<d>& solid, const LinearOperators& operators) {
  SparseMatrix adjoint = operators.gradient.transpose();
  for (Index n = 0; n < adjoint.cols(); ++n) adjoint.col(n) *= solid.cloud.V[n / (d * d)];
  if ((operators.force - adjoint).norm() <= rounding * operators.force.norm()) return;
  throw InputError(
      "this internal force has no energy",
      "equilibrium is sought as a stationary point of the energy, and the force is not its derivative",
      "use momentum = \"adjoint\"");
}

/// The body with those of its terms that are energies.
template <int d>
Solid<d> energies_of(Solid<d> solid) {
  for (const auto& term : solid.terms)
    if (term.whole)
      throw InputError("[" + term.name + "] beside the implicit scheme",
                       "it changes forces as a whole, so that they have no energy", "leave it out");
  std::erase_if(solid.terms, [](const Term<d>& term) { return !term.energy && !term.internal; });
  return solid;
}

}  // namespace

template <int d>
DiscreteEnergy<d>::DiscreteEnergy(const Solid<d>& solid, std::vector<Index> unknowns)
    : solid_(energies_of(solid)),
      state_(make_state(solid_)),
      unknowns_(std::move(unknowns)),
      operators_(linear_operators(solid_)) {
  require_energy(solid_, operators_);
  std::vector<Index> all(static_cast<std::size_t>(operators_.gradient.rows()));
  for (std::size_t n = 0; n < all.size(); ++n) all[n] = static_cast<Index>(n);
  gradient_part_ = part_of(operators_.gradient, all, unknowns_);
  force_part_ = part_of(operators_.force, unknowns_, all);
  terms_part_ = part_of(operators_.terms, unknowns_, unknowns_);
}

template <int d>
const State<d>& DiscreteEnergy<d>::state_at(const Eigen::VectorXd& u) {
  set_unknowns(solid_, u, state_.u);
  return state_;
}

template <int d>
double DiscreteEnergy<d>::energy(const Eigen::VectorXd& u) {
  return energy_of(solid_, state_at(u)).total();
}

template <int d>
std::optional<Eigen::VectorXd> DiscreteEnergy<d>::residual(const Eigen::VectorXd& u) {
  state_at(u);
  Field force = solid_.make_field(d);
  const bool sound = evaluate(solid_, state_, 0, [&](const Block& block, BlockForce<d>& of_block) {
    for (int k = 0; k < d; ++k)
      std::copy_n(of_block.at(k, block.begin()), block.end() - block.begin(), force[k] + block.begin());
  });
  if (!sound) return std::nullopt;
  Eigen::VectorXd result(u.size());
  for (Index i = 0; i < solid_.cloud.size(); ++i)
    result.segment<d>(d * i) = -solid_.cloud.V[i] * vector_at<d>(force, solid_.bonds.slots.of(i));
  return result;
}

template <int d>
Eigen::VectorXd DiscreteEnergy<d>::gradients(const Eigen::VectorXd& u) const {
  return operators_.identity + operators_.gradient * u;
}

template <int d>
void DiscreteEnergy<d>::linearise_at(const Eigen::VectorXd& u) {
  material_ = tangent_operator(solid_, gradients(u));
}

template <int d>
SparseMatrix DiscreteEnergy<d>::tangent() {
  const SparseMatrix& material = stiffness_.of(force_part_, stress_.of(material_, gradient_part_));
  return terms_part_.nonZeros() > 0 ? SparseMatrix(material + terms_part_) : material;
}

template <int d>
Eigen::VectorXd DiscreteEnergy<d>::tangent_times(const Eigen::VectorXd& v) const {
  const Eigen::VectorXd stress = material_ * (operators_.gradient * v);
  return operators_.force * stress + operators_.terms * v;
}

template class DiscreteEnergy<2>;
template class DiscreteEnergy<3>;

}  // namespace plumb
