#include "reports/comparison/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "lib/input/section.hpp"
#include "reports/comparison/steps.hpp"
#include "reports/named.hpp"

namespace plumb::reports::comparison {
namespace {

using Keys = plumb::Section;  // of a file; plumb::reports::Section is one of the report

std::vector<std::string> texts_or_none(const Keys& section, const std::string& key) {
  return section.has(key) ? section.texts(key) : std::vector<std::string>{};
}

Scheme read_scheme(const Keys& section) {
  Scheme scheme;
  scheme.id = section.text("id");
  scheme.name = section.text("name");
  scheme.paper = section.text("paper");
  scheme.printed = section.flag_or("printed", false);
  scheme.set = texts_or_none(section, "set");
  section.reject_unknown();
  return scheme;
}

Cell read_cell(const Keys& section) {
  Cell cell;
  cell.set = texts_or_none(section, "set");
  if (const auto keys = section.optional_section("over_spacing"))
    for (const auto& key : keys->all_keys()) cell.over_spacing.emplace_back(key, keys->any_number(key));
  cell.refuses = section.text_or("refuses", "");
  cell.breaks = section.flag_or("breaks", false);
  cell.within = section.optional_number("within", quantity::number, Sign::positive);
  cell.other_law = section.flag_or("other_law", false);
  cell.cannot = section.text_or("cannot", "");
  cell.note = section.text_or("note", "");
  section.reject_unknown();
  return cell;
}

Quantity read_quantity(const Keys& section, bool study) {
  Quantity q;
  q.in_words = section.text("quantity");
  q.source = section.text("source");
  if (study) return q;
  q.at = texts_or_none(section, "at");
  q.turn_of = texts_or_none(section, "turn_of");
  q.half_swing_of = section.text_or("half_swing_of", "");
  const std::array<bool, 3> given{!q.at.empty(), !q.turn_of.empty(), !q.half_swing_of.empty()};
  if (std::count(given.begin(), given.end(), true) != 1)
    section.fail("quantity", "it is not said how it is read", "one of at, turn_of and half_swing_of says it",
                 "give exactly one of them");
  if (!q.turn_of.empty()) q.turn_from = section.numbers("turn_from", 2, quantity::length);
  if (!q.turn_of.empty() && q.turn_of.size() != 2)
    section.fail("turn_of", "a turn is read from two displacements", "");
  q.plus_spacing = section.number_or("plus_spacing", 0, quantity::number);
  q.truth = section.numbers("truth", std::max<std::size_t>(q.at.size(), 1), quantity::number);
  q.scale = section.number("scale", quantity::number, Sign::positive);
  return q;
}

/// The cells of a problem or of the ladder, one for each scheme that they name.
std::vector<std::pair<std::string, Cell>> read_cells(const Keys& section,
                                                     const std::vector<Scheme>& schemes) {
  std::vector<std::pair<std::string, Cell>> cells;
  for (const Keys& given : section.sections("cell")) {
    const auto names = given.texts("schemes");
    const Cell cell = read_cell(given);
    for (const auto& name : names) {
      const auto is_it = [&](const auto& one) { return one.id == name; };
      if (std::none_of(schemes.begin(), schemes.end(), is_it))
        given.fail("schemes", fmt::format("there is no scheme \"{}\"", name), "");
      if (std::any_of(cells.begin(), cells.end(), [&](const auto& one) { return one.first == name; }))
        given.fail("schemes", fmt::format("\"{}\" has a cell already", name), "");
      cells.emplace_back(name, cell);
    }
  }
  return cells;
}

StepLadder read_ladder(const Keys& section, const std::vector<Scheme>& schemes) {
  StepLadder ladder;
  ladder.scene = section.text("scene");
  ladder.set = texts_or_none(section, "set");
  ladder.cfl = section.numbers("cfl", 0, quantity::number, Sign::positive);
  if (!std::is_sorted(ladder.cfl.begin(), ladder.cfl.end()))
    section.fail("cfl", "they do not go from small to large", "");
  ladder.wave_time = section.number("wave_time", quantity::time, Sign::positive);
  ladder.energy_within = section.number("energy_within", quantity::number, Sign::positive);
  ladder.cells = read_cells(section, schemes);
  section.reject_unknown();
  return ladder;
}

Problem read_problem(const Keys& section, const std::vector<Scheme>& schemes, Extent extent) {
  Problem p;
  p.id = section.text("id");
  p.title = section.text("title");
  p.asks = section.text("asks");
  p.study = section.has("study");
  if (p.study == section.has("scene"))
    section.fail("", "a problem is a study or a scene", "", "give either study or scene");
  p.file = section.text(p.study ? "study" : "scene");
  p.set = texts_or_none(section, "set");
  p.spacings = section.numbers("spacings", 0, quantity::length, Sign::positive);
  if (section.has("long_spacings"))
    for (const double d : section.numbers("long_spacings", 0, quantity::length, Sign::positive))
      if (extent == Extent::long_run) p.spacings.push_back(d);
  if (!std::is_sorted(p.spacings.rbegin(), p.spacings.rend()))
    section.fail("spacings", "they do not go from coarse to fine", "");
  p.quantity = read_quantity(section, p.study);
  p.equal_error = section.number("equal_error", quantity::number, Sign::positive);
  p.still = section.flag_or("still", false);
  p.free = section.flag_or("free", false);
  p.core = section.flag_or("core", false);
  p.beside = section.text_or("beside", "");
  p.cells = read_cells(section, schemes);
  for (const Keys& given : section.sections("public")) {
    p.others.push_back({given.text("code"), given.number("value", quantity::number), given.text("note")});
    given.reject_unknown();
  }
  if (!p.others.empty() && p.quantity.truth.size() != 1)
    section.fail("public", "there is no one number to compare with", "");
  section.reject_unknown();
  return p;
}

template <class List>
void require_different(const std::vector<Keys>& sections, const List& list) {
  std::set<std::string> ids;
  for (std::size_t k = 0; k < list.size(); ++k)
    if (!ids.insert(list[k].id).second)
      sections[k].fail("id", fmt::format("\"{}\" is there twice", list[k].id), "");
}

void add(std::vector<std::string>& arguments, const std::vector<std::string>& settings) {
  for (const auto& one : settings) arguments.insert(arguments.end(), {"--set", one});
}

}  // namespace

Cell Problem::cell(const std::string& scheme) const {
  return cell_of(cells, scheme);
}

Cell cell_of(const std::vector<std::pair<std::string, Cell>>& cells, const std::string& scheme) {
  for (const auto& [name, one] : cells)
    if (name == scheme) return one;
  return {};
}

Table read_table(const std::string& text, const std::string& file, Extent extent) {
  const TomlValue document = parse_document(text, file);
  const Keys root(document, "");
  Table table;
  const auto schemes = root.sections("scheme"), problems = root.sections("problem");
  for (const Keys& one : schemes) table.schemes.push_back(read_scheme(one));
  for (const Keys& one : problems) table.problems.push_back(read_problem(one, table.schemes, extent));
  if (const auto ladder = root.optional_section("ladder")) table.ladder = read_ladder(*ladder, table.schemes);
  root.reject_unknown();
  require_different(schemes, table.schemes);
  require_different(problems, table.problems);
  for (std::size_t k = 0; k < problems.size(); ++k) {
    const auto& beside = table.problems[k].beside;
    const auto is_it = [&](const Problem& one) { return one.id == beside; };
    if (!beside.empty() && std::none_of(table.problems.begin(), table.problems.end(), is_it))
      problems[k].fail("beside", fmt::format("there is no problem \"{}\"", beside), "");
    if (!beside.empty() && table.problems[k].core && !by_id(table.problems, beside).core)
      problems[k].fail("core", fmt::format("problem \"{}\", which it is beside, is not in the core", beside),
                       "", "add core = true there, or leave it out here");
  }
  if (extent == Extent::core) std::erase_if(table.problems, [](const Problem& one) { return !one.core; });
  return table;
}

std::vector<Job> jobs_of(const Problem& problem, const Scheme& scheme) {
  const Cell cell = problem.cell(scheme.id);
  const std::string id = "five-" + problem.id + "-" + scheme.id;
  Job job{id, {problem.study ? "mms" : "run", problem.file}, {problem.file}};
  add(job.arguments, problem.set);
  add(job.arguments, scheme.set);
  add(job.arguments, cell.set);
  if (problem.study) {
    add(job.arguments, {fmt::format("study.spacings=[{}]", fmt::join(problem.spacings, ","))});
    return {job};
  }
  std::vector<Job> jobs;
  for (std::size_t level = 0; level < problem.spacings.size(); ++level) {
    Job one = job;
    one.id += fmt::format("-{}", level + 1);
    add(one.arguments, {fmt::format("body.spacing={}", problem.spacings[level])});
    for (const auto& [key, factor] : cell.over_spacing)
      add(one.arguments, {fmt::format("{}={:.12g}", key, factor * problem.spacings[level])});
    one.arguments.insert(one.arguments.end(), {"--out", "{out}"});
    jobs.push_back(one);
    if (!cell.refuses.empty()) break;
  }
  return jobs;
}

std::vector<Job> jobs_of(const Table& table) {
  std::vector<Job> all;
  for (const auto& problem : table.problems)
    for (const auto& scheme : table.schemes)
      for (auto& job : jobs_of(problem, scheme)) all.push_back(std::move(job));
  if (table.ladder)
    for (const auto& scheme : table.schemes)
      for (auto& job : jobs_of(*table.ladder, scheme)) all.push_back(std::move(job));
  return all;
}

}  // namespace plumb::reports::comparison
