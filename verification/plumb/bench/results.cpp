#include "verification/plumb/bench/results.hpp"

#include <cmath>
#include <string>

namespace plumb::app::bench {

Json json_of(const std::map<int, Machine>& machines) {
  const Machine& one = machines.at(1);
  Json all = Json::array();
  for (const auto& [threads, m] : machines)
    all.push_back({{"threads", threads},
                   {"fma_gflops", m.fma_gflops},
                   {"triad_gbs", m.triad_gbs},
                   {"fma_speed_up", m.fma_gflops / one.fma_gflops},
                   {"triad_speed_up", m.triad_gbs / one.triad_gbs}});
  return {{"fma_gflops", one.fma_gflops}, {"triad_gbs", one.triad_gbs}, {"by_threads", all}};
}

Json row_of(const Case& c, const Speed& s, const Machine& machine) {
  return {{"case", c.name},
          {"dimension", c.scene.dimension},
          {"n", s.particles},
          {"threads", s.threads},
          {"updates_per_cpu_s", s.updates_per_cpu_s},
          {"updates_per_wall_s", s.updates_per_wall_s},
          {"setup_cpu_s", s.setup_cpu_s},
          {"setup_wall_s", s.setup_wall_s},
          {"bytes_per_particle", s.bytes_per_particle},
          {"bytes_per_update", s.bytes_per_update},
          {"flops_per_update", s.flops_per_update},
          {"fraction_of_fma", s.updates_per_wall_s * s.flops_per_update / (machine.fma_gflops * 1e9)},
          {"fraction_of_triad", s.updates_per_wall_s * s.bytes_per_update / (machine.triad_gbs * 1e9)}};
}

Json speed_ups_of(const Json& rows) {
  Json result = Json::array();
  for (const auto& row : rows)
    for (const auto& one : rows)
      if (row["threads"] != 1 && one["threads"] == 1 && one["case"] == row["case"] && one["n"] == row["n"])
        result.push_back({{"case", row["case"]},
                          {"n", row["n"]},
                          {"threads", row["threads"]},
                          {"speed_up", row["updates_per_wall_s"].get<double>() /
                                           one["updates_per_wall_s"].get<double>()}});
  return result;
}

double of_an_evaluation(const Json& row) {
  return row["n"].get<double>() / row["updates_per_cpu_s"].get<double>();
}
double of_the_setup(const Json& row) {
  return row["setup_cpu_s"].get<double>();
}

Json exponents_of(const Json& rows, double (*cost)(const Json& row)) {
  struct Sums {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  };
  std::map<std::string, Sums> by_case;
  for (const auto& row : rows) {
    if (row["threads"] != 1) continue;
    auto& s = by_case[row["case"].get<std::string>()];
    const double x = std::log(row["n"].get<double>()), y = std::log(cost(row));
    s.n += 1, s.x += x, s.y += y, s.xx += x * x, s.xy += x * y;
  }
  Json result = Json::object();
  for (const auto& [name, s] : by_case) {
    const double spread = s.n * s.xx - s.x * s.x;
    if (spread > 0) result[name] = (s.n * s.xy - s.x * s.y) / spread;
  }
  return result;
}

}  // namespace plumb::app::bench
