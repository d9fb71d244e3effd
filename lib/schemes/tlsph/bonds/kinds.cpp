#include "lib/schemes/tlsph/bonds/kinds.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "lib/schemes/tlsph/bonds/same_value.hpp"

namespace plumb {
namespace {

/// Numbers the values that signature(i, value) appends for i from `first` to `end`, in `of`; returns the
/// first i of each.
template <class Signature>
std::vector<Index> group_part(Index first, Index end, std::int32_t* of, Signature&& signature) {
  std::vector<Index> representative;
  ValueNumbering numbering;
  std::vector<std::int64_t> value;
  for (Index i = first; i < end; ++i) {
    value.clear();
    signature(i, value);
    const auto [number, is_new] = numbering.number(value);
    of[i] = number;
    if (is_new) representative.push_back(i);
  }
  return representative;
}

/// Kinds in the order in which a single thread would have met them: every thread groups a part, then the
/// parts' representatives are grouped in the order of the parts.
template <class Signature>
Kinds group(Index n, Signature&& signature) {
  constexpr Index least_part = 1024;  // below that a thread costs more than it brings
  const Index parts = std::clamp<Index>(n / least_part, 1, omp_get_max_threads());
  const int threads = static_cast<int>(parts);
  Kinds kinds;
  kinds.of.resize(n);
  std::vector<std::vector<Index>> found(parts);  // representatives
#pragma omp parallel for schedule(static, 1) num_threads(threads)
  for (Index p = 0; p < parts; ++p)
    found[p] = group_part(n * p / parts, n * (p + 1) / parts, kinds.of.data(), signature);
  std::vector<Index> candidates;
  std::vector<Index> first_of_part;
  for (const auto& part : found) {
    first_of_part.push_back(static_cast<Index>(candidates.size()));
    candidates.insert(candidates.end(), part.begin(), part.end());
  }
  std::vector<std::int32_t> number(candidates.size());
  const std::vector<Index> kept =
      group_part(0, static_cast<Index>(candidates.size()), number.data(),
                 [&](Index c, std::vector<std::int64_t>& value) { signature(candidates[c], value); });
  for (const Index c : kept) kinds.representative.push_back(candidates[c]);
#pragma omp parallel for schedule(static, 1) num_threads(threads)
  for (Index p = 0; p < parts; ++p)
    for (Index i = n * p / parts; i < n * (p + 1) / parts; ++i)
      kinds.of[i] = number[first_of_part[p] + kinds.of[i]];
  return kinds;
}

/// Which neighbour it is: its offset, and behind which walls.
template <int d>
void add_place(const Surroundings<d>& seen, Index i, Index j, std::vector<std::int64_t>& value) {
  value.push_back(seen.slots.of(seen.real(j)) - seen.slots.of(i));
  if (const Ghost<d>* ghost = seen.ghost(j))
    value.insert(value.end(), ghost->across.begin(), ghost->across.end());
}

}  // namespace

template <int d>
Index Surroundings<d>::image(Index i, const Ghost<d>& behind) const {
  const auto before = [](const Ghost<d>& a, const Ghost<d>& b) {
    return std::tie(a.across, a.real) < std::tie(b.across, b.real);
  };
  const Ghost<d> wanted{i, behind.across};
  return particles() + (std::lower_bound(ghosts.begin(), ghosts.end(), wanted, before) - ghosts.begin());
}

Kinds all_different(Index n) {
  Kinds kinds;
  kinds.of.resize(n);
  kinds.representative.resize(n);
  for (Index i = 0; i < n; ++i) kinds.of[i] = static_cast<std::int32_t>(kinds.representative[i] = i);
  return kinds;
}

template <int d>
Kinds kinds_by_neighbourhood(const Surroundings<d>& seen) {
  if (!seen.is_lattice()) return all_different(seen.particles());
  const Cloud<d>& cloud = seen.cloud;
  const double length = 0x1p30 / cloud.spacing, volume = 0x1p30 / std::pow(cloud.spacing, d);
  return group(seen.particles(), [&](Index i, std::vector<std::int64_t>& value) {
    for (const auto j : seen.all.of(i)) {
      add_place(seen, i, j, value);
      for (int k = 0; k < d; ++k) value.push_back(std::llround((cloud.X[j][k] - cloud.X[i][k]) * length));
      value.push_back(std::llround(cloud.V[j] * volume));
    }
  });
}

template <int d>
Kinds kinds_by_stencil(const Surroundings<d>& seen, const std::vector<std::vector<BondConstants<d>>>& bonds) {
  if (!seen.is_lattice()) return all_different(seen.particles());
  const Cloud<d>& cloud = seen.cloud;
  const double per_length = 0x1p30 * cloud.spacing, volume = 0x1p30 / std::pow(cloud.spacing, d);
  return group(seen.particles(), [&](Index i, std::vector<std::int64_t>& value) {
    value.push_back(std::llround(cloud.V[i] * volume));
    for (const auto& bond : bonds[i]) {
      value.push_back(seen.slots.of(bond.other) - seen.slots.of(i));
      for (int k = 0; k < d; ++k) value.push_back(std::llround(bond.stencil[k] * per_length));
    }
  });
}

template <int d>
Kinds kinds_by_neighbours(const Surroundings<d>& seen, const Kinds& own) {
  if (!seen.is_lattice()) return all_different(seen.particles());
  return group(seen.particles(), [&](Index i, std::vector<std::int64_t>& value) {
    value.push_back(own.of[i]);
    for (const auto j : seen.all.of(i)) value.push_back(own.of[seen.real(j)]);
  });
}

Kinds kinds_of_packs(const Slots& slots, const std::vector<std::int32_t>& row_of_slot) {
  if (slots.line == 0) return all_different(slots.packs());
  const int W = slots.width;
  return group(slots.packs(), [&](Index p, std::vector<std::int64_t>& value) {
    value.assign(row_of_slot.begin() + p * W, row_of_slot.begin() + (p + 1) * W);
  });
}

#define PLUMBLINE_INSTANTIATE(d)                                                         \
  template struct Surroundings<d>;                                                       \
  template Kinds kinds_by_neighbourhood<d>(const Surroundings<d>&);                      \
  template Kinds kinds_by_stencil<d>(const Surroundings<d>&,                             \
                                     const std::vector<std::vector<BondConstants<d>>>&); \
  template Kinds kinds_by_neighbours<d>(const Surroundings<d>&, const Kinds&);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
