#pragma once
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "reports/results.hpp"
#include "reports/section.hpp"

namespace plumb::reports {

/// A section with what the run adds to it.
struct PageSection {
  std::string id, title;
  Section section;
  std::vector<std::pair<std::string, JobResult>> jobs;  ///< id and what became of it
  std::string chapter = {};
  std::map<std::string, std::string> drawn = {};  ///< SVG of figures by id, if they were drawn already
};

struct Page {
  std::string title, subtitle;
  std::vector<std::pair<std::string, std::string>> facts;  ///< commit, machine, cost, ..
  std::vector<PageSection> sections;
};

/// The whole report as one HTML text: style, script and pictures inside, nothing from the network. All of it
/// can be read without the script, which only sorts and filters tables. Data files are linked relative to it
/// ("data/ID.csv").
std::string html(const Page& page);

/// How many checks of one kind there are, and how many of them passed.
struct KindCount {
  CheckKind kind;
  std::size_t passed = 0, all = 0;
};
std::vector<KindCount> count_kinds(const std::vector<PageSection>& sections);

/// How often each verdict occurs, in the order of verdict_names(). Book-keeping that passed is not counted:
/// it shows nothing.
std::vector<std::pair<std::string, std::size_t>> count_verdicts(const std::vector<PageSection>& sections);

/// A number with `digits` significant digits for people: 1.234e-05 as 1.234·10⁻⁵ (plain text, no markup); 0
/// digits: a whole number.
std::string number_text(double value, int digits);

}  // namespace plumb::reports
