#pragma once
#include <algorithm>
#include <utility>
#include <vector>

#include "lib/particles/block.hpp"

namespace plumb {

/// Knows with which weight the forces of an evaluation count in their step, for who adds them up. The evaluations are
/// counted by block: one thread can be at forces of its blocks while another is at its first stresses.
class StepWeights {
 public:
  StepWeights() = default;
  /// `weights`: ChosenIntegrator::weights, not empty.
  StepWeights(std::vector<double> weights, Index blocks)
      : weights_(std::move(weights)), evaluations_(static_cast<std::size_t>(blocks), 0) {}

  /// The last evaluation of a step is the first of the next (Verlet).
  bool carries() const { return weights_.size() == 1; }
  void start_step() { std::fill(evaluations_.begin(), evaluations_.end(), 0); }
  /// To be called once per evaluation and block, before the first weight of it is asked for.
  void count(const Block& block) { ++evaluations_[number_of(block)]; }
  double of(const Block& block) const {
    return weights_[std::min(evaluations_[number_of(block)], weights_.size()) - 1];
  }

 private:
  static std::size_t number_of(const Block& block) {
    return static_cast<std::size_t>(block.begin() / block_slots);
  }

  std::vector<double> weights_;
  std::vector<std::size_t> evaluations_;  ///< of this step, by block
};

}  // namespace plumb
