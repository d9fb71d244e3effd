#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "reports/picture.hpp"

/// What a report says, as values: sections with a question, an answer, pictures, tables and checks.
namespace plumb::reports {

/// What a check holds a number against.
enum class CheckKind {
  verified,      ///< mathematics: a closed form, an identity, an order, an independent solution
  reproduced,    ///< a number that a paper prints
  regression,    ///< a number that this project found before
  book_keeping,  ///< that something is there or ended: it says nothing about a number
};

/// "verified", "reproduced", "regression", "book-keeping".
const char* name_of(CheckKind kind);
/// The kinds in the order of the first screen.
const std::vector<CheckKind>& check_kinds();

/// One thing that was checked, with what was found. `verdict` is a name of plumb::Verdict ("pass", "above",
/// "not-asymptotic") or "not-computed".
struct Check {
  std::string what;
  std::string expected;
  std::string measured;
  std::string verdict;
  std::string job = {};  ///< where the number comes from, if it is one job
  CheckKind kind = CheckKind::verified;
};

/// The verdicts in the order of the first screen.
const std::vector<std::string>& verdict_names();
/// "pass" if it holds, else "fail".
std::string pass_if(bool holds);

/// One column of a table; numbers are shown with `digits` significant digits, as many as they are
/// worth; 0 stands for whole numbers.
struct Column {
  std::string name;
  std::string unit = {};
  int digits = 4;
};

/// An entry: nothing, text or a number (non-finite ones read "not finite").
using Entry = std::variant<std::monostate, std::string, double>;

struct DataTable {
  std::string id;  ///< letters, digits and hyphens; unique among the tables of the report
  std::string title;
  std::vector<Column> columns;
  std::vector<std::vector<Entry>> rows;
  std::vector<std::string> jobs = {};      ///< where the numbers come from
  std::vector<std::string> figures = {};   ///< for each row the id of its picture; nothing: found by its job
  std::vector<std::string> row_jobs = {};  ///< for each row its job; nothing: `jobs`, if one is for each row
                                           ///< or for all
};

/// One picture of an animation.
struct Still {
  std::string label;  ///< for instance its time
  Picture picture;
};

struct Figure {
  std::string id;  ///< letters, digits and hyphens; unique among the figures of the report
  Picture picture;
  std::string caption;
  std::vector<std::string> jobs = {};  ///< where the numbers come from
  std::vector<Still> frames = {};      ///< shown in place of `picture`, one after the other
};

/// One fact for the first screen: "94 of 94", "planted faults turned a test red".
struct Headline {
  std::string number, what;
};

/// One section of the report. `answer` is one sentence that the data of this very report support.
struct Section {
  std::string question;
  std::string answer;
  std::vector<Check> checks = {};
  std::vector<Figure> figures = {};
  std::vector<DataTable> tables = {};
  std::vector<std::string> notes = {};
  std::vector<Headline> headlines = {};
  std::size_t tables_above = 0;  ///< so many of the tables stand above the pictures, the others below
};

/// One call of `plumb` whose JSON a section needs. The call is made once and kept by content hash.
struct Job {
  std::string id;  ///< letters, digits and hyphens; unique in the report
  std::vector<std::string>
      arguments;  ///< behind "plumb", without --json; "{out}" stands for a folder of its own
  std::vector<std::string> inputs = {};  ///< files that it reads, relative to the root; their content counts
  bool alone = false;                    ///< it measures speed: nothing runs beside it, and it gets all cores
};

class Results;

/// The chapter of a place: 1xx "One dimension", 2xx "Operators in 2D and 3D", .. (reports/README.md lists
/// them).
std::string chapter_of(int place);

/// How much a report computes.
enum class Extent {
  core,     ///< each chapter's core, in minutes: what `plumb report` makes
  full,     ///< all sections, in a quarter of an hour
  long_run  ///< studies in the size of the papers, too
};

/// How a section comes about. A file reports/sections/some_name.cpp defines `SectionPlan planned(Extent)` in namespace
/// plumb::reports::sections::some_name; the list of them is generated.
struct SectionPlan {
  int place = 0;   ///< sections are ordered by it; its hundreds are the chapter (chapter_of)
  std::string id;  ///< letters, digits and hyphens; unique in the report
  std::string title;
  std::vector<Job> jobs;
  std::function<Section(const Results&)> write;  ///< may throw MissingResult
  Extent least = Extent::core;                   ///< smaller reports name it only
};

}  // namespace plumb::reports
