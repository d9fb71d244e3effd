#pragma once
#include <string>
#include <vector>

namespace plumb {

/// The words that a scene may use, from the catalogues where there is one.
std::vector<std::string> kernel_names();
std::vector<std::string> pair_names();
/// Estimators fit for a run: all but the plain bond one, which does not converge, and "compatible" (a
/// projected table).
std::vector<std::string> gradient_names();
/// How the table of "compatible" may be made.
std::vector<std::string> compatible_table_names();
/// Estimators whose table can be made compatible.
std::vector<std::string> start_table_names();
/// The forms of the catalogue, and "variational" (the adjoint one, corrected).
std::vector<std::string> momentum_names();
std::vector<std::string> integrator_names();
std::vector<std::string> wave_speed_names();
std::vector<std::string> material_names();
std::vector<std::string> outer_laplacian_names();
std::vector<std::string> shape_names();
std::vector<std::string> layout_names();
std::vector<std::string> boundary_kind_names();
std::vector<std::string> face_names(int dimension);

}  // namespace plumb
