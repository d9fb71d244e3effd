#pragma once
#include <algorithm>
#include <numbers>
#include <string_view>
#include <vector>

#include "lib/schemes/tlsph/loops/evaluate.hpp"

namespace plumb {

/// Three-stage strong-stability-preserving Runge-Kutta scheme (30), third order, with loads at the times of
/// the stages t, t + dt, t + dt/2 (as printed, at t^n in all stages, it is of first order for loads that vary
/// in time). THEORY (7.1).
struct SspRk3 {
  static constexpr std::string_view name = "rk3";
  /// Bounds of lambda dt for y' = lambda y on the negative real and on the imaginary axis, THEORY (6.5),
  /// (9.3).
  static constexpr double real_axis = 2.51;
  static constexpr double imaginary_axis = std::numbers::sqrt3;

  template <int d>
  class Integrator {
   public:
    static constexpr std::string_view name = SspRk3::name;
    static constexpr int order = 3;
    static constexpr int evaluations_per_step = 3;
    static constexpr int vectors_moved =
        6;  // u, v, u0, v0 read, u, v written; in the first stage u0, v0 written
    static constexpr double weights[] = {1.0 / 6, 1.0 / 6, 2.0 / 3};

    explicit Integrator(const Solid<d>& solid)
        : u0_(solid.make_field(d)), v0_(solid.make_field(d)), kept_(solid.blocks()) {}
    std::size_t bytes() const { return u0_.bytes() + v0_.bytes() + kept_.size(); }

    Outcome step(const Solid<d>& solid, Workspace<d>& workspace, State<d>& state, double dt) {
      const double t = state.time;
      std::fill(kept_.begin(), kept_.end(), 0);
      // THEORY (5.5)
      const Arm<d> first = [&](Index i) -> Vec<d> { return at(state.u, i) - dt * at(state.v, i); };
      const Arm<d> second = [&](Index i) -> Vec<d> {
        return at(u0_, i) + dt / 6 * (at(state.v, i) - at(v0_, i));
      };
      const Arm<d> third = [&](Index i) -> Vec<d> {
        return 1.0 / 3 * at(u0_, i) + 2.0 / 3 * (at(state.u, i) + dt * at(state.v, i));
      };
      Outcome outcome = stage(solid, workspace, state, t, dt, 0, 1, first);
      if (outcome) outcome = stage(solid, workspace, state, t + dt, dt, 3.0 / 4, 1.0 / 4, second);
      if (outcome) outcome = stage(solid, workspace, state, t + dt / 2, dt, 1.0 / 3, 2.0 / 3, third);
      if (!outcome) {
        go_back(solid, state);
        return outcome;
      }
      state.time = t + dt;
      ++state.step;
      return outcome;
    }

   private:
    static Vec<d> at(const Field& field, Index i) { return vector_at<d>(field, i); }

    /// U <- kept U^n + fresh (U + dt R(U, t)); the first stage puts U^n aside on the way.
    Outcome stage(const Solid<d>& solid, Workspace<d>& workspace, State<d>& state, double t, double dt,
                  double kept, double fresh, const Arm<d>& arm) {
      const double per_mass = dt / solid.elastic.density;
      return evaluate(
          solid, workspace, state, t,
          [&](const Block& block, BlockForce<d>& force) {
            if (kept == 0) keep(state, block);
            for (int k = 0; k < d; ++k) {
              double* u = state.u[k];
              double* v = state.v[k];
              const double* u0 = u0_[k];
              const double* v0 = v0_[k];
              const double* f = force.at(k, block.begin()) - block.begin();
#pragma omp simd
              for (Index i = block.begin(); i < block.end(); ++i) {
                u[i] = kept * u0[i] + fresh * (u[i] + dt * v[i]);
                v[i] = kept * v0[i] + fresh * (v[i] + per_mass * f[i]);
              }
            }
          },
          arm);
    }

    void keep(const State<d>& state, const Block& block) {
      const Index first = block.begin(), count = block.end() - first;
      for (int k = 0; k < d; ++k) {
        std::copy_n(state.u[k] + first, count, u0_[k] + first);
        std::copy_n(state.v[k] + first, count, v0_[k] + first);
      }
      kept_[first / block_slots] = 1;
    }

    /// Blocks that were not put aside have not been changed.
    void go_back(const Solid<d>& solid, State<d>& state) {
      for (Index b = 0; b < solid.blocks(); ++b) {
        const Index first = solid.block(b).begin(), count = solid.block(b).end() - first;
        for (int k = 0; k < d && kept_[b]; ++k) {
          std::copy_n(u0_[k] + first, count, state.u[k] + first);
          std::copy_n(v0_[k] + first, count, state.v[k] + first);
        }
      }
    }

    Field u0_, v0_;           ///< U^n
    std::vector<char> kept_;  ///< per block: it has been put aside
  };
};

}  // namespace plumb
