#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "reports/section.hpp"

/// What sections show of the result of `plumb mms`.
namespace plumb::reports {

/// The order in one norm against the declared one, with the study's own verdict; "inconclusive" with the
/// trend in words where the study declares none. A level that failed is named.
Check study_check(std::string what, const nlohmann::ordered_json& result, const std::string& norm);

/// What a study found in one norm. Throws MissingResult if it did not measure it.
const nlohmann::ordered_json& fit_of(const nlohmann::ordered_json& result, const std::string& norm);

/// Whether the study declares an order in that norm.
bool declares(const nlohmann::ordered_json& result, const std::string& norm);

/// A claim that a scheme does not have an order: a check only where the measured interval excludes the order
/// from below (plumb::excludes), and then it passes. A verdict other than "pass" alone excludes nothing.
std::optional<Check> exclusion_check(std::string what, const nlohmann::ordered_json& result,
                                     const std::string& norm, double order);

/// One refinement study of a section: a file of verification/studies with overrides.
struct Refinement {
  std::string id, name, file;
  std::vector<std::string> set;
};

/// The call of `plumb mms` (or another subcommand that takes a study) for it.
Job refinement_job(const Refinement& entry, const std::string& command = "mms");

/// Relative L2 errors of all of them over the spacing, levels that broke left out.
Figure levels_figure(const Results& results, const std::string& id, const std::string& title,
                     const std::vector<Refinement>& entries, const std::string& caption);

/// An empty table of fitted orders, and its rows from one study, one per norm. `figure`: where the study is
/// drawn.
DataTable fits_table(std::string id, std::string title, std::vector<std::string> jobs);
void add_fits(DataTable& table, const std::string& name, const std::string& job,
              const nlohmann::ordered_json& result, const std::string& figure);

/// An empty table of levels (errors and costs), and its rows from one study.
DataTable levels_table(std::string id, std::string title, std::vector<std::string> jobs);
void add_levels(DataTable& table, const std::string& name, const std::string& job,
                const nlohmann::ordered_json& result);

/// The orders of one norm with their intervals and the declared ones, from a table of fits. Orders are cut
/// off at -1 and 5 in the picture, not in its data.
Figure orders_figure(std::string id, std::string title, const DataTable& fits, const std::string& norm);

/// The interval of the fitted order as a band: all power laws with an order in it, through the middle of the
/// levels that were fitted. Nothing is added where the interval says nothing (wider than 2, or not known).
void add_interval(Series& series, const nlohmann::ordered_json& result, const std::string& norm);

}  // namespace plumb::reports
