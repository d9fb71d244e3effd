#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "verification/plumb/foreign/campaign.hpp"
#include "verification/plumb/foreign/field_errors.hpp"

namespace plumb::app {

/// What a run of another program cost and what came of it.
struct CampaignResult {
  CampaignRun run;
  std::optional<double> wall_s, cpu_s, peak_rss;  ///< [s], [s], [bytes]; none: it was run by somebody else
  bool recalled = false;                          ///< it was finished before
  std::optional<ForeignErrors> errors;
  std::string failure;  ///< why there are no errors
};

/// Writes the files of one run into its folder below `out`.
void prepare_run(const Campaign& campaign, const CampaignRun& run, const std::filesystem::path& out);

/// Makes every run that is not finished, at most `jobs` at a time, the finest first. A run is finished if its
/// folder says so (done.json) for the same files and command. Runs that fail are results too. Ends early,
/// with what is finished kept, when `go_on` says no: throws SittingEnded. `told` hears of every run that
/// ends.
std::vector<CampaignResult> run_campaign(const Campaign& campaign, const std::filesystem::path& out, int jobs,
                                         const std::function<bool()>& go_on,
                                         const std::function<void(const CampaignResult&)>& told);

/// Compares what the runs have left in their folders, whoever ran them.
std::vector<CampaignResult> collect_campaign(const Campaign& campaign, const std::filesystem::path& out);

/// The jobs for others to run: "makefile" (make -j) or "list", a line of shell for each run (xargs -P, GNU
/// parallel, a Slurm array). Written into `out` with the files of all runs; gives the name of the file.
std::string write_jobs(const Campaign& campaign, const std::filesystem::path& out, const std::string& kind);

}  // namespace plumb::app
