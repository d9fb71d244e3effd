#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "lib/core/types.hpp"

namespace plumb {

/// A tree of boxes around triangles, for nearest ones and for those that a box meets.
class BoxTree {
 public:
  explicit BoxTree(const std::vector<std::array<Vec<3>, 3>>& triangles) {
    for (std::size_t t = 0; t < triangles.size(); ++t) order_.push_back(t);
    grow(triangles, 0, order_.size());
  }

  /// Calls visit(t) for triangles whose boxes are nearer to X than the square of a distance, which visit may
  /// lessen [m^2].
  template <class Visit>
  void nearest(const Vec<3>& X, const double& square, Visit&& visit) const {
    descend(
        0, [&](const Node& node) { return node.square_to(X) < square; },
        [&](std::size_t a, std::size_t b) { return nodes_[a].square_to(X) <= nodes_[b].square_to(X); },
        visit);
  }

  /// Calls visit(t) for triangles in boxes that meet the box from lower to upper.
  template <class Visit>
  void meeting(const Vec<3>& lower, const Vec<3>& upper, Visit&& visit) const {
    descend(
        0,
        [&](const Node& node) {
          return (node.lower.array() <= upper.array()).all() && (lower.array() <= node.upper.array()).all();
        },
        [](std::size_t, std::size_t) { return true; }, visit);
  }

 private:
  struct Node {
    Vec<3> lower, upper;
    std::size_t begin, end, left = 0, right = 0;  ///< children: none if left is 0

    double square_to(const Vec<3>& X) const {
      return (lower - X).cwiseMax(X - upper).cwiseMax(0.0).squaredNorm();
    }
  };

  std::size_t grow(const std::vector<std::array<Vec<3>, 3>>& triangles, std::size_t begin, std::size_t end) {
    constexpr std::size_t leaf = 4;
    Node node{triangles[order_[begin]][0], triangles[order_[begin]][0], begin, end};
    for (std::size_t k = begin; k < end; ++k)
      for (const Vec<3>& corner : triangles[order_[k]]) {
        node.lower = node.lower.cwiseMin(corner);
        node.upper = node.upper.cwiseMax(corner);
      }
    const std::size_t number = nodes_.size();
    nodes_.push_back(node);
    if (end - begin <= leaf) return number;
    int axis = 0;
    (node.upper - node.lower).maxCoeff(&axis);
    const auto middle = [&](std::size_t t) {
      return triangles[t][0][axis] + triangles[t][1][axis] + triangles[t][2][axis];
    };
    const auto first = order_.begin();
    const std::size_t half = begin + (end - begin) / 2;
    std::nth_element(first + static_cast<std::ptrdiff_t>(begin), first + static_cast<std::ptrdiff_t>(half),
                     first + static_cast<std::ptrdiff_t>(end), [&](std::size_t a, std::size_t b) {
                       return middle(a) != middle(b) ? middle(a) < middle(b) : a < b;
                     });
    const std::size_t left = grow(triangles, begin, half), right = grow(triangles, half, end);
    nodes_[number].left = left;
    nodes_[number].right = right;
    return number;
  }

  template <class Wanted, class First, class Visit>
  void descend(std::size_t at, const Wanted& wanted, const First& first, Visit&& visit) const {
    const Node& node = nodes_[at];
    if (!wanted(node)) return;
    if (node.left == 0) {
      for (std::size_t k = node.begin; k < node.end; ++k) visit(order_[k]);
      return;
    }
    const bool left = first(node.left, node.right);
    descend(left ? node.left : node.right, wanted, first, visit);
    descend(left ? node.right : node.left, wanted, first, visit);
  }

  std::vector<std::size_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace plumb
