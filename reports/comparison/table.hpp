#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reports/section.hpp"

/// Schemes side by side on one set of problems, as verification/comparison/*.toml says it.
namespace plumb::reports::comparison {

/// A scheme with the overrides that make it.
struct Scheme {
  std::string id, name;
  std::string paper;     ///< its colour and point shape in every picture: look_of()
  bool printed = false;  ///< as the paper prints it: dashed, with hollow points
  std::vector<std::string> set;
};

/// What is compared of a run with its truth. Exactly one of `at`, `turn_of` and `half_swing_of` is given of a
/// scene; a study compares its relative error in L2.
struct Quantity {
  std::string in_words = {};
  std::vector<std::string> at = {};  ///< JSON pointers into the summary of a run: a vector
  std::vector<std::string> turn_of =
      {};                              ///< two displacements of the series: the turn about the axis [degrees]
  std::vector<double> turn_from = {};  ///< where that particle is at rest [m]
  std::string half_swing_of = {};  ///< column of the series: twice the time of its first return to zero [s]
  double plus_spacing = 0;         ///< so many spacings are added, from outermost particles to a surface
  std::vector<double> truth = {};
  double scale = 1;         ///< the distance from the truth is divided by it
  std::string source = {};  ///< where the truth comes from
};

/// What is special of one scheme on one problem.
struct Cell {
  std::vector<std::string> set;
  std::vector<std::pair<std::string, double>> over_spacing;  ///< keys that are set to this times the spacing
  std::string refuses;           ///< not empty: the program refuses it in a sentence with these words
  bool breaks = false;           ///< a level becomes unstable
  std::optional<double> within;  ///< bound of the error at the finest spacing
  bool other_law = false;  ///< its law is another one at the strains of the problem: it is not recommended
  std::string cannot;      ///< not empty: it is not run, and this says why
  std::string note;
};

/// A number that another code, or a paper, has for a problem.
struct PublicNumber {
  std::string code;
  double value = 0;  ///< in the unit of the truth
  std::string note;  ///< where it comes from, and what is different
};

struct Problem {
  std::string id, title;
  std::string asks;    ///< what a user has who meets it: "large twist"
  std::string file;    ///< relative to the root
  bool study = false;  ///< a study of `plumb mms`, else a scene of `plumb run`
  std::vector<std::string> set;
  std::vector<double> spacings;  ///< [m], from coarse to fine
  Quantity quantity;
  double equal_error = 0;  ///< run times are compared where the error is this
  bool still = false;      ///< an equilibrium: there is no energy at the start to compare with
  bool free = false;       ///< nothing acts from outside: momenta are compared
  bool core = false;       ///< the smallest report shows it, too
  std::string beside;      ///< another problem, of which this is a harder form
  std::vector<std::pair<std::string, Cell>> cells;
  std::vector<PublicNumber> others = {};  ///< shown as such: they are runs of other programs

  /// What is special of that scheme; nothing, if nothing is said.
  Cell cell(const std::string& scheme) const;
};

/// One scene with CFL numbers from small to large.
struct StepLadder {
  std::string scene;
  std::vector<std::string> set;
  std::vector<double> cfl;
  double wave_time = 1;      ///< that a pressure wave needs from particle to particle [s]
  double energy_within = 0;  ///< a run whose energy changes by a larger share is not stable
  std::vector<std::pair<std::string, Cell>> cells;
};

/// The cell of that scheme, or an empty one.
Cell cell_of(const std::vector<std::pair<std::string, Cell>>& cells, const std::string& scheme);

struct Table {
  std::vector<Scheme> schemes;
  std::vector<Problem> problems;
  std::optional<StepLadder> ladder;
};

/// Reads the table: the core has the problems that say so, a long run the spacings that are for it, too. Throws SceneError with file and line
/// for what is wrong, unknown schemes included.
Table read_table(const std::string& text, const std::string& file, Extent extent);

/// The calls of one cell: one for a study, one for each spacing of a scene, and only the first where the
/// scheme refuses.
std::vector<Job> jobs_of(const Problem& problem, const Scheme& scheme);

/// The calls of all cells, those of the ladder included.
std::vector<Job> jobs_of(const Table& table);

}  // namespace plumb::reports::comparison
