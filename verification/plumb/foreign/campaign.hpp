#pragma once
#include <optional>
#include <string>
#include <vector>

#include "lib/geometry/layout.hpp"
#include "verification/plumb/foreign/points.hpp"
#include "verification/plumb/foreign/solution_choice.hpp"

namespace plumb::app {

/// A refinement study of another program, as its file says it.
struct Campaign {
  std::string name, file, here;  ///< here: the folder of the file
  SolutionChoice solution;
  double time = 0;               ///< [s] of the results
  std::vector<double> spacings;  ///< [m], from coarse to fine
  int runs = 1;                  ///< clouds of each spacing
  Layout layout = Layout::node;
  double jitter = 0;                 ///< of the clouds, in spacings
  std::optional<double> cfl;         ///< dt is at most cfl times the spacing over the speed of pressure waves
  std::optional<double> step;        ///< at most that [s]; neither of both: there are no steps
  std::string command;               ///< of a shell, with placeholders; run in the folder of each run
  std::string prepare;               ///< another one before it, not timed; empty: none
  std::string template_file, input;  ///< the input with placeholders, and what it is called in the folder
  std::vector<std::string> clouds;   ///< files to write: .csv, .vtp, .data (LAMMPS)
  std::string loads;   ///< a table of the solution at the cloud's points and `time`; empty: none
  std::string result;  ///< file that the program writes
  PointOptions points;
  std::vector<std::string> norms;  ///< that are judged: "l2"
  std::vector<double> expect;      ///< one order for all of them or one each
  std::string reason;
};

/// Reads a campaign: [campaign], [parameters] of the solution, [material] as in scenes, [expect] norm =
/// order, reason. Throws InputError with the place.
Campaign read_campaign(const std::string& path, const std::vector<std::string>& overrides);

/// One run of a campaign.
struct CampaignRun {
  std::size_t level = 0;  ///< from 0
  int number = 1;         ///< of the level, from 1
  double spacing = 0;     ///< [m]
  int steps = 0;          ///< 0: there are none
  double step = 0;        ///< [s]
  std::string folder;     ///< "h_0.1" or "h_0.1_run_2"
};

/// All runs from coarse to fine.
std::vector<CampaignRun> runs_of(const Campaign& campaign);

/// The text with @name@ replaced by what it stands for in that run: h, n (cells along the shortest edge of
/// the domain), level, run, time, dt, steps, cloud, loads, input, result, here, young, poisson, density and
/// the parameters of solution and law. Throws InputError for a name that is none of them.
std::string filled(const std::string& text, const Campaign& campaign, const CampaignRun& run,
                   const std::string& where);

/// The files of one run by name: input, clouds, loads.
std::vector<std::pair<std::string, std::string>> files_of(const Campaign& campaign, const CampaignRun& run);

}  // namespace plumb::app
