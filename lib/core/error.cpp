#include "lib/core/error.hpp"

#include <algorithm>
#include <numeric>

namespace plumb {
namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest_name(std::string_view name, const std::vector<std::string>& names) {
  std::string best;
  std::size_t least = std::max<std::size_t>(2, name.size() / 2) + 1;
  for (const auto& candidate : names) {
    const std::size_t distance = edit_distance(name, candidate);
    if (distance < least) {
      least = distance;
      best = candidate;
    }
  }
  return best;
}

std::string join(const std::vector<std::string>& names, std::string_view separator) {
  std::string all;
  for (const auto& name : names) all += (all.empty() ? "" : std::string(separator)) + name;
  return all;
}

InputError unknown_name(std::string_view what, std::string_view name, const std::vector<std::string>& valid) {
  const std::string near = nearest_name(name, valid);
  return InputError("unknown " + std::string(what) + " \"" + std::string(name) + "\"",
                    "valid: " + join(valid), near.empty() ? "" : "did you mean \"" + near + "\"?");
}

}  // namespace plumb
