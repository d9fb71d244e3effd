#pragma once
#include <memory>
#include <optional>
#include <string>

#include "lib/scene/scene.hpp"
#include "lib/schemes/tlsph/compatible/compatible.hpp"

namespace plumb {

/// Why the table of gradient = "compatible" is projected, as the end of a sentence that begins with
/// "because"; nullopt if it is the closed form of lattices. Throws InputError if [compatible] table asks for
/// the closed form where there is none.
template <int d>
std::optional<std::string> reason_to_project(const Scene& scene, const Cloud<d>& cloud);

/// Whether the table of the scene's method is made with the surface of the body.
template <int d>
bool needs_surface(const Scene& scene, const Cloud<d>& cloud);

/// Lets the options make the scene's compatible table; the report is complete when that is made. `surface` is
/// not used by the closed form.
template <int d>
std::shared_ptr<CompatibleReport> make_it_compatible(BondOptions<d>& options, const Scene& scene,
                                                     const Cloud<d>& cloud,
                                                     const std::optional<Surface<d>>& surface);

}  // namespace plumb
