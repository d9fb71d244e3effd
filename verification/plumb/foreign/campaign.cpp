#include "verification/plumb/foreign/campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "lib/core/dimension.hpp"
#include "lib/core/error.hpp"
#include "lib/input/section.hpp"
#include "verification/plumb/foreign/campaign_cloud.hpp"
#include "verification/plumb/foreign/export_solution.hpp"

namespace plumb::app {
namespace {

namespace fs = std::filesystem;

double edge_of(const Campaign& campaign) {
  return plumb::with_dimension(campaign.solution.dimension,
                               [&]<int d>() { return campaign.solution.fields<d>().domain.length(); });
}

/// A file of the run's own folder: no path that leads out of it.
std::string own_file(const Section& head, const std::string& key, const std::string& otherwise) {
  const std::string name = head.text_or(key, otherwise);
  if (name.find('/') != std::string::npos || name == "..")
    head.fail(key, fmt::format("\"{}\" is a path", name),
              "it is the name of a file in the folder of each run");
  return name;
}

void read_files(const Section& head, Campaign& c) {
  c.command = head.text("command");
  c.prepare = head.text_or("prepare", "");
  c.template_file = head.text_or("template", "");
  c.input =
      own_file(head, "input", c.template_file.empty() ? "" : fs::path(c.template_file).filename().string());
  if (c.template_file.empty() && !c.input.empty())
    head.fail("input", "there is no template", "it is what the template becomes");
  if (!c.template_file.empty()) c.template_file = (fs::path(c.here) / c.template_file).string();
  if (head.is_array("cloud"))
    c.clouds = head.texts("cloud");
  else if (head.has("cloud"))
    c.clouds = {head.text("cloud")};
  for (const std::string& cloud : c.clouds) require_cloud_format(cloud);
  c.loads = own_file(head, "loads", "");
  c.result = own_file(head, "result", "result.csv");
  c.points.positions = head.choice_or("positions", "", {"", "reference", "current"});
}

void read_steps(const Section& head, Campaign& c) {
  c.cfl = head.optional_number("cfl", quantity::number, Sign::positive);
  c.step = head.optional_number("time_step", quantity::time, Sign::positive);
  if (c.cfl && c.step)
    head.fail("cfl", "contradicts time_step", "the step is given by one of them", "leave one of them out");
}

void read_levels(const Section& head, Campaign& c) {
  c.spacings = head.numbers("spacings", 0, quantity::length, Sign::positive);
  for (std::size_t k = 1; k < c.spacings.size(); ++k)
    if (c.spacings[k] >= c.spacings[k - 1])
      head.fail("spacings", fmt::format("{} follows {}", c.spacings[k], c.spacings[k - 1]),
                "they must go from coarse to fine, each once");
  c.runs = static_cast<int>(head.integer_or("runs", 1, 1));
  c.layout = head.choice_or("layout", "node", {"node", "cell"}) == "cell" ? Layout::cell : Layout::node;
  c.jitter = head.number_or("jitter", 0, quantity::number, Sign::not_negative);
  if (c.jitter >= 0.5)
    head.fail("jitter", "is too large", "it is a fraction of the spacing below 0.5, or points could meet");
  if (c.runs > 1 && c.jitter == 0)
    head.fail("runs", "several runs of one lattice", "they are all the same", "add jitter = 0.2");
}

void read_expect(const Section& root, Campaign& c) {
  c.norms = {"l2"};
  const auto section = root.optional_section("expect");
  if (!section) return;
  c.norms.clear();
  for (const char* norm : {"l2", "linf", "h1", "velocity_l2", "stress_l2", "cauchy_l2"})
    if (const auto order = section->optional_number(norm, quantity::number)) {
      c.norms.emplace_back(norm);
      c.expect.push_back(*order);
    }
  c.reason = section->text_or("reason", "");
  section->reject_unknown();
  if (c.norms.empty()) section->fail("", "declares no order", "", "add l2 = 2");
}

std::map<std::string, std::string> meanings(const Campaign& c, const CampaignRun& run) {
  const auto number = [](double value) { return fmt::format("{:.17g}", value); };
  std::map<std::string, std::string> all{{"h", number(run.spacing)},
                                         {"n", fmt::format("{}", std::lround(edge_of(c) / run.spacing))},
                                         {"level", fmt::format("{}", run.level)},
                                         {"run", fmt::format("{}", run.number)},
                                         {"time", number(c.time)},
                                         {"loads", c.loads},
                                         {"input", c.input},
                                         {"result", c.result},
                                         {"here", c.here},
                                         {"cloud", c.clouds.empty() ? "" : c.clouds.front()},
                                         {"young", number(c.solution.elastic.young)},
                                         {"poisson", number(c.solution.elastic.poisson)},
                                         {"density", number(c.solution.elastic.density)}};
  if (run.steps > 0) {
    all["dt"] = number(run.step);
    all["steps"] = fmt::format("{}", run.steps);
  }
  for (const auto& values : {c.solution.parameters, c.solution.law.parameters})
    for (const auto& [key, value] : values) all[key] = number(value);
  return all;
}

}  // namespace

Campaign read_campaign(const std::string& path, const std::vector<std::string>& overrides) {
  const TomlValue document = parse_document(read_text(path), path, overrides);
  const Section root(document, "");
  for (const char* name : {"campaign", "parameters", "material", "expect"}) root.has(name);
  root.reject_unknown();
  Campaign c;
  c.file = path;
  c.here = fs::absolute(path).parent_path().string();
  const Section head = root.section("campaign");
  c.name = head.text_or("name", fs::path(path).stem().string());
  c.solution =
      read_solution_choice(head.text("solution"), static_cast<int>(head.integer_or("dimension", 0, 1)), root);
  c.time = head.number("time", quantity::time);
  read_levels(head, c);
  read_steps(head, c);
  read_files(head, c);
  head.reject_unknown();
  read_expect(root, c);
  const std::string input = c.template_file.empty() ? "" : read_text(c.template_file);
  for (const CampaignRun& run : runs_of(c)) {  // nothing is run before all placeholders and clouds are known
    if (!c.clouds.empty() || !c.loads.empty()) require_cloud_fits(c.solution, run.spacing);
    filled(c.command, c, run, path + ": command");
    filled(c.prepare, c, run, path + ": prepare");
    filled(input, c, run, c.template_file);
  }
  return c;
}

std::vector<CampaignRun> runs_of(const Campaign& c) {
  std::vector<CampaignRun> all;
  for (std::size_t level = 0; level < c.spacings.size(); ++level)
    for (int number = 1; number <= c.runs; ++number) {
      CampaignRun run{level, number, c.spacings[level], 0, 0, fmt::format("h_{:g}", c.spacings[level])};
      if (c.runs > 1) run.folder += fmt::format("_run_{}", number);
      const double most = c.step  ? *c.step
                          : c.cfl ? *c.cfl * run.spacing / c.solution.elastic.wave_speed()
                                  : 0;
      if (most > 0 && c.time / most > 1e9)
        throw InputError(fmt::format("{:.3g} time steps", c.time / most), "that is no run",
                         "check time and step");
      if (most > 0) run.steps = std::max(1, static_cast<int>(std::ceil(c.time / most * (1 - 1e-12))));
      if (run.steps > 0) run.step = c.time / run.steps;
      all.push_back(run);
    }
  return all;
}

std::string filled(const std::string& text, const Campaign& campaign, const CampaignRun& run,
                   const std::string& where) {
  const auto known = meanings(campaign, run);
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t open = text.find('@', at),
                      close = open == std::string::npos ? open : text.find('@', open + 1);
    out += text.substr(at, std::min(open, text.size()) - at);
    if (open == std::string::npos) break;
    const std::string name = close == std::string::npos ? "" : text.substr(open + 1, close - open - 1);
    const bool word =
        !name.empty() && name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_") == std::string::npos;
    if (!word) {  // a lone sign of another meaning
      out += '@';
      at = open + 1;
      continue;
    }
    const auto found = known.find(name);
    if (found == known.end()) {
      std::vector<std::string> names;
      for (const auto& entry : known) names.push_back("@" + entry.first + "@");
      if (name == "dt" || name == "steps")
        throw InputError(fmt::format("{}: @{}@ without a time step", where, name), "no step is chosen",
                         "add cfl = 0.5 or time_step = .. to [campaign]");
      throw unknown_name("placeholder of " + where, "@" + name + "@", names);
    }
    out += found->second;
    at = close + 1;
  }
  return out;
}

std::vector<std::pair<std::string, std::string>> files_of(const Campaign& c, const CampaignRun& run) {
  std::vector<std::pair<std::string, std::string>> files;
  if (!c.template_file.empty())
    files.emplace_back(c.input, filled(read_text(c.template_file), c, run, c.template_file));
  if (c.clouds.empty() && c.loads.empty()) return files;
  const CampaignCloud cloud =
      campaign_cloud(c.solution, run.spacing, c.layout, c.jitter, static_cast<std::uint64_t>(run.number));
  for (const std::string& name : c.clouds) files.emplace_back(name, cloud_text(cloud, c.solution, name));
  if (!c.loads.empty()) files.emplace_back(c.loads, values_at(c.solution, cloud.positions, c.time));
  return files;
}

}  // namespace plumb::app
