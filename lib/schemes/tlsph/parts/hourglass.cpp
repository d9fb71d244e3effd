#include "lib/schemes/tlsph/parts/hourglass.hpp"

#include <memory>

#include "lib/schemes/tlsph/loops/sweeps.hpp"
#include "lib/schemes/tlsph/parts/hourglass_bonds.hpp"

namespace plumb {
namespace {

/// Per-lane sums over the bonds of one pack: use(j, X, own, other), all as packs.
template <int d, int W, class Use>
void for_bonds(const BondTable<d>& bonds, const HourglassBonds& k, Index pack, Use&& use) {
  using Real = Pack<W>;
  const std::int32_t row = bonds.row[pack];
  for (std::int64_t n = bonds.begin[row]; n < bonds.begin[row + 1]; ++n) {
    Real X[d];
    for (int a = 0; a < d; ++a) X[a] = Real::load(bonds.separation.data() + (n * d + a) * W);
    use(pack * W + bonds.offset[n], X, Real::load(k.own.data() + n * W), Real::load(k.other.data() + n * W));
  }
}

/// G X of slot j, with G = F - I.
template <int d, int W>
void explained(const Field& F, Index j, const Pack<W>* X, Pack<W>* out) {
  for (int a = 0; a < d; ++a) {
    out[a] = Pack<W>(0) - X[a];
    for (int b = 0; b < d; ++b) out[a] += Pack<W>::load(F[a * d + b] + j) * X[b];
  }
}

/// P_i -= H_i/V_i, and what the force takes from the particle's own F: THEORY (12.2).
template <int d, int W>
void own_part(const Solid<d>& solid, const HourglassBonds& k, const Block& block, const Instant<d>& now,
              StressWindow& P, Field& partial) {
  using Real = Pack<W>;
  const Field& u = now.state.u;
  const Field& F = now.workspace.F;
  for (Index pack = block.first_pack; pack < block.end_pack; ++pack) {
    const Index i = pack * W;
    Real f[d], H[d][d];
    for (int a = 0; a < d; ++a) {
      f[a] = Real(0);
      for (int b = 0; b < d; ++b) H[a][b] = Real(0);
    }
    for_bonds<d, W>(solid.bonds, k, pack, [&](Index j, const Real* X, Real own, Real other) {
      Real GX[d];
      explained<d, W>(F, i, X, GX);
      for (int a = 0; a < d; ++a) {
        const Real du = Real::load(u[a] + j) - Real::load(u[a] + i);
        const Real pull = own * (du - GX[a]);
        f[a] += pull + other * du;
        for (int b = 0; b < d; ++b) H[a][b] += pull * X[b];
      }
    });
    for (int a = 0; a < d; ++a) {
      f[a].store(partial[a] + i);
      for (int b = 0; b < d; ++b) {
        double* stress = P[a * d + b] + P.place(i);
        (Real::load(stress) - H[a][b] * Real::load(k.per_volume.data() + i)).store(stress);
      }
    }
  }
}

/// Adds the force per unit volume, with what it takes from the others' F.
template <int d, int W>
void others_part(const Solid<d>& solid, const HourglassBonds& k, const Block& block, const Field& F,
                 const Field& partial, BlockForce<d>& force) {
  using Real = Pack<W>;
  for (Index pack = block.first_pack; pack < block.end_pack; ++pack) {
    const Index i = pack * W;
    Real f[d];
    for (int a = 0; a < d; ++a) f[a] = Real::load(partial[a] + i);
    for_bonds<d, W>(solid.bonds, k, pack, [&](Index j, const Real* X, Real, Real other) {
      Real GX[d];
      explained<d, W>(F, j, X, GX);
      for (int a = 0; a < d; ++a) f[a] += Real(0) - other * GX[a];
    });
    const Real per_volume = Real::load(k.per_volume.data() + i);
    for (int a = 0; a < d; ++a) (Real::load(force.at(a, i)) + f[a] * per_volume).store(force.at(a, i));
  }
}

/// E of one block [J], with F from the displacements.
template <int d, int W>
double energy_of_block(const Solid<d>& solid, const HourglassBonds& k, const Block& block, const Field& u) {
  using Real = Pack<W>;
  Real twice(0);
  for (Index pack = block.first_pack; pack < block.end_pack; ++pack) {
    const Index i = pack * W;
    const Mat<d, Real> F = deformation_gradient<d, W>(solid.bonds, u, pack);
    for_bonds<d, W>(solid.bonds, k, pack, [&](Index j, const Real* X, Real own, Real) {
      for (int a = 0; a < d; ++a) {
        Real e = Real::load(u[a] + j) - Real::load(u[a] + i) + X[a];
        for (int b = 0; b < d; ++b) e = e - F(a, b) * X[b];
        twice += own * e * e;
      }
    });
  }
  double sum = 0;
  for (int lane = 0; lane < W; ++lane) sum += twice[lane];
  return sum / 2;
}

/// The functions of the term, for one width of packs.
template <int d, int W>
void set_functions(Term<d>& term, const std::shared_ptr<const HourglassBonds>& k,
                   const std::shared_ptr<Field>& partial) {
  term.stress = [k, partial](const Solid<d>& solid, const Block& block, const Instant<d>& now,
                             StressWindow& P) { own_part<d, W>(solid, *k, block, now, P, *partial); };
  term.second = [k, partial](const Solid<d>& solid, const Block& block, const Instant<d>& now,
                             BlockForce<d>& force) {
    others_part<d, W>(solid, *k, block, now.workspace.F, *partial, force);
  };
  term.energy = [k](const Solid<d>& solid, const State<d>& state) {
    return sum_over_blocks(
        solid, [&](const Block& block) { return energy_of_block<d, W>(solid, *k, block, state.u); });
  };
}

/// The part of the force that is known with the stress is written and read, F is read once more; the tables
/// of rows of their own: springs and separations, twice.
template <int d>
double bytes_moved(const Solid<d>& solid) {
  constexpr double real = sizeof(double), offset = sizeof(std::int32_t);
  const double neighbours = static_cast<double>(solid.bonds.pairs) / static_cast<double>(solid.cloud.size());
  return real * (2 * d + d * d) + (solid.bonds.width == 1 ? 2 * neighbours * (real * (d + 2) + offset) : 0.0);
}

}  // namespace

template <int d>
Term<d> hourglass_term(const Solid<d>& solid, const RadialKernel<d>& kernel, double alpha) {
  const auto k = std::make_shared<const HourglassBonds>(hourglass_bonds(solid, kernel, alpha));
  const auto partial = std::make_shared<Field>(solid.make_field(d));
  Term<d> term;
  term.name = "hourglass";
  term.bytes = partial->bytes() + k->bytes();
  term.bytes_per_update = bytes_moved(solid);
  term.needs_F = true;
  if (solid.bonds.width == 1)
    set_functions<d, 1>(term, k, partial);
  else
    set_functions<d, native_width>(term, k, partial);
  term.stiffness = [k](const Solid<d>& body, const AddStiffness& add) {
    add_hourglass_stiffness(body, *k, add);
  };
  return term;
}

template Term<1> hourglass_term<1>(const Solid<1>&, const RadialKernel<1>&, double);
template Term<2> hourglass_term<2>(const Solid<2>&, const RadialKernel<2>&, double);
template Term<3> hourglass_term<3>(const Solid<3>&, const RadialKernel<3>&, double);

}  // namespace plumb
