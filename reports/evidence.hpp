#pragma once
#include <string>
#include <vector>

#include "reports/section.hpp"

/// The studies behind the section compatible-evidence: every manufactured solution on every kind of cloud by
/// three schemes.
namespace plumb::reports {

/// Clouds of particles and schemes: what is changed in a study for them.
struct Choice {
  std::string id, name;
  std::vector<std::string> set;
};

/// A manufactured solution: the subcommand that solves it, its study file and what is changed in it.
struct Problem {
  std::string id, name, command, file;
  std::vector<std::string> set;
  std::vector<std::string> clouds;        ///< ids of the clouds on which it is solved
  std::vector<std::string> second_order;  ///< ids of those on which compatible bonds are said to have order 2
  std::vector<std::string> long_clouds = {};  ///< instead of `clouds` in a long run; empty: the same
};

/// Finer levels, more clouds and more solutions in a long run.
std::vector<Problem> problems(bool long_run);
const std::vector<Choice>& clouds();
/// Compatible bonds first, then the two that are not projected.
const std::vector<Choice>& schemes();

/// A cloud by its id.
const Choice& cloud_of(const std::string& id);
bool is_lattice(const Choice& cloud);

Job evidence_job(const Problem& problem, const Choice& cloud, const Choice& scheme);

}  // namespace plumb::reports
