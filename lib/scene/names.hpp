#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace plumb {

enum class BoundaryKind;

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
std::vector<std::string> paper_names();
std::vector<std::string> scheme_names();
std::vector<std::string> wave_speed_names();
std::vector<std::string> material_names();
std::vector<std::string> plane_names();
std::vector<std::string> shape_names();
std::vector<std::string> cloud_names();
std::vector<std::string> layout_names();
std::vector<std::string> boundary_kind_names();
/// InputError names the nearest valid name.
BoundaryKind boundary_kind_named(std::string_view name);
std::string_view name_of(BoundaryKind kind);
std::vector<std::string> face_names(int dimension);
std::vector<std::string> compatible_volume_names();
std::vector<std::string> compatible_surface_names();

/// A key of a scene that takes one of some names: "method.kernel", what that is for people, and the names.
struct SceneChoice {
  std::string key, meaning;
  std::vector<std::string> names;
};

/// All of them, in the order of a scene; `boundary.0` stands for every boundary.
std::vector<SceneChoice> scene_choices();

}  // namespace plumb
