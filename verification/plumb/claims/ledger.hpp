#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The ledger of the papers' claims: verification/claims/*.toml as values.
namespace plumb::app::claims {

/// What became of a claim. It follows from the readings by status_of(), and is also written in the ledger, so
/// that a change of a number that changes a status is seen.
enum class Status { reproduced, contradicted, ambiguous, open };
std::string_view name_of(Status status);

/// One way to read a sentence that the paper leaves open, with the number found in it.
struct Reading {
  std::string name;
  std::string command;       ///< behind "plumb"; makes a JSON. Empty: `test` holds the number
  std::string at;            ///< where the number stands in that JSON (entry_at()), or "a * b": a product
  std::string over;          ///< divided by the number that stands here; empty: not divided
  std::string over_command;  ///< ... of this command's JSON; empty: of the same
  /// "mean" or "largest" over the rows of the run's series from the time `from` on: `at` and `over` are then
  /// columns ("hourglass share"). For what swings from instant to instant. Empty: `at` stands in the result.
  std::string take;
  double from = 0;   ///< [s]
  std::string is;    ///< not empty: the value is 1 if the text at `at` is this one, else 0
  double times = 1;  ///< factor to the unit of the claim
  double value = 0;  ///< found, in the unit of the claim
  /// Relative. The default covers the digits that are written down, and what other instruction sets do to a
  /// smooth run; a larger one has its reason beside it in the ledger.
  double tolerance = 1e-4;
  bool long_run = false;  ///< more than a few seconds
  std::string test;       ///< the test that holds the number, where no command gives it
};

struct Claim {
  std::string id, paper, where;
  std::string claim;      ///< in our words
  std::string published;  ///< as printed
  std::string unit;
  std::optional<double> at_least, at_most;  ///< the claim holds for values in between
  std::string finding;                      ///< why the readings differ, in one or two sentences
  std::string second_evidence;              ///< independent of the readings; every contradicted claim has one
  std::string picture;                      ///< id of a picture of the report
  Status status = Status::open;
  std::vector<Reading> readings;  ///< the chosen one first
  bool holds_for(double value) const;
};

/// reproduced: the claim holds in every reading; ambiguous: in some; contradicted: in none of at least three
/// and by a second line of evidence; open: in none, with less than that. `values`: one for each reading.
Status status_of(const Claim& claim, const std::vector<double>& values);
/// Of the values in the ledger.
Status status_of(const Claim& claim);

/// All claims of the *.toml files of a folder, in the order of the files' names. Throws InputError with file
/// and line for whatever is wrong in them, a status that does not follow from the values included.
std::vector<Claim> read_ledger(const std::filesystem::path& folder);

}  // namespace plumb::app::claims
