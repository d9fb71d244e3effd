#include <algorithm>
#include <cmath>
#include <utility>

#include "reports/plot/prepare.hpp"

namespace plumb::reports::plot {

double Range::fraction(double value) const {
  return log ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
}

double Range::value(double fraction) const {
  return log ? low * std::pow(high / low, fraction) : low + (high - low) * fraction;
}

std::vector<double> cell_borders(const std::vector<double>& grid, bool log) {
  const auto forth = [log](double v) { return log ? std::log(v) : v; };
  const auto back = [log](double v) { return log ? std::exp(v) : v; };
  if (grid.size() == 1) return {log ? grid[0] / 2 : grid[0] - 0.5, log ? grid[0] * 2 : grid[0] + 0.5};
  std::vector<double> borders;
  for (std::size_t i = 0; i <= grid.size(); ++i) {
    const std::size_t right = std::clamp<std::size_t>(i, 1, grid.size() - 1);
    const double a = forth(grid[right - 1]), b = forth(grid[right]);
    borders.push_back(back(i == 0 ? a - (b - a) / 2 : i == grid.size() ? b + (b - a) / 2 : (a + b) / 2));
  }
  return borders;
}

std::size_t letters(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::vector<std::string> wrap(const std::string& text, std::size_t width) {
  std::vector<std::string> lines;
  std::string line;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t to = std::min(text.find(' ', from), text.size());
    const std::string word = text.substr(from, to - from);
    from = to + 1;
    if (!line.empty() && letters(line) + 1 + letters(word) > width) lines.push_back(std::exchange(line, ""));
    line += (line.empty() ? "" : " ") + word;
  }
  if (!line.empty()) lines.push_back(line);
  return lines;
}

}  // namespace plumb::reports::plot
