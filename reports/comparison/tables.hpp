#pragma once
#include <string>
#include <vector>

#include "reports/comparison/advice.hpp"

/// What became of the schemes as tables. No cell of them is empty.
namespace plumb::reports::comparison {

/// "ran", or why it did not, in the program's words.
std::string state_of(const Outcome& outcome);

/// Problems over schemes, those as printed or the others, with error and run time at the finest spacing;
/// finite elements stand in both.
DataTable overview(const Table& table, const Outcomes& outcomes, bool printed);

/// Everything that is known of every cell.
DataTable numbers(const Table& table, const Outcomes& outcomes);

/// Energy by cause, of the cells that have an energy at the start.
DataTable energies(const Table& table, const Outcomes& outcomes);

/// Questions, what to take, and why.
DataTable advice_table(std::string id, std::string title, const std::vector<Advice>& all);

/// The largest stable step of every scheme. The table must have a ladder. Throws MissingResult.
DataTable largest_steps(const Results& results, const Table& table);

/// What papers and other codes have for these problems, with its distance from the truth.
DataTable public_numbers(const Table& table);

/// What is compared on each problem, and where its truth comes from.
DataTable truths(const Table& table);

}  // namespace plumb::reports::comparison
