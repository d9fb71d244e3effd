#pragma once
#include <cstddef>

#include "lib/core/pack.hpp"
#include "lib/core/types.hpp"

namespace plumb {

/// Particles in memory. A slot is a place for one particle; each contiguous line of a lattice is filled up to
/// a whole number of packs with empty slots, which never move and carry no weight. Other clouds have as many
/// slots as particles.
struct Slots {
  Index particles = 0;
  Index line = 0;    ///< particles per line; 0: no lines
  Index stride = 0;  ///< slots per line
  int width = 1;     ///< slots per pack

  Index count() const { return line == 0 ? particles : particles / line * stride; }
  Index packs() const { return count() / width; }
  Index of(Index particle) const { return line == 0 ? particle : particle / line * stride + particle % line; }
};

/// Slots for a cloud: packs of the machine's width on lattices (line > 0), of one particle on any other
/// cloud.
inline Slots make_slots(Index particles, Index line) {
  if (line == 0) return {particles, 0, 0, 1};
  const Index w = native_width;
  return {particles, line, (line + w - 1) / w * w, native_width};
}

/// Components of a field over all slots, one array per component ("structure of arrays"). Readable from
/// `margin` slots before the first to `margin` after the last, so that a pack at the rim may look at
/// neighbours that it does not have.
class Field {
 public:
  Field() = default;
  Field(int components, Index slots, Index margin)
      : components_(components),
        front_((margin + 7) / 8 * 8),
        // 9 cache lines of slack: components must not lie a multiple of 4096 bytes apart
        stride_((2 * front_ + slots + 7) / 8 * 8 + 72),
        data_(static_cast<std::size_t>(components * stride_), 0.0) {}

  double* operator[](int component) { return data_.data() + component * stride_ + front_; }
  const double* operator[](int component) const { return data_.data() + component * stride_ + front_; }
  int components() const { return components_; }
  std::size_t bytes() const { return data_.size() * sizeof(double); }

 private:
  int components_ = 0;
  Index front_ = 0, stride_ = 0;
  AlignedVector data_;
};

/// Reads one vector or tensor (row by row) of a field.
template <int d>
Vec<d> vector_at(const Field& field, Index slot) {
  Vec<d> v;
  for (int k = 0; k < d; ++k) v[k] = field[k][slot];
  return v;
}
template <int d>
void set_vector(Field& field, Index slot, const Vec<d>& v) {
  for (int k = 0; k < d; ++k) field[k][slot] = v[k];
}

}  // namespace plumb
