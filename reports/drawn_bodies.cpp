#include "reports/drawn_bodies.hpp"

#include <fmt/format.h>

#include <utility>

namespace plumb::reports {
namespace {

constexpr View plane{'x', 'y', 'z'};
constexpr View lying{'z', 'y', 'x'};  ///< columns, which stand along z

void add_spins(std::vector<DrawnBody>& all) {
  for (const int n : {50, 100, 200})
    for (const double end : {0.2, 2.0})
      all.push_back({fmt::format("spin-{}-{:g}", n, 10 * end),
                     fmt::format("Spinning plate, {0} × {0}, {1} s", n, end),
                     "spinning-plate",
                     {fmt::format("body.particles=[{0},{0}]", n), fmt::format("scene.end_time={}", end)},
                     plane,
                     1.0 / n,
                     Compared::angular_momentum});
  // With the paper's scheme the step collapses from 0.7 s on (claims ledger, 5.2-cube-smooth); the adjoint
  // form without dissipation does so at 1.24 s.
  const std::vector<std::pair<std::string, std::vector<std::string>>> cubes{
      {"symmetrised", {"scene.end_time=0.7"}},
      {"adjoint",
       {"scene.end_time=2", "method.momentum=adjoint", "method.integrator=verlet", "method.cfl=0.4"}}};
  for (const auto& [scheme, set] : cubes) {
    DrawnBody body{"cube-50-" + scheme,
                   fmt::format("Spinning cube, 50³, {}",
                               scheme == "adjoint" ? "adjoint, Verlet, 2 s" : "the paper's scheme, 0.7 s"),
                   "spinning-cube",
                   set,
                   plane,
                   0.02,
                   Compared::angular_momentum};
    body.set.emplace_back("body.particles=[50,50,50]");
    all.push_back(std::move(body));
  }
}

void add_bending_columns(std::vector<DrawnBody>& all) {
  for (const int n : {10, 20})
    for (const char* momentum : {"symmetrised", "adjoint"})
      all.push_back({fmt::format("column-{}-{}", n, momentum),
                     fmt::format("Bending column, {0} × {0} × {1}, {2}, 0.5 s", n, 6 * n, momentum),
                     "bending-column",
                     {fmt::format("body.particles=[{0},{0},{1}]", n, 6 * n),
                      fmt::format("method.momentum={}", momentum)},
                     lying,
                     1.0 / n,
                     Compared::start_energy});
}

/// The scene at half its step (cell layout, symmetrised), and the one reading in which the published
/// stretches appear.
void add_pulling_columns(std::vector<DrawnBody>& all) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> readings{
      {"cell", {"method.cfl=0.5"}},
      {"node",
       {"body.layout=node", "body.particles=[13,13,73]", "method.pair=W0", "method.momentum=adjoint",
        "method.cfl=0.5", "jst.eta4=0"}}};
  for (const char* nu : {"45", "495"})
    for (const char* gradient : {"standard", "improved"})
      for (const auto& [reading, set] : readings) {
        DrawnBody body{fmt::format("pulling-{}-{}-{}", nu, gradient, reading),
                       fmt::format("Pulling column, 12 × 12 × 72, ν = 0.{}, {} F, {}", nu, gradient,
                                   reading == "cell" ? "cells, symmetrised" : "nodes, W0, adjoint, no JST"),
                       fmt::format("pulling-column-nu-{}", nu),
                       set,
                       lying,
                       0.083,
                       Compared::length};
        body.set.push_back(fmt::format("method.gradient={}", gradient));
        all.push_back(std::move(body));
      }
}

void add_twisting_columns(std::vector<DrawnBody>& all) {
  for (const char* alpha : {"0.1", "0.4", "0.9"})
    all.push_back({fmt::format("twisting-105-{}", alpha[2]),
                   fmt::format("Twisting column, 105 rad/s, 7 × 7 × 42, α = {}, 0.25 s", alpha),
                   "twisting-column-105",
                   {fmt::format("method.cfl={}", alpha)},
                   lying,
                   0.143,
                   Compared::start_energy});
  all.push_back({"twisting-300",
                 "Twisting column, 300 rad/s, 11 × 11 × 66, 92.1 ms",
                 "twisting-column-300",
                 {},
                 lying,
                 0.09,
                 Compared::start_energy});
  all.push_back({"twisting-400",
                 "Twisting column, 400 rad/s, 12 × 12 × 72, 0.1 s",
                 "twisting-column-400",
                 {"jst.laplacian_factor=1"},
                 lying,
                 0.083,
                 Compared::start_energy});
}

}  // namespace

std::vector<DrawnBody> reduced_bodies() {
  return {{"spin",
           "Spinning plate, 50 × 50, 0.2 s",
           "spinning-plate",
           {},
           plane,
           0.02,
           Compared::angular_momentum},
          {"column",
           "Bending column, 5 × 5 × 30, adjoint, 0.45 s",
           "bending-column",
           {"method.momentum=adjoint", "scene.end_time=0.45"},
           lying,
           0.2,
           Compared::corner,
           true},
          {"pulling",
           "Pulling column, nodes of 6 × 6 × 36 cells, W0, 1.2 s",
           "pulling-column-nu-45",
           {"body.layout=node", "body.particles=[7,7,37]", "method.pair=W0", "method.cfl=0.5",
            "scene.end_time=1.2"},
           lying,
           1.0 / 6,
           Compared::stress},
          {"twisting",
           "Twisting column, 105 rad/s, 7 × 7 × 42, 0.1 s",
           "twisting-column-105",
           {"method.cfl=0.4", "scene.end_time=0.1"},
           lying,
           0.143,
           Compared::rotation,
           true}};
}

std::vector<DrawnBody> paper_size_bodies() {
  std::vector<DrawnBody> all;
  add_spins(all);
  add_bending_columns(all);
  add_pulling_columns(all);
  add_twisting_columns(all);
  all.push_back({"oscillating-20",
                 "Oscillating plate of paper 001, 20 cells across, 2.5 s",
                 "oscillating-plate",
                 {"body.spacing=0.001", "scene.end_time=2.5"},
                 plane,
                 0.001,
                 Compared::period});
  return all;
}

}  // namespace plumb::reports
