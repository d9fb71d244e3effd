#pragma once
#include <optional>
#include <string>
#include <vector>

#include "lib/run/simulation.hpp"
#include "verification/plumb/explain/cost.hpp"

namespace plumb::app {

/// Bonds of a particle.
struct BondsPerParticle {
  double mean;
  Index max;

  template <class Self, class Visit>
  static void members(Self& self, Visit&& visit) {
    visit("mean", self.mean);
    visit("max", self.max);
  }
};

/// Memory in bytes.
struct MemoryNeed {
  std::size_t bytes;  ///< of the arrays
  double bytes_per_particle;
  std::size_t peak_rss;  ///< of the whole program so far

  template <class Self, class Visit>
  static void members(Self& self, Visit&& visit) {
    visit("bytes", self.bytes);
    visit("bytes_per_particle", self.bytes_per_particle);
    visit("peak_rss", self.peak_rss);
  }
};

/// What `plumb explain` says of a scene.
struct Explanation {
  std::string scene, shows;
  int dimension;
  std::string scheme;
  Index particles;
  BondsPerParticle neighbours;
  std::vector<Statement> solves;
  std::vector<std::string> built, left_out;
  std::vector<ArrayEntry> arrays;
  MemoryNeed memory;
  double dt;  ///< first time step [s]
  Statement dt_reason;
  long steps;
  std::optional<int> evaluations_per_step;  ///< nothing where Newton's method makes as many as it needs
  std::optional<double> estimated_wall_s;   ///< nothing if no step was tried, or the first steps fail
  std::string why_no_estimate;              ///< empty if there is one
  Costs costs;
  std::vector<std::string> warnings;

  template <class Self, class Visit>
  static void members(Self& self, Visit&& visit) {
    visit("scene", self.scene);
    visit("shows", self.shows);
    visit("dimension", self.dimension);
    visit("scheme", self.scheme);
    visit("particles", self.particles);
    visit("neighbours", self.neighbours);
    visit("solves", self.solves);
    visit("built", self.built);
    visit("left_out", self.left_out);
    visit("arrays", self.arrays);
    visit("memory", self.memory);
    visit("dt", self.dt);
    visit("dt_reason", self.dt_reason);
    visit("steps", self.steps);
    visit("evaluations_per_step", self.evaluations_per_step);
    visit("estimated_wall_s", self.estimated_wall_s);
    visit("why_no_estimate", self.why_no_estimate);
    visit("costs", self.costs);
    visit("warnings", self.warnings);
  }
};

}  // namespace plumb::app
