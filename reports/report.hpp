#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "reports/section.hpp"

namespace plumb::reports {

/// What `plumb report` needs to know.
struct ReportOptions {
  std::filesystem::path out = "reports/out";  ///< folder of the report
  std::filesystem::path program;              ///< the plumb executable that runs the studies
  std::string code = {};             ///< hash of the code that computes; empty: the bytes of the program
  std::filesystem::path root = ".";  ///< the folder with verification/scenes in it
  Extent extent = Extent::core;      ///< how much is computed
  int threads = 0;                   ///< cores to work on, a study on each; 0: all there are
  std::vector<std::string> only;     ///< ids of sections; empty: all
  std::vector<std::pair<std::string, std::string>> facts;         ///< on the first screen, before the cost
  std::function<void(double, const std::string&)> progress = {};  ///< fraction done, what is being done
  std::function<bool()> go_on = {};                               ///< asked after every study; none: always
};

/// One check of a section.
struct SectionCheck {
  std::string section;
  Check check;
};

struct ReportSummary {
  std::filesystem::path page;  ///< index.html
  std::vector<SectionCheck> checks;
  std::vector<std::pair<std::string, std::size_t>> verdicts;
  std::vector<std::string> problems;  ///< sections that could not be written, and why
  std::size_t jobs = 0, reused = 0;
  double cpu_s = 0;  ///< of the studies, fresh and reused
};

/// Lists all sections in the order of the page, with the jobs of that extent; those that are left to larger reports, too.
std::vector<SectionPlan> section_plans(Extent extent);

/// Runs the studies, or takes their stored results, and writes the page, the pictures and the numbers behind
/// them. A study that fails costs its section the answer, not the report; it is listed under `problems`.
/// @throws InputError for an unknown section or a folder that cannot be made; OutputError if a file cannot be
/// written; SittingEnded if it is not to go on: the finished studies are stored, and the next call takes
/// them.
ReportSummary make_report(const ReportOptions& options);

}  // namespace plumb::reports
