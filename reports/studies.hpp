#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "reports/section.hpp"

/// What sections show of the result of `plumb mms`.
namespace plumb::reports {

/// The order in one norm against the declared one, with the study's own verdict; "inconclusive" with the
/// trend in words where the study declares none. A level that failed is named.
Check study_check(std::string what, const nlohmann::ordered_json& result, const std::string& norm);

/// An empty table of fitted orders, and its rows from one study, one per norm. `figure`: where the study is
/// drawn.
DataTable fits_table(std::string id, std::string title, std::vector<std::string> jobs);
void add_fits(DataTable& table, const std::string& name, const std::string& job,
              const nlohmann::ordered_json& result, const std::string& figure);

/// An empty table of levels (errors and costs), and its rows from one study.
DataTable levels_table(std::string id, std::string title, std::vector<std::string> jobs);
void add_levels(DataTable& table, const std::string& name, const std::string& job,
                const nlohmann::ordered_json& result);

}  // namespace plumb::reports
