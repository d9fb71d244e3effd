#pragma once
#include <stdexcept>
#include <string>
#include <vector>

#include "lib/particles/snapshot.hpp"

/// For tests of bodies that flow.
namespace plumb::testing {

/// [material] of a copper that hardens.
inline const std::string copper = R"(
[material]
model = "j2-logarithmic"
young = "117 GPa"
poisson = 0.35
density = 8930
yield = "0.4 GPa"
hardening = "0.1 GPa"
)";

/// The number of that name that a scheme shows of every particle.
template <int d>
const std::vector<double>& shown(const Snapshot<d>& snapshot, const std::string& name) {
  for (const NamedValues& more : snapshot.more)
    if (more.name == name) return more.values;
  throw std::runtime_error("nothing shown is called " + name);
}

}  // namespace plumb::testing
