#pragma once
#include <gtest/gtest.h>

#include "reports/report.hpp"
#include "tests/reports/invented.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb::test {

inline bool near(double a, double b) {
  return std::abs(a - b) <= 1e-12 * std::abs(b);
}

/// Words of titles and names, and what they claim of the study or row they come from.
struct Claim {
  std::string words, key, value;
};
inline const std::vector<Claim> claims{
    {"W0", "pair", "W0"},
    {"W1", "pair", "W1"},
    {"W0", "--pair", "W0"},
    {"W1", "--pair", "W1"},
    {"W0", "method.pair", "W0"},
    {"W1", "method.pair", "W1"},
    {"standard", "estimator", "standard"},
    {"improved", "estimator", "improved"},
    {"bond", "estimator", "bond"},
    {"standard", "method.gradient", "standard"},
    {"improved", "method.gradient", "improved"},
    {"adjoint", "method.momentum", "adjoint"},
    {"symmetrised", "method.momentum", "symmetrised"},
    {"variational", "method.momentum", "variational"},
    {"Verlet", "method.integrator", "verlet"},
    {"RK3", "method.integrator", "rk3"},
    {"U = 0.01 m", "study.parameters.amplitude", "0.01"},
    {"U = 0.2 m", "study.parameters.amplitude", "0.2"},
    {"A = 0.2 m", "study.parameters.amplitude", "0.2"},
    {"β = 0.6", "method.beta", "0.6"},
    {"β = 0.9", "method.beta", "0.9"},
    {"β = 1.2", "method.beta", "1.2"},
    {"β = 1.5", "method.beta", "1.5"},
    {"X² + 1", "field", "poly:1,0,1"},
    {"X³ + 1", "field", "poly:1,0,0,1"},
    {"sin 5X", "field", "sin:5"},
    {"R/Δx fixed", "--radius-over-dx", "4"},
    {"R = 4Δx", "--radius-over-dx", "4"},
    {"R = 1.8Δx", "--radius-over-dx", "1.8"},
    {"x = 1 m", "--at", "1"},
    {"x = 0", "--at", "0"},
    {"jitter 0.3", "body.jitter", "0.3"},
    {"exact band", "study.held_band", "0.4"},
    {"outer particles held", "study.held_band", "0"},
    {"cell, ", "body.layout", "cell"},
    {"Jitter 0.2", "body.jitter", "0.2"},
    {"jitter 0.2", "body.jitter", "0.2"},
};

/// All sections, written from invented results.
class InventedReport : public ::testing::Test {
 protected:
  void SetUp() override {
    for (auto& plan : reports::section_plans(reports::Extent::full)) {
      // text only, or maps of categories; five-schemes has numbers of its own: comparison_test.cpp
      for (const char* other : {"account", "claims", "faults", "bad-input", "stability-maps", "five-schemes"})
        if (plan.id == other) plan.jobs.clear();
      if (plan.jobs.empty()) continue;
      for (const auto& job : plan.jobs) {
        invention.add(job);
        calls[job.id] = words_of(job);
      }
      sections[plan.id] = plan.write(invention.results);
    }
  }

  /// Everything that is known of a number: the call, the row, the column.
  Words facts_of(const Origin& origin) const {
    Words facts = calls.at(origin.row->job);
    for (const auto& [key, value] : origin.row->words) facts[key] = value;
    return facts;
  }

  void check_claims(const std::string& text, const Words& facts, const std::string& where) const {
    for (const Claim& claim : claims) {
      const auto fact = facts.find(claim.key);
      if (text.find(claim.words) == std::string::npos || fact == facts.end()) continue;
      if (fact->second.find(',') != std::string::npos && !fact->second.starts_with("poly"))
        continue;  // several
      EXPECT_EQ(fact->second, claim.value) << where << ": \"" << text << "\" shows " << claim.key;
    }
  }

  TemporaryFolder folder;
  Invention invention{folder.path()};
  std::map<std::string, Words> calls;
  std::map<std::string, reports::Section> sections;
};

}  // namespace plumb::test
