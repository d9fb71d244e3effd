#pragma once

namespace plumb {

/// How the system of THEORY (11.5) is solved. Direct: CHOLMOD's factors of the normal matrix. Iterative:
/// conjugate gradients with a V-cycle, for time and memory that grow as the number of particles does.
enum class ProjectionSolver { automatic, direct, iterative };

}  // namespace plumb
