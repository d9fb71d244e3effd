#pragma once
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "lib/scene/read_scene.hpp"
#include "lib/scene/simulation.hpp"

/// Blocks and bars for the tests of what acts from outside on the schemes mixed, updated, eulerian and element.
namespace plumb::testing {

/// A block of 1000 kg/m^d with sides of 0.5 m, in 2D of 0.5 m by 1 m.
inline std::string block(int d, const std::string& scheme, const std::string& more) {
  const char* size = d == 1 ? "[0.5]" : d == 2 ? "[0.5, 1]" : "[0.5, 0.5, 0.5]";
  return fmt::format(R"([scene]
dimension = {}
end_time = "20 ms"
[body]
size = {}
spacing = 0.125
layout = "node"
[material]
young = "1 MPa"
poisson = 0.3
density = 1000
[method]
scheme = "{}"
)",
                     d, size, scheme) +
         more;
}

inline constexpr double volume(int d) {
  return d == 3 ? 0.125 : 0.5;
}

template <int d>
struct Ended {
  Simulation<d> simulation;
  RunRecord record;
  RunResult result;
  double before;  ///< energy at the start [J]

  std::map<std::string, double> works() const {
    std::map<std::string, double> all;
    for (const auto& [name, done] : simulation.external_work()) all[name] = done;
    return all;
  }
  double change() { return simulation.energy().total() - before; }
};

template <int d>
Ended<d> run_of(const std::string& text) {
  Ended<d> ended{make_simulation<d>(parse_scene(text, "test.toml")).simulation, {}, {}, 0};
  ended.before = ended.simulation.energy().total();
  ended.result = run<d>(ended.simulation, {}, ended.record);
  EXPECT_TRUE(ended.result.completed()) << text;
  return ended;
}

inline const std::vector<std::string> schemes = {"mixed", "updated", "eulerian", "element"};

/// g per component along x, nothing along the others.
inline std::string along_x(int d, const std::string& x) {
  return "[\"" + x + "\"" + (d > 1 ? ", 0" : "") + (d > 2 ? ", 0" : "") + "]";
}

}  // namespace plumb::testing
