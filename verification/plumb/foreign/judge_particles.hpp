#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "verification/plumb/foreign/field_errors.hpp"
#include "verification/plumb/judged_columns.hpp"

namespace CLI {
class App;
}

namespace plumb::app {
struct Session;

/// Options of `plumb judge --particles`.
struct ParticleOptions {
  std::vector<std::string> files;
  std::vector<double> spacings;  ///< one per file; empty: mean distance of nearest neighbours
  std::string time;              ///< with or without unit
  SolutionOptions solution;
  PointOptions points;
};

void add_particle_options(CLI::App& command, ParticleOptions& options);

/// Levels of one spacing as runs: spacings within a hundredth of each other are one, by the coarsest of them.
std::vector<RunsOfLevel> runs_of_levels(std::vector<std::pair<double, double>> spacing_and_error);

/// Orders of the named norms over the levels. Throws InputError for a norm that a level does not have.
std::vector<JudgedColumn> judged_levels(const std::vector<ForeignErrors>& levels,
                                        const std::vector<std::string>& norms,
                                        const std::vector<double>& expect);

/// {"file", "n", "h", "volume", "estimated_volumes", norms .., "worst", "suspicion"}.
nlohmann::ordered_json json_of(const ForeignErrors& level);

/// Where the error lies, orders inside and at the boundary, and what the error of the finest level looks like
/// if refinement does not lessen it. Empty where the columns pass, lie on one power law, or are too few to
/// say.
std::vector<std::string> causes_of(const std::vector<ForeignErrors>& levels,
                                   const std::vector<JudgedColumn>& columns);

/// The command.
int judge_particles(const Session& session, const ParticleOptions& options, std::vector<std::string> norms,
                    const std::vector<double>& expect);

}  // namespace plumb::app
