#include <CLI/CLI.hpp>
#include <cmath>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "plumb/bench/cases.hpp"
#include "plumb/bench/kernels.hpp"
#include "plumb/bench/machine.hpp"
#include "plumb/commands.hpp"
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
  bool all = false, full = false, kernels = false;
};

std::vector<bench::Case> chosen(const BenchCommand& command) {
  std::vector<bench::Case> result;
  if (command.only.empty()) {
    for (const auto& c : bench::cases())
      if (c.main || command.all) result.push_back(c);
    return result;
  }
  std::vector<std::string> names;
  for (const auto& c : bench::cases()) names.push_back(c.name);
  for (const auto& wanted : command.only) {
    const auto at = std::find(names.begin(), names.end(), wanted);
    if (at == names.end()) throw unknown_name("case", wanted, names);
    result.push_back(bench::cases()[at - names.begin()]);
  }
  return result;
}

/// Limits by number of threads; that of one core is always there.
std::map<int, bench::Machine> machines_of(const BenchCommand& command) {
  std::map<int, bench::Machine> machines{{1, bench::measure_machine(1)}};
  for (const int threads : command.threads)
    if (!machines.count(threads)) machines[threads] = bench::measure_machine(threads);
  return machines;
}

Json json_of(const std::map<int, bench::Machine>& machines) {
  const bench::Machine& one = machines.at(1);
  Json all = Json::array();
  for (const auto& [threads, m] : machines)
    all.push_back({{"threads", threads},
                   {"fma_gflops", m.fma_gflops},
                   {"triad_gbs", m.triad_gbs},
                   {"fma_speed_up", m.fma_gflops / one.fma_gflops},
                   {"triad_speed_up", m.triad_gbs / one.triad_gbs}});
  return {{"fma_gflops", one.fma_gflops}, {"triad_gbs", one.triad_gbs}, {"by_threads", all}};
}

/// Shares of what as many cores can do, both in wall time.
Json row_of(const bench::Case& c, const bench::Speed& s, const bench::Machine& machine) {
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

/// Wall time on one thread over that on more, for every case and size that was run on both.
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

/// CPU time of one evaluation for all particles [s].
double of_an_evaluation(const Json& row) {
  return row["n"].get<double>() / row["updates_per_cpu_s"].get<double>();
}
double of_the_setup(const Json& row) {
  return row["setup_cpu_s"].get<double>();
}

/// Slope of log(cost) over log(N), by case, where there are two sizes or more on one thread.
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

int run_kernels(const Session& session, const BenchCommand& command) {
  Json rows = Json::array();
  for (const auto& k : bench::measure_kernels(command.sizes.front(), command.seconds))
    rows.push_back({{"kernel", k.kernel},
                    {"cloud", k.cloud},
                    {"n", k.particles},
                    {"ns_per_particle", k.ns_per_particle},
                    {"particles_per_cpu_s", 1e9 / k.ns_per_particle}});
  session.write_table(rows);
  session.write_json({{"rows", rows}});
  return 0;
}

int run_bench(const Session& session, BenchCommand command) {
  if (command.full) {
    command.all = true;
    command.sizes = {1000, 8000, 64000, 1000000, 4000000};
    command.threads = {1, 2};
  }
  if (command.kernels) return run_kernels(session, command);
  const auto all = chosen(command);
  const auto machines = machines_of(command);
  Json rows = Json::array();
  Progress progress("bench", session.progress());
  const auto runs = static_cast<double>(all.size() * command.sizes.size() * command.threads.size());
  double done = 0;
  for (const auto& c : all)
    for (const long n : command.sizes)
      for (const int threads : command.threads) {
        if (c.most == 0 || n <= c.most)
          rows.push_back(row_of(c, bench::measure(c, n, threads, command.repeats, command.seconds),
                                machines.at(threads)));
        progress.update(++done / runs);
      }
  progress.finish();
  for (const auto& [threads, m] : machines)
    session.text() << threads << (threads == 1 ? " core: " : " cores: ") << m.fma_gflops
                   << " GFLOP/s in fused multiply-adds, " << m.triad_gbs << " GB/s in the triad\n";
  session.write_table(rows);
  const Json exponents = exponents_of(rows, of_an_evaluation), of_setup = exponents_of(rows, of_the_setup),
             speed_ups = speed_ups_of(rows);
  for (const auto& [name, exponent] : exponents.items())
    session.text() << name << ": a step costs as N^" << exponent.get<double>() << ", its set-up as N^"
                   << of_setup[name].get<double>() << '\n';
  for (const auto& s : speed_ups)
    session.text() << s["case"].get<std::string>() << ", N = " << s["n"] << ": " << s["threads"]
                   << " threads are " << s["speed_up"].get<double>() << " times as fast as one\n";
  session.write_json({{"machine", json_of(machines)},
                      {"rows", rows},
                      {"exponents", exponents},
                      {"setup_exponents", of_setup},
                      {"speed_ups", speed_ups}});
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
  command.add_option("--case", options->only, "cases to run (the main ones)")
      ->delimiter(',')
      ->type_name("NAME,..");
  command.add_flag("--all", options->all, "every scheme, on lattices and jittered clouds");
  command.add_flag("--full", options->full,
                   "--all with N from 10^3 to 4 10^6 on 1 and 2 threads; some ten minutes");
  command.add_flag("--kernels", options->kernels,
                   "the loops one by one instead (Google Benchmark), at the first number of particles");
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
}

}  // namespace plumb
