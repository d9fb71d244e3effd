#pragma once
#include <random>
#include <string>

#include "lib/schemes/tlsph/loops/evaluate.hpp"

/// Bodies for the tests of the solver.
namespace plumb::testing {

struct Scheme {
  std::string estimator = "improved";
  std::string momentum = "adjoint";
  Correction pair = Correction::W1;
  double beta = 0.9;
  bool laplacian = false;
};

inline const Elastic rubber{17e6, 0.45, 1100};

/// A block of 1 x 1 (x 1) m with `cells` cells along the first axis and one or two fewer along the others.
template <int d>
Cloud<d> block(Index cells, Layout layout, double jitter) {
  const double spacing = 1.0 / static_cast<double>(cells);
  std::array<Index, d> counts;
  Box<d> box{Vec<d>::Zero(), Vec<d>::Zero()};
  for (int k = 0; k < d; ++k) {
    counts[k] = cells - k;
    box.size[k] = spacing * static_cast<double>(counts[k]);
  }
  Cloud<d> cloud = lattice<d>(box, counts, layout);
  return jitter > 0 ? jittered<d>(std::move(cloud), jitter, 7, layout) : cloud;
}

template <int d>
BondOptions<d> options(const Scheme& scheme, double spacing) {
  BondOptions<d> o;
  o.kernel = kernel_named<d>("cubic");
  o.smoothing_length = scheme.beta * spacing;
  o.pair = scheme.pair;
  o.estimator = estimator_named<d>(scheme.estimator);
  o.momentum = momentum_form_named<d>(scheme.momentum);
  o.laplacian = scheme.laplacian;
  return o;
}

template <int d>
Solid<d> rubber_block(Index cells, Layout layout, double jitter, const Scheme& scheme = {}) {
  Cloud<d> cloud = block<d>(cells, layout, jitter);
  const auto o = options<d>(scheme, cloud.spacing);
  return make_solid<d>(std::move(cloud), "neo-hookean", rubber, o);
}

/// A smooth displacement of strains of about `size`, plus seeded noise of that share of the spacing.
template <int d>
void deform(const Solid<d>& solid, State<d>& state, double size) {
  std::mt19937_64 random(3);
  const auto next = [&random] { return 2 * static_cast<double>(random() >> 11) * 0x1p-53 - 1; };
  for (Index i = 0; i < solid.cloud.size(); ++i) {
    const Vec<d>& X = solid.cloud.X[i];
    Vec<d> u;
    for (int k = 0; k < d; ++k)
      u[k] = size * (std::sin(2 * X[0] + k) * X[(k + 1) % d] + 0.1 * solid.cloud.spacing * next());
    set_vector<d>(state.u, solid.bonds.slots.of(i), u);
  }
}

/// Force per unit volume of every particle.
template <int d>
std::vector<Vec<d>> forces(const Solid<d>& solid, State<d>& state, Workspace<d>& workspace) {
  std::vector<Vec<d>> f(solid.bonds.slots.count(), Vec<d>::Zero());
  const Outcome outcome =
      evaluate(solid, workspace, state, state.time, [&](const Block& block, BlockForce<d>& force) {
        for (Index i = block.begin(); i < block.end(); ++i)
          for (int k = 0; k < d; ++k) f[i][k] = force(k, i);
      });
  if (!outcome) throw std::runtime_error("the test's deformation is not sound");
  std::vector<Vec<d>> by_particle;
  for (Index i = 0; i < solid.cloud.size(); ++i) by_particle.push_back(f[solid.bonds.slots.of(i)]);
  return by_particle;
}
template <int d>
std::vector<Vec<d>> forces(const Solid<d>& solid, State<d>& state) {
  Workspace<d> workspace;
  return forces(solid, state, workspace);
}

}  // namespace plumb::testing
