#include "lib/convergence/status.hpp"

#include <algorithm>

namespace plumb {

std::string_view status_of(const std::vector<Judged>& all) {
  std::vector<std::string_view> declared, other;
  for (const Judged& one : all) (one.declared ? declared : other).push_back(one.verdict);
  const auto any = [](const std::vector<std::string_view>& words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  if (!declared.empty()) {
    if (any(declared, "fail") || any(declared, "not-computed")) return "fail";
    const bool all_pass =
        std::all_of(declared.begin(), declared.end(), [](std::string_view word) { return word == "pass"; });
    return all_pass ? "pass" : "inconclusive";
  }
  if (any(other, "divergent")) return "divergent";
  return any(other, "too-few-levels") ? "too-few-levels" : "undeclared";
}

int exit_code_of(std::string_view status) {
  return status == "pass" || status == "undeclared" ? 0 : 1;
}

}  // namespace plumb
