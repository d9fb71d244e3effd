#pragma once
#include <optional>
#include <string>
#include <vector>

#include "lib/schemes/tlsph/compatible/compatible.hpp"
#include "mms/study.hpp"

namespace plumb::mms {

/// What the projection of a table left over.
struct ProjectionDefects {
  double divergence_defect;  ///< CompatibleReport::divergence_defect
  double residual;           ///< CompatibleReport::residual

  template <class Self, class Visit>
  static void members(Self& self, Visit&& visit) {
    visit("divergence_defect", self.divergence_defect);
    visit("residual", self.residual);
  }
};

/// One level of a static study.
struct StaticLevel {
  Index n = 0;         ///< particles
  double spacing = 0;  ///< [m]
  ErrorNorms error;    ///< nodal norms of the error, absolute; no velocity
  ErrorNorms exact;    ///< the same norms of the exact field
  /// omega_h/omega - 1 of the body's vibration in the shape of the solution; only if the solution needs no
  /// body force, so that it is a vibration.
  std::optional<double> frequency_error;
  std::optional<ProjectionDefects> projection;  ///< nothing without one
  std::optional<std::string> failure;           ///< why there is no frequency where there should be one
  double setup_s = 0;                           ///< CPU time of the bond table [s]
  double solve_s = 0;                           ///< CPU time of assembly and solution [s]

  template <class Self, class Visit>
  static void members(Self& self, Visit&& visit) {
    visit("n", self.n);
    visit("d", self.spacing);
    visit("error", self.error);
    visit("exact", self.exact);
    visit("failure", self.failure);
    visit("frequency_error", self.frequency_error);
    visit("projection", self.projection);
    visit("setup_s", self.setup_s);
    visit("solve_s", self.solve_s);
  }

  /// Error over size in one norm.
  double relative(double ErrorNorms::*norm) const { return error.*norm / (exact.*norm); }
};

/// The norms of a static study: those of norm_names but the velocity's.
std::vector<NormName> static_norms();

/// Holds the errors of all levels, with their orders.
struct StaticResult {
  std::vector<StaticLevel> levels;
  std::vector<StudyFit>
      fits;            ///< of the relative errors in static_norms() and, if there is one, of the frequency
  std::string status;  ///< as in StudyResult
};

/// The displacement of the solution at the study's end time as an equilibrium: exact displacements on the
/// whole surface of the box, or, of a solution at rest, its tractions where it has them; -Div P inside, one linear solution with the stiffness assembled from the bond
/// table. Scheme "implicit" makes it an equilibrium of finite strains, by Newton's method (THEORY (15.2)), at any amplitude, on the whole surface also of
/// curved bodies and of solutions at rest, and there is no vibration. And the vibration next to the solution's, with the solution's own conditions on the faces. Linear,
/// so the amplitude should be small: it is the relative modelling error. Node layout only; throws InputError
/// otherwise. Expect::l2, h1 and stress_l2 are the declared orders. Each level is a part of the sitting;
/// throws SittingEnded if that ends, after the level at hand.
StaticResult run_static_study(const Study& study, const StudyProgress& progress, Sitting& sitting);
/// Runs the study in one sitting.
inline StaticResult run_static_study(const Study& study, const StudyProgress& progress = {}) {
  Sitting whole;
  return run_static_study(study, progress, whole);
}

}  // namespace plumb::mms
