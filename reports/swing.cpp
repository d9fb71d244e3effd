#include "reports/swing.hpp"

#include <algorithm>
#include <cmath>

#include "reports/results.hpp"

namespace plumb::reports {
namespace {

struct Extreme {
  double time, value;
};

/// Vertex of the parabola through rows k - 1, k, k + 1; the row itself where they lie on a line.
Extreme vertex(const std::vector<double>& time, const std::vector<double>& value, std::size_t k) {
  const double before = value[k - 1], now = value[k], after = value[k + 1], bend = before - 2 * now + after;
  if (bend == 0) return {time[k], now};
  const double shift = (before - after) / (2 * bend);
  return {time[k] + shift * (time[k] - time[k - 1]), now - shift * (before - after) / 4};
}

/// Rows of the lowest value of each stay below the middle that neither starts nor ends the series.
std::vector<std::size_t> low_points(const std::vector<double>& value) {
  const auto [least, most] = std::minmax_element(value.begin(), value.end());
  const double middle = (*least + *most) / 2;
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < value.size();) {
    if (!(value[k] < middle)) {
      ++k;
      continue;
    }
    std::size_t end = k, lowest = k;
    for (; end < value.size() && value[end] < middle; ++end)
      if (value[end] < value[lowest]) lowest = end;
    if (k > 0 && end < value.size()) found.push_back(lowest);
    k = end;
  }
  return found;
}

}  // namespace

Swing last_swing(const std::vector<double>& time, const std::vector<double>& value) {
  const std::vector<std::size_t> low = low_points(value);
  if (low.size() < 2) throw MissingResult("a series has no two low points");
  const std::size_t one = low[low.size() - 2], other = low.back();
  const auto high = std::max_element(value.begin() + static_cast<std::ptrdiff_t>(one),
                                     value.begin() + static_cast<std::ptrdiff_t>(other));
  const Extreme first = vertex(time, value, one), last = vertex(time, value, other),
                top = vertex(time, value, static_cast<std::size_t>(high - value.begin()));
  return {(top.value + last.value) / 2, (top.value - last.value) / 2, 1 / (last.time - first.time)};
}

Swing widest_swing(const std::vector<double>& time, const std::vector<double>& value) {
  const auto [least, most] = std::minmax_element(value.begin(), value.end());
  return {(*most + *least) / 2, (*most - *least) / 2, last_swing(time, value).frequency};
}

}  // namespace plumb::reports
