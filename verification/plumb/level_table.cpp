#include "verification/plumb/level_table.hpp"

#include <cmath>
#include <functional>
#include <map>

namespace plumb::app {

double RunsOfLevel::mean() const {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double RunsOfLevel::typical() const {
  double sum = 0;
  for (const double value : values) sum += std::log(std::abs(value));
  return std::copysign(std::exp(sum / static_cast<double>(values.size())), mean());
}

std::optional<double> RunsOfLevel::spread() const {
  if (values.size() < 2) return std::nullopt;
  const double middle = mean();
  double sum = 0;
  for (const double value : values) sum += (value - middle) * (value - middle);
  return std::sqrt(sum / static_cast<double>(values.size() - 1)) / std::abs(middle);
}

std::vector<RunsOfLevel> runs_of(const NumberTable& table, std::size_t spacing, std::size_t value) {
  std::map<double, std::vector<double>, std::greater<>> levels;
  for (const auto& row : table.rows) levels[row[spacing]].push_back(row[value]);
  std::vector<RunsOfLevel> runs;
  runs.reserve(levels.size());
  for (auto& [h, values] : levels) runs.push_back({h, std::move(values)});
  return runs;
}

}  // namespace plumb::app
