#pragma once
#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/schemes/tlsph/loops/evaluate.hpp"

namespace plumb {

/// Velocity Verlet (kick, drift, kick), second order, one evaluation of the right-hand side a step;
/// symplectic for a constant step and a force that derives from an energy. THEORY (7.2).
struct Verlet {
  static constexpr std::string_view name = "verlet";
  /// Bounds of lambda dt: on the negative real axis of a force that is read at the velocity before the kick,
  /// on the imaginary axis of an oscillator, THEORY (6.5), (9.3).
  static constexpr double real_axis = 2;
  static constexpr double imaginary_axis = 2;

  template <int d>
  class Integrator {
   public:
    static constexpr std::string_view name = Verlet::name;
    static constexpr int order = 2;
    static constexpr int evaluations_per_step = 1;
    static constexpr int vectors_moved =
        8;  // kick and drift: u, v, a read, u, v written; then v read, v, a written
    static constexpr double weights[] = {0.5};  // of the evaluation before the step, too

    explicit Integrator(const Solid<d>& solid)
        : a_(solid.make_field(d)), before_(solid.make_field(d)), kicked_(solid.blocks()) {}
    std::size_t bytes() const { return a_.bytes() + before_.bytes() + kicked_.size(); }
    /// The acceleration [m/s^2] that the last step ended with. With terms that depend on the velocity it
    /// cannot be found again from the state: it was evaluated at the velocity of half a step before.
    const Field* carried() const { return started_ ? &a_ : nullptr; }
    void carry(const Field& acceleration) {
      a_ = acceleration;
      started_ = true;
    }

    Outcome step(const Solid<d>& solid, Workspace<d>& workspace, State<d>& state, double dt) {
      if (!started_)
        if (const Outcome outcome = accelerate(solid, workspace, state, 0); !outcome) return outcome;
      started_ = true;
      kick_and_drift(solid, state, dt);
      std::swap(a_, before_);
      if (const Outcome outcome = accelerate(solid, workspace, state, dt); !outcome) {
        undo(solid, state, dt);
        return outcome;
      }
      state.time += dt;
      ++state.step;
      return {};
    }

   private:
    /// a(x, t + dt), then the second half kick.
    Outcome accelerate(const Solid<d>& solid, Workspace<d>& workspace, State<d>& state, double dt) {
      const double per_mass = 1 / solid.elastic.density;
      std::fill(kicked_.begin(), kicked_.end(), 0);
      const auto kick = [&](const Block& block, BlockForce<d>& force) {
        for (int k = 0; k < d; ++k) {
          double* v = state.v[k];
          double* a = a_[k];
          const double* f = force.at(k, block.begin()) - block.begin();
#pragma omp simd
          for (Index i = block.begin(); i < block.end(); ++i) {
            a[i] = per_mass * f[i];
            v[i] += 0.5 * dt * a[i];
          }
        }
        kicked_[block.begin() / block_slots] = 1;
      };
      return evaluate(solid, workspace, state, state.time + dt, kick);
    }

    void kick_and_drift(const Solid<d>& solid, State<d>& state, double dt) {
#pragma omp parallel for schedule(static) if (solid.blocks() >= blocks_for_threads)
      for (Index b = 0; b < solid.blocks(); ++b) {
        const Block block = solid.block(b);
        for (int k = 0; k < d; ++k) {
          double* u = state.u[k];
          double* v = state.v[k];
          const double* a = a_[k];
#pragma omp simd
          for (Index i = block.begin(); i < block.end(); ++i) {
            v[i] += 0.5 * dt * a[i];
            u[i] += dt * v[i];
          }
        }
      }
    }

    /// Back to the state before the step (to rounding), so that the last good one can be kept.
    void undo(const Solid<d>& solid, State<d>& state, double dt) {
      for (Index b = 0; b < solid.blocks(); ++b) {
        const Block block = solid.block(b);
        for (int k = 0; k < d; ++k)
          for (Index i = block.begin(); i < block.end(); ++i) {
            if (kicked_[b]) state.v[k][i] -= 0.5 * dt * a_[k][i];
            state.u[k][i] -= dt * state.v[k][i];
            state.v[k][i] -= 0.5 * dt * before_[k][i];
          }
      }
      std::swap(a_, before_);
    }

    Field a_;                   ///< acceleration [m/s^2] at the end of the step
    Field before_;              ///< at its beginning
    std::vector<char> kicked_;  ///< per block: it has had its second half kick
    bool started_ = false;
  };
};

}  // namespace plumb
