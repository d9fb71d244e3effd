#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "lib/scene/scene.hpp"
#include "lib/spectrum/spectrum.hpp"

namespace plumb::app {

/// The numbers of a spectrum under the names of `plumb spectrum --json`. What was not found is null;
/// "at_least" says whether a count is a lower bound. "modes" has the `listed` lowest modes and after them the
/// rigid ones. `time_unit`: d/c_p [s].
nlohmann::ordered_json spectrum_json(const Spectrum& spectrum, const Scene& scene, double time_unit,
                                     int listed);

/// The same for people, with a table of the modes. `s`: what spectrum_json() made.
std::string spectrum_text(const nlohmann::ordered_json& s);

/// The mode that costs least energy and is not rigid: its eigenvalue, the share of it that neighbouring
/// gradients do not explain, and the motion at every particle, largest entry 1: {"value", "unexplained",
/// "spurious", "spacing", "X", "u"}. Null if the body has no such mode.
template <int d>
nlohmann::ordered_json worst_mode(const Spectrum& spectrum, const LinearOperator<d>& op);

/// The modes that spectrum_json() lists, in its order, as particle files for ParaView: modes_000000.vtp, ..
/// and modes.pvd, in which the time of a mode is its number, from 1. The largest component of
/// the displacement is one spacing. The folder must exist. Throws OutputError.
template <int d>
void write_modes(const Spectrum& spectrum, const LinearOperator<d>& op, int listed,
                 const std::filesystem::path& folder);

}  // namespace plumb::app
