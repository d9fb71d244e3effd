#include "lib/geometry/moving_neighbours.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>

namespace plumb {
namespace {

constexpr Index rows_for_threads = 1500;

/// Particles sorted into cells of a box around them; within a cell in ascending order.
template <int d>
struct Cells {
  std::array<Index, d> count;
  Vec<d> lowest;
  double size = 0;
  std::vector<std::int32_t> begin, particle;

  Index axis_of(const Vec<d>& x, int k) const {
    return std::clamp<Index>(static_cast<Index>((x[k] - lowest[k]) / size), 0, count[k] - 1);
  }
  Index of(const Vec<d>& x) const {
    Index cell = 0;
    for (int k = d - 1; k >= 0; --k) cell = cell * count[k] + axis_of(x, k);
    return cell;
  }
};

/// `least`: no cell is smaller [m]. There are at most as many cells as particles, or 64.
template <int d>
Cells<d> cells_of(const std::vector<Vec<d>>& x, double least) {
  Cells<d> cells;
  Vec<d> highest = x.front();
  cells.lowest = x.front();
  for (const Vec<d>& at : x) {
    cells.lowest = cells.lowest.cwiseMin(at);
    highest = highest.cwiseMax(at);
  }
  const Vec<d> extent = highest - cells.lowest;
  const double most = std::max(64.0, static_cast<double>(x.size()));
  for (cells.size = least;; cells.size *= 1.5) {
    double all = 1;
    for (int k = 0; k < d; ++k) all *= std::floor(extent[k] / cells.size) + 1;
    if (all <= most) break;
  }
  Index all = 1;
  for (int k = 0; k < d; ++k) all *= cells.count[k] = static_cast<Index>(extent[k] / cells.size) + 1;
  std::vector<Index> cell(x.size());
  cells.begin.assign(static_cast<std::size_t>(all) + 1, 0);
  for (std::size_t i = 0; i < x.size(); ++i) ++cells.begin[(cell[i] = cells.of(x[i])) + 1];
  for (Index c = 0; c < all; ++c) cells.begin[c + 1] += cells.begin[c];
  cells.particle.resize(x.size());
  std::vector<std::int32_t> next(cells.begin.begin(), cells.begin.end() - 1);
  for (std::size_t i = 0; i < x.size(); ++i) cells.particle[next[cell[i]]++] = static_cast<std::int32_t>(i);
  return cells;
}

/// Calls use(j) for every other particle within the radius of particle i.
template <int d, class Use>
void for_near(const Cells<d>& cells, const std::vector<Vec<d>>& x, Index i, double radius, Use&& use) {
  std::array<Index, 3> first{0, 0, 0}, last{0, 0, 0};
  for (int k = 0; k < d; ++k) {
    const Index at = cells.axis_of(x[i], k);
    first[k] = std::max<Index>(at - 1, 0);
    last[k] = std::min<Index>(at + 1, cells.count[k] - 1);
  }
  const double square = radius * radius;
  const Index second = d > 1 ? cells.count[d > 1 ? 1 : 0] : 1;
  for (Index c = first[2]; c <= last[2]; ++c)
    for (Index b = first[1]; b <= last[1]; ++b) {
      const Index row = (c * second + b) * cells.count[0];
      for (auto n = cells.begin[row + first[0]]; n < cells.begin[row + last[0] + 1]; ++n) {
        const std::int32_t j = cells.particle[n];
        if (j != i && (x[i] - x[j]).squaredNorm() < square) use(j);
      }
    }
}

/// The rigid motion that a body's particles have made, and how far the others are from it.
template <int d>
struct MeanMotion {
  Vec<d> from = Vec<d>::Zero(), to = Vec<d>::Zero();  ///< mean places [m]
  Mat<d> turn = Mat<d>::Zero();
  double members = 0;
  double turned = 0, shifted = 0;  ///< largest squares of distances from the motion, and from its shift [m^2]

  Vec<d> shift() const { return to - from; }
  void add_place(const Vec<d>& before, const Vec<d>& now) {
    from += before;
    to += now;
    members += 1;
  }
  void close_places() {
    from /= std::max(1.0, members);
    to /= std::max(1.0, members);
  }
  void add_turn(const Vec<d>& before, const Vec<d>& now) { turn += (now - to) * (before - from).transpose(); }
  void close_turns() {
    const Eigen::JacobiSVD<Mat<d>> parts(turn, Eigen::ComputeFullU | Eigen::ComputeFullV);
    turn = parts.matrixU() * parts.matrixV().transpose();
    if (turn.determinant() < 0) turn = Mat<d>::Identity();  // a reflection is no motion
  }
  void add_rest(const Vec<d>& before, const Vec<d>& now) {
    turned = std::max(turned, (now - to - turn * (before - from)).squaredNorm());
    shifted = std::max(shifted, (now - before - shift()).squaredNorm());
  }
};

}  // namespace

template <int d>
PairList pairs_within(const std::vector<Vec<d>>& x, double radius, const std::vector<int>& body, PairsOf of) {
  const auto particles = static_cast<Index>(x.size());
  PairList list;
  list.begin.assign(x.size() + 1, 0);
  if (x.empty()) return list;
  const Cells<d> cells = cells_of<d>(x, radius);
  const bool all = of == PairsOf::all || body.empty(), same = of == PairsOf::one_body;
  const auto wanted = [&](Index i, Index j) { return all || (body[i] == body[j]) == same; };
#pragma omp parallel for schedule(static) if (particles > rows_for_threads)
  for (Index i = 0; i < particles; ++i) {
    std::int64_t count = 0;
    for_near<d>(cells, x, i, radius, [&](std::int32_t j) { count += wanted(i, j); });
    list.begin[i + 1] = count;
  }
  for (Index i = 0; i < particles; ++i) list.begin[i + 1] += list.begin[i];
  list.other.resize(static_cast<std::size_t>(list.begin.back()));
#pragma omp parallel for schedule(static) if (particles > rows_for_threads)
  for (Index i = 0; i < particles; ++i) {
    std::int64_t n = list.begin[i];
    for_near<d>(cells, x, i, radius, [&](std::int32_t j) {
      if (wanted(i, j)) list.other[n++] = j;
    });
    std::sort(list.other.begin() + list.begin[i], list.other.begin() + n);
  }
  return list;
}

void PairHistory::move_to(std::shared_ptr<const PairList> target) {
  if (target == list) return;
  std::vector<double> moved(target->other.size(), 0.0);
  const auto rows = static_cast<Index>(list ? list->begin.size() : 0) - 1;
#pragma omp parallel for schedule(static) if (rows > rows_for_threads)
  for (Index i = 0; i < rows; ++i) {
    std::int64_t from = list->begin[i];
    for (std::int64_t n = target->begin[i]; n < target->begin[i + 1]; ++n) {
      while (from < list->begin[i + 1] && list->other[from] < target->other[n]) ++from;
      if (from < list->begin[i + 1] && list->other[from] == target->other[n]) moved[n] = value[from];
    }
  }
  list = std::move(target);
  value = std::move(moved);
}

std::vector<double> PairHistory::triples() const {
  std::vector<double> all;
  const auto rows = static_cast<Index>(list ? list->begin.size() : 0) - 1;
  for (Index i = 0; i < rows; ++i)
    for (std::int64_t n = list->begin[i]; n < list->begin[i + 1]; ++n)
      if (list->other[n] > i && value[n] != 0)
        all.insert(all.end(), {static_cast<double>(i), static_cast<double>(list->other[n]), value[n]});
  return all;
}

PairHistory history_of(const std::vector<double>& triples, Index particles) {
  std::vector<std::vector<std::pair<std::int32_t, double>>> rows(static_cast<std::size_t>(particles));
  for (std::size_t n = 0; n + 2 < triples.size(); n += 3) {
    const auto i = static_cast<std::int32_t>(triples[n]), j = static_cast<std::int32_t>(triples[n + 1]);
    rows[i].emplace_back(j, triples[n + 2]);
    rows[j].emplace_back(i, triples[n + 2]);
  }
  PairList list;
  PairHistory history;
  list.begin.push_back(0);
  for (auto& row : rows) {
    std::sort(row.begin(), row.end());
    for (const auto& [j, value] : row) {
      list.other.push_back(j);
      history.value.push_back(value);
    }
    list.begin.push_back(static_cast<std::int64_t>(list.other.size()));
  }
  history.list = std::make_shared<const PairList>(std::move(list));
  return history;
}

template <int d>
MovingNeighbours<d>::MovingNeighbours(double reach, double skin, std::vector<int> body, PairsOf of)
    : reach_(reach), skin_(skin), body_(std::move(body)), of_(of) {
  if (!body_.empty()) bodies_ = *std::max_element(body_.begin(), body_.end()) + 1;
}

template <int d>
double MovingNeighbours<d>::approach(const std::vector<Vec<d>>& x) const {
  std::vector<MeanMotion<d>> bodies(static_cast<std::size_t>(bodies_));
  const auto particles = static_cast<Index>(x.size());
  for (Index i = 0; i < particles; ++i) bodies[body_of(i)].add_place(found_at_[i], x[i]);
  for (auto& body : bodies) body.close_places();
  for (Index i = 0; i < particles; ++i) bodies[body_of(i)].add_turn(found_at_[i], x[i]);
  for (auto& body : bodies) body.close_turns();
  for (Index i = 0; i < particles; ++i) bodies[body_of(i)].add_rest(found_at_[i], x[i]);
  double nearer = 0;
  for (std::size_t a = 0; a < bodies.size(); ++a) {
    // distances do not change by a rigid motion
    if (of_ != PairsOf::different_bodies) nearer = std::max(nearer, 2 * std::sqrt(bodies[a].turned));
    for (std::size_t b = a + 1; b < bodies.size() && of_ != PairsOf::one_body; ++b)
      nearer = std::max(nearer, std::sqrt(bodies[a].shifted) + std::sqrt(bodies[b].shifted) +
                                    (bodies[a].shift() - bodies[b].shift()).norm());
  }
  return nearer;
}

template <int d>
bool MovingNeighbours<d>::update(const std::vector<Vec<d>>& x) {
  if (list_ && found_at_.size() == x.size() && approach(x) < skin_) return false;
  list_ = std::make_shared<const PairList>(pairs_within<d>(x, reach_ + skin_, body_, of_));
  found_at_ = x;
  ++searches_;
  return true;
}

template PairList pairs_within<1>(const std::vector<Vec<1>>&, double, const std::vector<int>&, PairsOf);
template PairList pairs_within<2>(const std::vector<Vec<2>>&, double, const std::vector<int>&, PairsOf);
template PairList pairs_within<3>(const std::vector<Vec<3>>&, double, const std::vector<int>&, PairsOf);
template class MovingNeighbours<1>;
template class MovingNeighbours<2>;
template class MovingNeighbours<3>;

}  // namespace plumb
