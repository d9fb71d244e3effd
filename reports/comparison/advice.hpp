#pragma once
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "reports/comparison/outcome.hpp"

/// Which scheme should I take: sentences whose numbers come from the results.
namespace plumb::reports::comparison {

/// What became of every cell, by the ids of problem and scheme.
using Outcomes = std::map<std::pair<std::string, std::string>, Outcome>;

/// Reads all cells. Throws MissingResult.
Outcomes outcomes_of(const Results& results, const Table& table);

/// A question of someone who has to choose, and the answer.
struct Advice {
  std::string question;
  std::string take;     ///< names of schemes
  std::string because;  ///< the numbers
};

/// For each problem the particle scheme that reaches the problem's error in the least run time, with the next
/// one and finite elements beside it; the one that comes closest, if none reaches it.
Advice advice_for(const Table& table, const Outcomes& outcomes, const Problem& problem);

/// The same for every problem.
std::vector<Advice> advice_by_problem(const Table& table, const Outcomes& outcomes);

/// What holds over the problems: momenta, energy, what a harder form costs, and what the mended form of each
/// paper changes.
std::vector<Advice> advice_over_all(const Table& table, const Outcomes& outcomes);

/// The particle scheme that is taken for most problems, and for how many. Empty name: for none.
std::pair<std::string, std::size_t> most_taken(const Table& table, const Outcomes& outcomes);

/// 0.0123 as "1.23 %".
std::string percent(double share);

}  // namespace plumb::reports::comparison
