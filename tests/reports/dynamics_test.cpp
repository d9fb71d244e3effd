// Numbers of the sections implicit-dynamics and cantilever-004 that are made of several results: computed again from them.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "lib/convergence/order_fit.hpp"
#include "lib/convergence/verdict.hpp"
#include "reports/named.hpp"
#include "tests/reports/invented_report.hpp"

namespace {

using namespace plumb::reports;
using plumb::test::InventedReport;
using plumb::test::Json;

class DerivedNumbers : public InventedReport {
 protected:
  const DataTable& table(const std::string& section, const std::string& id) const {
    for (const DataTable& one : sections.at(section).tables)
      if (one.id == id) return one;
    throw std::out_of_range(id);
  }
  std::vector<double> end(const std::string& job, const std::string& probe) const {
    return invention.results.json(job).at("probes").at(probe).at("displacement").get<std::vector<double>>();
  }
  double off(const std::string& job, const std::string& reference, const std::string& probe) const {
    const auto a = end(job, probe), b = end(reference, probe);
    return std::hypot(a[0] - b[0], a[1] - b[1]) / std::hypot(b[0], b[1]);
  }
  static double shown(const DataTable& of, std::size_t row, const char* column) {
    return std::get<double>(cell_of(of, of.rows.at(row), column));
  }
};

/// Each run is held against the finest one of Verlet's of the same motion, and that one against nothing.
TEST_F(DerivedNumbers, ErrorsInTimeAreThoseOfTheEndsOfTwoRuns) {
  const DataTable& runs = table("implicit-dynamics", "dynamics-runs");
  int references = 0;
  for (std::size_t row = 0; row < runs.rows.size(); ++row) {
    const std::string& job = runs.row_jobs[row];
    const bool thrown = job.starts_with("dynamics-thrown"), stiff = job.starts_with("dynamics-stiff");
    const std::string reference = thrown  ? "dynamics-thrown-verlet-0-005"
                                  : stiff ? "dynamics-stiff-verlet-0-1"
                                          : "dynamics-slender-verlet-0-4";
    const Entry& error = cell_of(runs, runs.rows[row], "off the reference");
    if (job == reference) {
      EXPECT_TRUE(std::holds_alternative<std::monostate>(error)) << job;
      ++references;
      continue;
    }
    EXPECT_NEAR(std::get<double>(error),
                off(job, reference,
                    thrown  ? "corner"
                    : stiff ? "side"
                            : "tip"),
                1e-12)
        << job;
  }
  EXPECT_EQ(references, 3);
  EXPECT_EQ(runs.rows.size(), (2u + 2 * 4) + (2 + 2 * 3) + (2 + 2 * 2))
      << "two of Verlet, and both rules with each step";
}

TEST_F(DerivedNumbers, OrdersInTimeAreThoseOfTheFreePlate) {
  const DataTable& orders = table("implicit-dynamics", "dynamics-orders");
  ASSERT_EQ(orders.rows.size(), 2u);
  for (std::size_t row = 0; row < 2; ++row) {
    const std::string rule = row == 0 ? "midpoint" : "energy-momentum";
    std::vector<plumb::Level> levels;
    for (const auto& [id, dt] :
         {std::pair("2-5e-4", 2.5e-4), {"1-25e-4", 1.25e-4}, {"6-25e-5", 6.25e-5}, {"3-125e-5", 3.125e-5}})
      levels.push_back(
          {dt, off("dynamics-thrown-" + rule + "-" + id, "dynamics-thrown-verlet-0-005", "corner")});
    const plumb::OrderFit fit = plumb::fit_order(levels);
    EXPECT_NEAR(shown(orders, row, "order"), fit.order, 1e-12);
    const Check check = named(sections.at("implicit-dynamics").checks,
                              std::get<std::string>(orders.rows[row][0]) + ": order in time", &Check::what);
    EXPECT_EQ(check.verdict, plumb::name_of(plumb::judge(fit, 2)));
  }
}

/// Energies against both readings of the exact one.
TEST_F(DerivedNumbers, EnergiesOfTheCantileverAreHeldAgainstBothReadings) {
  const DataTable& runs = table("cantilever-004", "cantilever-runs");
  EXPECT_EQ(runs.rows.size(), 9u + 11u);
  for (std::size_t row = 0; row < runs.rows.size(); ++row) {
    const Json result = invention.results.json(runs.row_jobs[row]);
    const double energy = result.at("energy").at("strain").get<double>();
    EXPECT_NEAR(shown(runs, row, "off the field's"), 100 * (energy - 2.805728e-3) / 2.805728e-3, 1e-8);
    EXPECT_NEAR(shown(runs, row, "off the load's work"), 100 * (energy - 2.77284e-3) / 2.77284e-3, 1e-8);
    const bool printed = runs.row_jobs[row].find("-cloud-") != std::string::npos;
    EXPECT_EQ(std::holds_alternative<double>(cell_of(runs, runs.rows[row], "paper")), printed);
    if (printed) {
      const std::string& job = runs.row_jobs[row];
      const std::array<double, 3> of_286{0.0859, 3.011e-3, 2.422e-6}, of_695{0.0729, 2.948e-3, 1.487e-6},
          of_2609{0.0273, 2.891e-3, 7.785e-7},
          &paper = job.ends_with("286")   ? of_286
                   : job.ends_with("695") ? of_695
                                          : of_2609;
      EXPECT_EQ(shown(runs, row, "paper"), paper[0]) << job;
      EXPECT_EQ(shown(runs, row, "paper's"), paper[1]) << job;
      EXPECT_EQ(shown(runs, row, "its paper's"), paper[2]) << job;
    }
  }
  const DataTable& orders = table("cantilever-004", "cantilever-orders");
  ASSERT_EQ(orders.rows.size(), 3u);
  std::vector<plumb::Level> levels;
  for (const auto& [id, d] : {std::pair("5", 0.5), {"33", 0.3333333333333333}, {"25", 0.25}})
    levels.push_back({d, invention.results.json(std::string("cantilever-alpha-0-") + id)
                             .at("error")
                             .at("displacement")
                             .get<double>()});
  EXPECT_NEAR(shown(orders, 1, "order"), plumb::fit_order(levels).order, 1e-12);
}

}  // namespace
