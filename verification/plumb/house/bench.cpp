#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "lib/core/error.hpp"
#include "verification/plumb/bench/cases.hpp"
#include "verification/plumb/bench/kernels.hpp"
#include "verification/plumb/bench/machine.hpp"
#include "verification/plumb/bench/results.hpp"
#include "verification/plumb/house_commands.hpp"
#include "verification/plumb/run/sittings.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

struct BenchCommand {
  std::vector<std::string> only;
  std::vector<long> sizes{1000, 8000, 64000};
  std::vector<int> threads{1};
  int repeats = 3;
  double seconds = 0.2;
  bool all = false, full = false, kernels = false;
  SittingOptions sitting;
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
using Machines = std::map<int, bench::Machine>;

Machines machines_of(const BenchCommand& command) {
  Machines machines{{1, bench::measure_machine(1)}};
  for (const int threads : command.threads)
    if (!machines.count(threads)) machines[threads] = bench::measure_machine(threads);
  return machines;
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

/// Every case at every size on every number of threads: each is a part of the sitting.
Json measure_all(const Session& session, const BenchCommand& command, const Machines& machines,
                 Sitting& sitting) {
  const auto all = chosen(command);
  Json rows = Json::array();
  Progress progress("bench", session.progress());
  const auto runs = static_cast<double>(all.size() * command.sizes.size() * command.threads.size());
  double done = 0;
  for (const auto& c : all)
    for (const long n : command.sizes)
      for (const int threads : command.threads) {
        if (c.most == 0 || n <= c.most)
          rows.push_back(sitting.part(fmt::format("{}, {} particles, {} threads", c.name, n, threads), [&] {
            return bench::row_of(c, bench::measure(c, n, threads, command.repeats, command.seconds),
                                 machines.at(threads));
          }));
        progress.update(++done / runs);
      }
  return rows;
}

void tell(std::ostream& out, const Machines& machines, const Json& result) {
  for (const auto& [threads, m] : machines)
    out << threads << (threads == 1 ? " core: " : " cores: ") << m.fma_gflops
        << " GFLOP/s in fused multiply-adds, " << m.triad_gbs << " GB/s in the triad\n";
  for (const auto& [name, exponent] : result["exponents"].items())
    out << name << ": a step costs as N^" << exponent.get<double>() << ", its set-up as N^"
        << result["setup_exponents"][name].get<double>() << '\n';
  for (const auto& s : result["speed_ups"])
    out << s["case"].get<std::string>() << ", N = " << s["n"] << ": " << s["threads"] << " threads are "
        << s["speed_up"].get<double>() << " times as fast as one\n";
}

int run_bench(const Session& session, BenchCommand command) {
  if (command.full) {
    command.all = true;
    command.sizes = {1000, 8000, 64000, 1000000, 4000000};
    command.threads = {1, 2};
  }
  if (command.kernels) return run_kernels(session, command);
  chosen(command);  // a name that is not known is told before the machine is measured
  const Machines machines = machines_of(command);
  const Json rows = in_one_sitting(
      session, command.sitting, {}, {fmt::format("bench {} {}", command.repeats, command.seconds)},
      [&](Sitting& sitting) { return measure_all(session, command, machines, sitting); });
  const Json result{{"machine", bench::json_of(machines)},
                    {"rows", rows},
                    {"exponents", bench::exponents_of(rows, bench::of_an_evaluation)},
                    {"setup_exponents", bench::exponents_of(rows, bench::of_the_setup)},
                    {"speed_ups", bench::speed_ups_of(rows)}};
  tell(session.text(), machines, result);
  session.write_table(rows);
  session.write_json(result);
  return 0;
}

}  // namespace

/// `plumb-house bench`: speed of whole runs, beside the limits of the machine measured in the same call.
void add_bench(CLI::App& program, Session& session) {
  const auto options = std::make_shared<BenchCommand>();
  CLI::App& command =
      add_command(program, session,
                  {"bench", "particle updates per second of whole runs, beside the machine's limits",
                   "plumb-house bench --case adjoint-verlet-3d --n 1000,8000 --seconds 0.05"},
                  {.table = true}, [&session, options] { return run_bench(session, *options); });
  command.add_option("--case", options->only, "cases to run (the main ones)")
      ->delimiter(',')
      ->type_name("NAME,..");
  command.add_flag("--all", options->all, "every scheme, on lattices and jittered clouds");
  command.add_flag(
      "--full", options->full,
      "--all with N from 10^3 to 4 10^6 on 1 and 2 threads; some ten minutes of a quiet machine, 7 GB");
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
  add_sitting_options(command, options->sitting);
}

}  // namespace plumb::app
