// `plumb-house bench`: its numbers depend on the machine, its counts do not.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/support/program.hpp"

namespace plumb {
namespace {

using json = nlohmann::json;

json bench(const std::string& arguments) {
  const auto outcome = test::run_plumb("bench " + arguments + " --seconds 0.001 --quiet --json -");
  EXPECT_EQ(outcome.code, 0) << outcome.error;
  return json::parse(outcome.out);
}

TEST(Bench, HoldsWholeRunsAgainstTheMachine) {
  const json result = bench("--case adjoint-verlet-3d,paper-2d --n 1000,8000 --cores 1,2 --repeats 1");
  EXPECT_GT(result["machine"]["fma_gflops"].get<double>(), 0);
  EXPECT_GT(result["machine"]["triad_gbs"].get<double>(), 0);
  EXPECT_EQ(result["machine"]["by_threads"].size(), 2U);
  ASSERT_EQ(result["rows"].size(), 8U);
  for (const json& row : result["rows"]) {
    for (const char* key :
         {"case", "dimension", "n", "threads", "updates_per_cpu_s", "updates_per_wall_s", "setup_cpu_s",
          "setup_wall_s", "bytes_per_particle", "fraction_of_fma", "fraction_of_triad"})
      EXPECT_TRUE(row.contains(key)) << key;
    EXPECT_GT(row["updates_per_cpu_s"].get<double>(), 0);
    // THEORY (10.8) on shared rows. Adjoint, Verlet: 8 (3 + 2 9 + 3 8); paper: 8 (2 + 2 4 + 2 6) and JST 24 2
    EXPECT_EQ(row["bytes_per_update"].get<double>(), row["dimension"] == 3 ? 360 : 224);
  }
  EXPECT_EQ(result["rows"][0]["n"], 1000);
  EXPECT_EQ(result["exponents"].size(), 2U);
  EXPECT_EQ(result["setup_exponents"].size(), 2U);
  EXPECT_EQ(result["speed_ups"].size(), 4U);
}

/// What is made of the measured numbers, made once more.
TEST(Bench, SharesSpeedUpsAndExponentsAreThoseOfTheRows) {
  const json result = bench("--case adjoint-verlet-3d,paper-2d --n 1000,8000 --cores 1,2 --repeats 1");
  const auto of = [](const json& row, const char* key) { return row[key].get<double>(); };
  const auto near = [](double found, double expected) {
    EXPECT_NEAR(found, expected, 1e-10 * std::abs(expected));  // sums of logarithms cancel
  };
  std::map<int, json> machine;
  for (const json& m : result["machine"]["by_threads"]) {
    machine[m["threads"]] = m;
    near(of(m, "fma_speed_up"), of(m, "fma_gflops") / of(result["machine"], "fma_gflops"));
    near(of(m, "triad_speed_up"), of(m, "triad_gbs") / of(result["machine"], "triad_gbs"));
  }
  std::map<std::string, std::map<int, std::map<int, json>>> rows;
  for (const json& row : result["rows"]) {
    rows[row["case"]][row["threads"]][row["n"]] = row;
    const double speed = of(row, "updates_per_wall_s");
    const json& limits = machine.at(row["threads"]);
    near(of(row, "fraction_of_fma"), speed * of(row, "flops_per_update") / (1e9 * of(limits, "fma_gflops")));
    near(of(row, "fraction_of_triad"), speed * of(row, "bytes_per_update") / (1e9 * of(limits, "triad_gbs")));
    // n (d + 4 d^2) for up to 26 neighbours in 3D, 8 in 2D, fewer at the surface
    const bool plane = row["dimension"] == 2;
    const double neighbours = of(row, "flops_per_update") / (plane ? 18 : 39);
    EXPECT_LT(neighbours, plane ? 8 : 26);
    EXPECT_GT(neighbours, plane ? 7 : 18);
  }
  for (const auto& [name, all] : rows) {
    const json &few = all.at(1).begin()->second, &many = all.at(1).rbegin()->second;
    const auto slope = [&](double small, double large) {
      return std::log(large / small) / std::log(of(many, "n") / of(few, "n"));
    };
    near(result["exponents"][name],
         slope(of(few, "n") / of(few, "updates_per_cpu_s"), of(many, "n") / of(many, "updates_per_cpu_s")));
    near(result["setup_exponents"][name], slope(of(few, "setup_cpu_s"), of(many, "setup_cpu_s")));
  }
  for (const json& gain : result["speed_ups"]) {
    const auto& all = rows.at(gain["case"]);
    EXPECT_EQ(gain["threads"], 2);
    near(of(gain, "speed_up"), of(all.at(2).at(gain["n"]), "updates_per_wall_s") /
                                   of(all.at(1).at(gain["n"]), "updates_per_wall_s"));
  }
}

TEST(Bench, CountsTheTablesOfIrregularClouds) {
  const json result = bench("--case adjoint-verlet-2d-jittered --n 400 --repeats 1"), row = result["rows"][0];
  // flops are n (d + 4 d^2) for n neighbours; bytes 8 (2 + 2 4 + 2 8) + 2 n (8 2 + 4) + 8 (4 + 2) + 24
  const double neighbours = row["flops_per_update"].get<double>() / 18;
  EXPECT_GT(neighbours, 7);  // 8 inside
  EXPECT_LT(neighbours, 8);
  EXPECT_NEAR(row["bytes_per_update"].get<double>(), 208 + 40 * neighbours + 72, 1e-9);
}

TEST(Bench, MeasuresEveryKernelOnBothKindsOfCloud) {
  std::set<std::string> seen;
  const json result = bench("--kernels --n 1000");
  for (const json& row : result["rows"]) {
    EXPECT_GT(row["ns_per_particle"].get<double>(), 0);
    seen.insert(row["kernel"].get<std::string>() + " " + row["cloud"].get<std::string>());
  }
  for (const std::string kernel : {"stress sweep", "force sweep", "JST", "closest pairs followed",
                                   "distances of all pairs", "neighbour search", "bond table set-up"})
    for (const std::string cloud : {" lattice", " jittered"})
      EXPECT_TRUE(seen.count(kernel + cloud)) << kernel;
  EXPECT_TRUE(seen.count("neo-Hookean stress lattice"));
}

}  // namespace
}  // namespace plumb
