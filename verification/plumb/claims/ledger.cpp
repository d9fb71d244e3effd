#include "verification/plumb/claims/ledger.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "lib/core/error.hpp"
#include "lib/input/section.hpp"

namespace plumb::app::claims {
namespace {

constexpr std::array<std::string_view, 4> names = {"reproduced", "contradicted", "ambiguous", "open"};
/// A claim that does not hold has been tried in so many readings, or it stays open.
constexpr std::size_t readings_to_contradict = 3;

Status status_named(const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return static_cast<Status>(found - names.begin());
}

Reading read_reading(const Section& section) {
  Reading r;
  r.name = section.text("name");
  r.value = section.number("value", quantity::number);
  r.test = section.text_or("test", "");
  r.tolerance = section.number_or("tolerance", r.tolerance, quantity::number, Sign::positive);
  if (r.test.empty()) {
    r.command = section.text("command");
    r.at = section.text("at");
    r.over = section.text_or("over", "");
    r.over_command = section.text_or("over_command", "");
    if (section.has("take")) r.take = section.choice_or("take", "mean", {"mean", "largest"});
    r.from = section.number_or("from", 0, quantity::time);
    r.is = section.text_or("is", "");
    r.times = section.number_or("times", 1, quantity::number);
    r.long_run = section.flag_or("long", false);
  }
  section.reject_unknown();
  return r;
}

void check_status(const Section& section, const Claim& claim) {
  const Status derived = status_of(claim);
  if (claim.status == derived) return;
  section.fail(
      "status", fmt::format("\"{}\" does not follow from the readings", name_of(claim.status)),
      fmt::format("their values make it \"{}\"", name_of(derived)),
      "a claim that holds in no reading needs three readings and second_evidence to be contradicted");
}

Claim read_claim(const Section& section, const std::string& paper) {
  Claim c;
  c.paper = paper;
  c.id = section.text("id");
  c.where = section.text("where");
  c.claim = section.text("claim");
  c.published = section.text("published");
  c.unit = section.text_or("unit", "");
  c.at_least = section.optional_number("at_least", quantity::number);
  c.at_most = section.optional_number("at_most", quantity::number);
  c.finding = section.text_or("finding", "");
  c.second_evidence = section.text_or("second_evidence", "");
  c.picture = section.text_or("picture", "");
  c.status = status_named(section.choice_or("status", "open", {names.begin(), names.end()}));
  for (const Section& reading : section.sections("reading")) c.readings.push_back(read_reading(reading));
  section.reject_unknown();
  if (!c.at_least && !c.at_most)
    section.fail("at_least", "missing key", "neither at_least nor at_most says when the claim holds");
  if (c.readings.empty()) section.fail("reading", "missing", "a claim is judged by at least one number");
  check_status(section, c);
  return c;
}

}  // namespace

std::string_view name_of(Status status) {
  return names[static_cast<std::size_t>(status)];
}

bool Claim::holds_for(double value) const {
  return (!at_least || value >= *at_least) && (!at_most || value <= *at_most);
}

Status status_of(const Claim& claim, const std::vector<double>& values) {
  const auto hold = std::count_if(values.begin(), values.end(), [&](double v) { return claim.holds_for(v); });
  if (hold == static_cast<std::ptrdiff_t>(values.size())) return Status::reproduced;
  if (hold > 0) return Status::ambiguous;
  const bool enough = values.size() >= readings_to_contradict && !claim.second_evidence.empty();
  return enough ? Status::contradicted : Status::open;
}

Status status_of(const Claim& claim) {
  std::vector<double> values;
  for (const Reading& r : claim.readings) values.push_back(r.value);
  return status_of(claim, values);
}

std::vector<Claim> read_ledger(const std::filesystem::path& folder) {
  if (!std::filesystem::is_directory(folder))
    throw InputError(fmt::format("no folder \"{}\"", folder.string()), "the ledger is read from it",
                     "use verification/claims");
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".toml") files.insert(entry.path());
  std::vector<Claim> all;
  std::set<std::string> ids;
  for (const auto& file : files) {
    const TomlValue document = parse_document(read_text(file.string()), file.string());
    const Section root(document, "");
    const std::string paper = root.text("paper");
    for (const Section& section : root.sections("claim")) {
      all.push_back(read_claim(section, paper));
      if (!ids.insert(all.back().id).second)
        section.fail("id", fmt::format("\"{}\" is there twice", all.back().id), "a claim is named by it");
    }
    root.reject_unknown();
  }
  return all;
}

}  // namespace plumb::app::claims
