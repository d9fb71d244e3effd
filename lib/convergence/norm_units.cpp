#include "lib/convergence/norm_units.hpp"

#include <fmt/format.h>

namespace plumb {
namespace {

constexpr std::string_view gauss_suffix = "_gauss";

/// "m^2", "m^1.5", "m".
std::string metres(double power) {
  return power == 1 ? "m" : fmt::format("m^{:g}", power);
}

}  // namespace

std::string unit_of_norm(std::string_view norm, int dimension) {
  if (norm.ends_with(gauss_suffix)) norm.remove_suffix(gauss_suffix.size());
  const double half = dimension / 2.0;  // power of the root of a volume
  if (norm == "l2") return metres(1 + half);
  if (norm == "h1") return metres(half);
  if (norm == "linf") return metres(1);
  if (norm == "velocity_l2") return metres(1 + half) + "/s";
  if (norm == "stress_l2") return "Pa " + metres(half);
  return {};
}

std::string with_unit(std::string_view norm, int dimension) {
  const std::string unit = unit_of_norm(norm, dimension);
  return unit.empty() ? std::string(norm) : fmt::format("{} [{}]", norm, unit);
}

}  // namespace plumb
