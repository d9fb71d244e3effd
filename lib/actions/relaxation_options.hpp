#pragma once
#include <optional>

namespace plumb {

class Section;

/// Chooses that a run ends when the body is at rest: dynamic relaxation, THEORY (5.10). It is the section
/// [relaxation] of a scene; without the section a run ends at its time.
struct RelaxationOptions {
  /// Norm of the forces on particles that move freely, relative to the larger one of the norms of the loads
  /// and of the forces of supports. Of a force that is found from differences of displacements rounding
  /// leaves some 1e-12.
  double residual = 1e-8;
};

/// Reads [relaxation]; nullopt without that section. Throws SceneError.
std::optional<RelaxationOptions> read_relaxation(const Section& root);

}  // namespace plumb
