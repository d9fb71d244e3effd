#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "plumb/bench/cases.hpp"
#include "plumb/bench/machine.hpp"
#include "plumb/commands.hpp"
#include "plumb/run/sittings.hpp"
#include "plumb/session.hpp"
#include "plumbline/core/error.hpp"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

struct BenchCommand {
  std::vector<std::string> only;
  std::vector<long> sizes{1000, 8000, 64000};
  std::vector<int> threads{1};
  int repeats = 3;
  double seconds = 0.2;
  SittingOptions sitting;
};

std::vector<bench::Case> chosen(const BenchCommand& command) {
  std::vector<std::string> names;
  for (const auto& c : bench::cases()) names.push_back(c.name);
  if (command.only.empty()) return bench::cases();
  std::vector<bench::Case> result;
  for (const auto& wanted : command.only) {
    const auto at = std::find(names.begin(), names.end(), wanted);
    if (at == names.end()) throw unknown_name("case", wanted, names);
    result.push_back(bench::cases()[at - names.begin()]);
  }
  return result;
}

Json row_of(const bench::Case& c, const bench::Speed& s, const bench::Machine& machine) {
  return {{"case", c.name},
          {"dimension", c.scene.dimension},
          {"n", s.particles},
          {"threads", s.threads},
          {"updates_per_cpu_s", s.updates_per_cpu_s},
          {"updates_per_wall_s", s.updates_per_wall_s},
          {"setup_cpu_s", s.setup_cpu_s},
          {"bytes_per_particle", s.bytes_per_particle},
          {"fraction_of_fma", s.updates_per_cpu_s * s.flops_per_update / (machine.fma_gflops * 1e9)},
          {"fraction_of_triad", s.updates_per_cpu_s * s.bytes_per_particle / (machine.triad_gbs * 1e9)}};
}

/// Slope of log(CPU time per step) over log(N), by case, where there are two sizes or more on one thread.
Json exponents_of(const Json& rows) {
  struct Sums {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  };
  std::map<std::string, Sums> by_case;
  for (const auto& row : rows) {
    if (row["threads"] != 1) continue;
    auto& s = by_case[row["case"].get<std::string>()];
    const double x = std::log(row["n"].get<double>());
    const double y = x - std::log(row["updates_per_cpu_s"].get<double>());
    s.n += 1, s.x += x, s.y += y, s.xx += x * x, s.xy += x * y;
  }
  Json result = Json::object();
  for (const auto& [name, s] : by_case) {
    const double spread = s.n * s.xx - s.x * s.x;
    if (spread > 0) result[name] = (s.n * s.xy - s.x * s.y) / spread;
  }
  return result;
}

/// Every case at every size on every number of threads: each is a part of the sitting.
Json measure_all(const Session& session, const BenchCommand& command, const bench::Machine& machine,
                 Sitting& sitting) {
  const auto all = chosen(command);
  Json rows = Json::array();
  Progress progress("bench", session.progress());
  const auto runs = static_cast<double>(all.size() * command.sizes.size() * command.threads.size());
  for (const auto& c : all)
    for (const long n : command.sizes)
      for (const int threads : command.threads) {
        rows.push_back(sitting.part(fmt::format("{}, {} particles, {} threads", c.name, n, threads), [&] {
          return row_of(c, bench::measure(c, n, threads, command.repeats, command.seconds), machine);
        }));
        progress.update(static_cast<double>(rows.size()) / runs);
      }
  return rows;
}

int run_bench(const Session& session, const BenchCommand& command) {
  chosen(command);  // a name that is not known is told before the machine is measured
  const bench::Machine machine = bench::measure_machine();
  const Json rows = in_one_sitting(
      session, command.sitting, {}, {fmt::format("bench {} {}", command.repeats, command.seconds)},
      [&](Sitting& sitting) { return measure_all(session, command, machine, sitting); });
  session.text() << "one core: " << machine.fma_gflops << " GFLOP/s in fused multiply-adds, "
                 << machine.triad_gbs << " GB/s in the triad\n";
  session.write_table(rows);
  session.write_json({{"machine", {{"fma_gflops", machine.fma_gflops}, {"triad_gbs", machine.triad_gbs}}},
                      {"rows", rows},
                      {"exponents", exponents_of(rows)}});
  return 0;
}

}  // namespace

/// `plumb bench`: speed of whole runs, beside the limits of the machine measured in the same call.
void add_bench(CLI::App& program, Session& session) {
  const auto options = std::make_shared<BenchCommand>();
  CLI::App& command =
      add_command(program, session,
                  {"bench", "particle updates per second of whole runs, beside the machine's limits",
                   "plumb bench --case adjoint-verlet-3d --n 1000,8000 --seconds 0.05"},
                  {.table = true}, [&session, options] { return run_bench(session, *options); });
  command.add_option("--case", options->only, "cases to run (all of them)")
      ->delimiter(',')
      ->type_name("NAME,..");
  command.add_option("--n", options->sizes, "numbers of particles, about")
      ->delimiter(',')
      ->check(CLI::Range(27L, 100000000L))
      ->capture_default_str();
  command.add_option("--cores", options->threads, "numbers of threads")
      ->delimiter(',')
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command.add_option("--repeats", options->repeats, "repeats; the best one counts")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command.add_option("--seconds", options->seconds, "CPU seconds per repeat, about")
      ->check(CLI::Range(0.001, 1000.0))
      ->capture_default_str();
  add_sitting_options(command, options->sitting);
}

}  // namespace plumb
