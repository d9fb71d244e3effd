#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "lib/core/types.hpp"

/// Neighbours of particles that move: a list that looks a skin farther than it must, and values per pair.
namespace plumb {

/// All pairs of near particles, both ways: row i lists the others of i, ascending, without i itself.
struct PairList {
  std::vector<std::int64_t> begin;  ///< size N + 1
  std::vector<std::int32_t> other;

  std::span<const std::int32_t> of(Index i) const {
    return {other.data() + begin[static_cast<std::size_t>(i)],
            static_cast<std::size_t>(begin[static_cast<std::size_t>(i) + 1] -
                                     begin[static_cast<std::size_t>(i)])};
  }
};

/// One number of each pair of a list. It moves to another list by `move_to`.
struct PairHistory {
  std::shared_ptr<const PairList> list;
  std::vector<double> value;  ///< as many as list->other

  /// Keeps the values of pairs that both lists have; pairs that are new have 0.
  void move_to(std::shared_ptr<const PairList> target);
  /// Returns the memory of the values and of their list.
  std::size_t bytes() const {
    const std::size_t rows = list ? list->begin.size() : 0;
    return value.size() * (sizeof(double) + sizeof(std::int32_t)) + rows * sizeof(std::int64_t);
  }
  /// i, j and the value, one triple after the other, of pairs i < j whose value is not 0.
  std::vector<double> triples() const;
};

/// The history of `particles` particles that has these triples.
PairHistory history_of(const std::vector<double>& triples, Index particles);

/// Which pairs a list holds: those within bodies, those between them, or both.
enum class PairsOf { all, one_body, different_bodies };

/// Keeps a list that holds every pair nearer than `reach`. It is found again when two particles may have come
/// nearer by the skin than they were: by how far each has moved relative to the mean rigid motion of its
/// body, and those of different bodies by how far the bodies have moved, too. Sums over a row in its order,
/// with weights that vanish beyond the reach, have the same bits however old the list is.
template <int d>
class MovingNeighbours {
 public:
  /// reach and skin in [m]. `body`: the number (0, 1, ..) of each particle's body; empty: there is one body.
  MovingNeighbours(double reach, double skin, std::vector<int> body = {}, PairsOf of = PairsOf::all);

  /// Makes the list good for particles at x [m], which must be finite. Returns whether it was found again.
  bool update(const std::vector<Vec<d>>& x);

  const std::shared_ptr<const PairList>& list() const { return list_; }
  double reach() const { return reach_; }
  long searches() const { return searches_; }
  int body_of(Index i) const { return body_.empty() ? 0 : body_[static_cast<std::size_t>(i)]; }

 private:
  /// How much nearer than in the list two particles may be [m], at most.
  double approach(const std::vector<Vec<d>>& x) const;

  double reach_, skin_;
  std::vector<int> body_;
  PairsOf of_ = PairsOf::all;
  int bodies_ = 1;
  std::shared_ptr<const PairList> list_;
  std::vector<Vec<d>> found_at_;
  long searches_ = 0;
};

/// Every pair nearer than `radius` [m], by cells of that size (larger ones where particles are far apart). `body`: the number of
/// each particle's body, if not all pairs are wanted.
template <int d>
PairList pairs_within(const std::vector<Vec<d>>& x, double radius, const std::vector<int>& body = {},
                      PairsOf of = PairsOf::all);

}  // namespace plumb
