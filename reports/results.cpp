#include "reports/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

namespace plumb::reports {
namespace {

const nlohmann::ordered_json& entry(const nlohmann::ordered_json& object, const std::string& key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  if (found == object.end()) throw MissingResult(fmt::format("a result has no \"{}\"", key));
  return *found;
}

}  // namespace

const std::vector<std::string>& verdict_names() {
  static const std::vector<std::string> names{"pass",           "fail",        "above",
                                              "not-asymptotic", "noise-floor", "too-few-levels",
                                              "inconclusive",   "not-computed"};
  return names;
}

std::string pass_if(bool holds) {
  return holds ? "pass" : "fail";
}

const JobResult& Results::job(const std::string& id) const {
  const auto found = jobs_.find(id);
  if (found == jobs_.end()) throw MissingResult(fmt::format("the job \"{}\" was not run", id));
  return found->second;
}

nlohmann::ordered_json Results::json(const std::string& id) const {
  const JobResult& result = job(id);
  if (!result.failure.empty()) throw MissingResult(fmt::format("\"{}\": {}", result.command, result.failure));
  std::ifstream in(result.folder / "result.json");
  auto json = nlohmann::ordered_json::parse(in, nullptr, false);
  if (json.is_discarded())
    throw MissingResult(fmt::format("the result of \"{}\" cannot be read", result.command));
  return json;
}

std::map<std::string, std::vector<double>> Results::csv(const std::string& id,
                                                        const std::string& file) const {
  const JobResult& result = job(id);
  if (!result.failure.empty()) throw MissingResult(fmt::format("\"{}\": {}", result.command, result.failure));
  std::ifstream in(result.folder / file);
  std::string line, name;
  if (!std::getline(in, line)) throw MissingResult(fmt::format("\"{}\" wrote no {}", result.command, file));
  std::vector<std::string> names;
  for (std::istringstream heading(line); std::getline(heading, name, ',');) names.push_back(name);
  std::map<std::string, std::vector<double>> columns;
  while (std::getline(in, line)) {
    std::istringstream cells(line);
    for (const auto& column : names) {
      std::string cell;
      std::getline(cells, cell, ',');
      char* end = nullptr;
      const double value = std::strtod(cell.c_str(), &end);
      columns[column].push_back(end == cell.c_str() ? std::numeric_limits<double>::quiet_NaN() : value);
    }
  }
  return columns;
}

double number(const nlohmann::ordered_json& object, const std::string& key) {
  const auto& value = entry(object, key);
  return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

std::string text(const nlohmann::ordered_json& object, const std::string& key) {
  const auto& value = entry(object, key);
  return value.is_string() ? value.get<std::string>() : value.dump();
}

const nlohmann::ordered_json& row_at(const nlohmann::ordered_json& rows, const std::string& key,
                                     double value) {
  for (const auto& row : rows)
    if (std::abs(number(row, key) - value) <= 1e-9 * std::abs(value)) return row;
  throw MissingResult(fmt::format("a result has no row with {} = {:g}", key, value));
}

const nlohmann::ordered_json& finest_level(const nlohmann::ordered_json& result) {
  const auto& levels = entry(result, "levels");
  const auto finer = [](const auto& a, const auto& b) { return number(a, "d") < number(b, "d"); };
  const auto found = std::min_element(levels.begin(), levels.end(), finer);
  if (found == levels.end()) throw MissingResult("a study has no levels");
  return *found;
}

Series series_of(const nlohmann::ordered_json& rows, const std::map<std::string, std::string>& where,
                 const std::string& x, const std::string& y, std::string label, Style style) {
  Series series{std::move(label), {}, {}, style};
  for (const auto& row : rows) {
    bool wanted = true;
    for (const auto& [key, value] : where) wanted = wanted && text(row, key) == value;
    if (!wanted) continue;
    series.x.push_back(number(row, x));
    series.y.push_back(number(row, y));
  }
  if (series.x.empty()) throw MissingResult(fmt::format("a result has no rows for \"{}\"", series.label));
  return series;
}

}  // namespace plumb::reports
