#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "reports/named.hpp"
#include "reports/section.hpp"

namespace plumb::reports::sections::work_ratio {
namespace {

using Json = nlohmann::ordered_json;

struct Choice {
  std::string id, name;
  std::vector<std::string> set;
};

struct Problem {
  std::string id, name, file;
  std::vector<std::string> set;
};

/// The finest level of the long run: for the clouds that are always computed.
std::vector<std::string> levels_of(const Problem& p, const Choice& cloud, bool long_run) {
  if (!long_run || p.id != "plate" || (cloud.id != "0" && cloud.id != "2")) return {};
  return {"study.spacings=[0.2,0.1,0.05,0.025,0.0125]"};
}

std::vector<Problem> problems() {
  return {{"plate",
           "swinging plate, U = 0.01 m, T/8",
           "verification/studies/swinging_plate_finite_strain.toml",
           {"study.quadrature=nodal", "study.periods=0.125", "study.spacings=[0.2,0.1,0.05,0.025]"}},
          {"column", "stretched column under traction", "verification/studies/stretched_column.toml", {}}};
}

std::vector<Choice> clouds(bool long_run) {
  std::vector<Choice> all = {{"0", "lattice", {}}, {"2", "jitter 0.2", {"body.jitter=0.2"}}};
  if (long_run) {
    all.insert(all.begin() + 1, {"1", "jitter 0.1", {"body.jitter=0.1"}});
    all.push_back({"3", "jitter 0.3", {"body.jitter=0.3"}});
  }
  return all;
}

/// The paper's scheme is what the others are measured by.
std::vector<Choice> schemes() {
  return {{"paper",
           "paper: improved, symmetrised, JST, RK3",
           {"method.momentum=symmetrised", "method.integrator=rk3", "jst.eta4=0.125"}},
          {"adjoint", "improved, adjoint, Verlet", {"method.integrator=verlet"}},
          {"compatible", "compatible, Verlet", {"method.gradient=compatible", "method.integrator=verlet"}}};
}

std::string id_of(const Problem& p, const Choice& cloud, const Choice& scheme) {
  return fmt::format("ratio-{}-{}-{}", p.id, cloud.id, scheme.id);
}

Job job_of(const Problem& p, const Choice& cloud, const Choice& scheme, bool long_run) {
  Job job{id_of(p, cloud, scheme), {"mms", p.file}, {p.file}};
  const auto finer = levels_of(p, cloud, long_run);
  for (const auto* set : {&p.set, &finer, &cloud.set, &scheme.set})
    for (const auto& entry : *set) job.arguments.insert(job.arguments.end(), {"--set", entry});
  return job;
}

/// CPU time of the steps, and with set-up, at an error.
struct Cost {
  double steps, all;
};

double between(double coarse, double fine, double share) {
  return coarse * std::pow(fine / coarse, share);
}

/// At a relative error, between two levels, in logarithms. Nothing beyond the levels: where even the coarsest
/// one is better, that one's cost; where none is as good, nothing.
std::optional<Cost> cost_at(const Json& levels, double error) {
  const auto cost = [](const Json& level) {
    return Cost{number(level, "cpu_s"), number(level, "cpu_s") + number(level, "setup_s")};
  };
  const Json* coarser = nullptr;
  for (const Json& level : levels) {
    const double reached = number(level, "relative_l2");
    if (!std::isfinite(reached)) continue;
    if (reached <= error) {
      if (coarser == nullptr) return cost(level);
      const double before = number(*coarser, "relative_l2");
      const double share = std::log(before / error) / std::log(before / reached);
      return Cost{between(cost(*coarser).steps, cost(level).steps, share),
                  between(cost(*coarser).all, cost(level).all, share)};
    }
    coarser = &level;
  }
  return std::nullopt;
}

/// Why an error is not reached: the order between the last two levels tells whether it ever would be.
std::string short_of(const Json& levels) {
  const Json &last = levels.back(), &before = levels.at(levels.size() - 2);
  const double error = number(last, "relative_l2");
  if (!std::isfinite(error)) return "the finest run breaks";
  const double order =
      std::log(number(before, "relative_l2") / error) / std::log(number(before, "d") / number(last, "d"));
  return fmt::format("{}: {:.2g} at d = {:g} m, order there {:.2f}",
                     order < 0.5 ? "never reached" : "not with these levels", error, number(last, "d"),
                     order);
}

Entry entry(const std::optional<double>& value) {
  return value ? Entry(*value) : Entry();
}

void add_rows(DataTable& table, const Results& results, const Problem& p, const Choice& cloud, double error) {
  const std::string yardstick = id_of(p, cloud, by_id(schemes(), "paper"));
  const auto paper = cost_at(results.json(yardstick).at("levels"), error);
  for (const auto& scheme : schemes()) {
    const std::string id = id_of(p, cloud, scheme);
    const Json levels = results.json(id).at("levels");
    const auto cost = cost_at(levels, error);
    const auto ratio = [&](double Cost::*part) {
      return cost && paper ? std::optional((*cost).*part / (*paper).*part) : std::nullopt;
    };
    table.rows.push_back({p.name, cloud.name, error, scheme.name, cost ? Entry(cost->steps) : Entry(),
                          cost ? Entry(cost->all) : Entry(), entry(ratio(&Cost::steps)),
                          entry(ratio(&Cost::all)), cost ? Entry() : Entry(short_of(levels))});
    table.row_jobs.push_back(id);
    table.jobs.push_back(id);
  }
}

Figure figure_of(const Results& results, const Problem& p, const std::vector<Choice>& all) {
  Picture picture{
      p.name, {"CPU time of the steps", "s", Scale::log}, {"relative error in L₂", "", Scale::log}};
  picture.labels = Labels::legend;
  Figure figure{"work-ratio-" + p.id, {}, "Error against CPU time, lattice and jittered.", {}};
  for (const auto& cloud : all)
    for (const auto& scheme : schemes()) {
      if (cloud.id != "0" && cloud.id != "2") continue;
      const std::string id = id_of(p, cloud, scheme);
      picture.series.push_back(series_of(results.json(id).at("levels"), {}, "cpu_s", "relative_l2",
                                         scheme.id + ", " + cloud.name));
      figure.jobs.push_back(id);
    }
  figure.picture = std::move(picture);
  return figure;
}

Section write(const Results& results, bool long_run) {
  Section s;
  s.question = "What does an error cost by compatible bonds, measured by the paper's scheme?";
  DataTable table{"work-ratio",
                  "CPU time for a relative error in L₂, and its ratio to the paper's scheme",
                  {{"solution"},
                   {"cloud"},
                   {"relative error", "", 1},
                   {"scheme"},
                   {"CPU time of the steps", "s", 3},
                   {"with set-up", "s", 3},
                   {"ratio, steps", "", 3},
                   {"ratio, with set-up", "", 3},
                   {"not reached"}},
                  {}};
  for (const auto& p : problems()) {
    for (const auto& cloud : clouds(long_run))
      for (const double error : {1e-2, 1e-3}) add_rows(table, results, p, cloud, error);
    s.figures.push_back(figure_of(results, p, clouds(long_run)));
  }
  std::size_t own = 0, others = 0, wanted = 0;
  for (const auto& row : table.rows) {
    const bool reached = std::holds_alternative<double>(cell_of(table, row, "CPU time of the steps"));
    const auto scheme = std::get<std::string>(cell_of(table, row, "scheme"));
    if (scheme == by_id(schemes(), "compatible").name) ++wanted, own += reached ? 1 : 0;
    if (scheme == by_id(schemes(), "paper").name) others += reached ? 1 : 0;
  }
  s.tables = {table};
  s.answer = fmt::format(
      "Of {} errors asked for, compatible bonds reach {} and the paper's scheme {} with the levels computed.",
      wanted, own, others);
  s.notes = {
      "Between two levels costs are interpolated in logarithms; nothing is "
      "extrapolated. An error above the coarsest level's costs what that level "
      "costs. One run per level: CPU times are repeatable to some per cent."};
  return s;
}

}  // namespace

/// What an error costs by compatible bonds, in units of what it costs by the paper's scheme.
SectionPlan planned(Extent extent) {
  const bool long_run = extent == Extent::long_run;
  SectionPlan plan{
      415, "work-ratio", "Error against run time: compatible bonds", {}, [long_run](const Results& r) {
        return write(r, long_run);
      }};
  for (const auto& p : problems())
    for (const auto& cloud : clouds(long_run))
      for (const auto& scheme : schemes()) plan.jobs.push_back(job_of(p, cloud, scheme, long_run));
  plan.least = Extent::full;
  return plan;
}

}  // namespace plumb::reports::sections::work_ratio
