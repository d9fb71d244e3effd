#pragma once
#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "reports/section.hpp"

namespace plumb::reports {

/// A result that a section needs is not there: its job failed, or it lacks the entry asked for.
class MissingResult : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What became of one job.
struct JobResult {
  std::string command;           ///< as a user would type it, in the root folder
  std::filesystem::path folder;  ///< result.json, messages.txt, and what the job wrote to {out}
  int exit_code = 0;
  std::string failure;  ///< why there is no result; empty if there is one
  double wall_s = 0, cpu_s = 0;
  std::optional<double> peak_rss = {};  ///< largest memory [bytes]; older stores do not have it
  bool reused = false;
};

/// The results of all jobs, by the id of the job.
class Results {
 public:
  void add(const std::string& id, JobResult result) { jobs_[id] = std::move(result); }
  /// @throws MissingResult for an unknown id.
  const JobResult& job(const std::string& id) const;
  /// Its JSON. @throws MissingResult if the job failed or its result cannot be read.
  nlohmann::ordered_json json(const std::string& id) const;
  /// Columns of a CSV file that the job wrote below {out}, by name; entries that are no numbers are NaN.
  /// @throws MissingResult if the file is not there.
  std::map<std::string, std::vector<double>> csv(const std::string& id, const std::string& file) const;

 private:
  std::map<std::string, JobResult> jobs_;
};

/// A number of a JSON object; NaN where it is null. @throws MissingResult if the key is not there.
double number(const nlohmann::ordered_json& object, const std::string& key);
/// A text of a JSON object. @throws MissingResult if the key is not there.
std::string text(const nlohmann::ordered_json& object, const std::string& key);
/// The row whose `key` has that value, to round-off. @throws MissingResult if there is none.
const nlohmann::ordered_json& row_at(const nlohmann::ordered_json& rows, const std::string& key,
                                     double value);
/// The level of a refinement study with the least spacing d. @throws MissingResult if it has none.
const nlohmann::ordered_json& finest_level(const nlohmann::ordered_json& result);
/// All x and y of the rows for which every key of `where` has the given text, as a series.
Series series_of(const nlohmann::ordered_json& rows, const std::map<std::string, std::string>& where,
                 const std::string& x, const std::string& y, std::string label, Style style = Style::both);

}  // namespace plumb::reports
