#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "lib/convergence/order_fit.hpp"
#include "reports/picture.hpp"
#include "verification/plumb/level_table.hpp"

namespace plumb::app {
struct Session;

/// Errors of one name on several levels, with their order and its verdict.
struct JudgedColumn {
  std::string name;
  std::vector<RunsOfLevel> runs;  ///< from coarse to fine
  OrderFit fit;                   ///< of the runs' typical errors
  std::optional<double> declared;
  std::string verdict;
};

/// Fits and judges. Nothing is taken for round-off, since the size of what was computed is not known.
JudgedColumn judged_column(const std::string& name, std::vector<RunsOfLevel> runs,
                           std::optional<double> declared);

/// The declared order of each of `count` columns: none, one for all, or one each. Throws InputError for other
/// numbers.
std::vector<std::optional<double>> declared_orders(const std::vector<double>& expect, std::size_t count);

/// The status of all of them: outcome.hpp.
std::string status_of(const std::vector<JudgedColumn>& columns);

/// {"norm", "order", "ci95", "pairwise", "drift", "levels", "declared", "verdict", "rows": [{"h", "error",
/// "runs", "spread"}]} of each.
nlohmann::ordered_json fits_json(const std::vector<JudgedColumn>& columns);

/// Says orders and verdicts, and the spread of levels with several runs.
void tell_columns(const Session& session, const std::vector<JudgedColumn>& columns);

/// Draws them for --plot, if asked for.
void draw_columns(const Session& session, const std::string& title, const std::vector<JudgedColumn>& columns);

}  // namespace plumb::app
