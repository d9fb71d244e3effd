#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>

#include "reports/checks.hpp"
#include "reports/results.hpp"
#include "reports/section.hpp"

namespace plumb::reports::sections::claims {
namespace {

using Json = nlohmann::ordered_json;

/// A part of the ledger with the files that hold it.
struct Part {
  std::string id, title;
  std::vector<std::string> files;
};

const std::vector<Part> parts{
    {"4", "Paper 000, sections 4 and 6: the deformation gradient", {"000-4"}},
    {"5.1", "Paper 000, section 5.1: swinging plate", {"000-5.1"}},
    {"5.2", "Paper 000, section 5.2: spinning plate and cube", {"000-5.2"}},
    {"5.3", "Paper 000, section 5.3: bending column", {"000-5.3"}},
    {"5.4", "Paper 000, section 5.4: pulling column", {"000-5.4"}},
    {"5.5", "Paper 000, section 5.5: twisting column", {"000-5.5"}},
    {"002", "Paper 002: updated Lagrangian SPH", {"002-2", "002-5"}},
    {"003", "Paper 003: the mixed system", {"003-2-6", "003-8.1", "003-8.2-8.4"}},
    {"004", "Paper 004: implicit equilibria", {"004-6.1", "004-6.2", "004-6.3", "004-6.6", "004-equations"}}};
/// Sections of paper 000 in which no claim may be left open.
const std::vector<std::string> closed{"4", "5.1", "5.2", "5.3"};

/// The part of the ledger that a claim belongs to: its paper, and of paper 000 the section ("5.3, Table 1");
/// what section 6 says stands with 4.
std::string part_of(const Json& claim) {
  const std::string paper = text(claim, "paper");
  if (paper != "000") return paper;
  const std::string where = text(claim, "where");
  return where.front() == '5' ? where.substr(0, 3) : "4";
}

/// Every reading on a line of its own, with what it gave; those in which the claim holds are marked.
std::string readings_of(const Json& claim) {
  const std::string unit = text(claim, "unit").empty() ? "" : " " + text(claim, "unit");
  std::string out;
  for (const auto& reading : claim.at("readings"))
    out +=
        fmt::format("{}{} {:.4g}{}: {}", out.empty() ? "" : "\n", reading.at("holds").get<bool>() ? "✓" : "✗",
                    number(reading, "value"), unit, text(reading, "name"));
  return out;
}

DataTable table_of(const std::string& part, const std::string& title) {
  std::string id = "claims-" + part;
  for (char& c : id)
    if (c == '.') c = '-';
  return {id,
          title,
          {{"where"},
           {"claim"},
           {"published"},
           {"status"},
           {"ours, by reading (✓ the claim holds)"},
           {"why"},
           {"evidence"}},
          {},
          {"claims"},
          {}};
}

Section write(const Results& results) {
  const Json result = results.json("claims");
  Section s;
  s.question = "Which numbers and statements of the papers are reproduced?";
  std::map<std::string, int> count, open;
  for (const auto& [part, title, files] : parts) {
    DataTable table = table_of(part, title);
    for (const auto& claim : result.at("claims")) {
      if (part_of(claim) != part) continue;
      const std::string status = text(claim, "status");
      ++count[status];
      open[part] += status == "open" ? 1 : 0;
      table.rows.push_back({text(claim, "where"), text(claim, "claim"), text(claim, "published"), status,
                            readings_of(claim), text(claim, "finding"), text(claim, "evidence")});
    }
    s.tables.push_back(std::move(table));
  }
  const auto all = result.at("claims").size();
  s.answer = fmt::format(
      "Of {} claims {} are reproduced in every reading tried, {} in some readings only (ambiguous), {} are "
      "contradicted and {} are open.",
      all, count["reproduced"], count["ambiguous"], count["contradicted"], count["open"]);
  s.headlines = {
      {fmt::format("{} claims", all),
       fmt::format("of the papers: {} reproduced, {} ambiguous, {} contradicted, {} open",
                   count["reproduced"], count["ambiguous"], count["contradicted"], count["open"])}};
  s.checks.push_back(as(CheckKind::book_keeping,
                        {"claims in the ledger", "at least 40", fmt::format("{}", all), pass_if(all >= 40)}));
  for (const auto& part : closed)
    s.checks.push_back(
        as(CheckKind::book_keeping, {"open claims of paper 000, section " + part, "0",
                                     fmt::format("{}", open[part]), pass_if(open[part] == 0)}));
  s.notes = {
      "A claim is reproduced if it holds in every reading of what the paper leaves open, "
      "ambiguous if it holds in some, contradicted if it holds in none of at least three "
      "and a second, independent line of evidence says the same, and open otherwise.",
      "ctest -L claims measures the quick numbers again and fails when one of them, or a status, has changed "
      "(plumb claims --check; with --long all of them)."};
  return s;
}

}  // namespace

/// The ledger of the papers' claims.
SectionPlan planned(Extent) {
  const std::string folder = "verification/claims/";
  Job job{"claims", {"claims"}, {}};
  for (const auto& part : parts)
    for (const auto& file : part.files) job.inputs.push_back(folder + file + ".toml");
  return {810, "claims", "Ledger of the papers' claims", {job}, write};
}

}  // namespace plumb::reports::sections::claims
