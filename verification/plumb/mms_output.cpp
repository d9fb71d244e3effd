#include "verification/plumb/mms_output.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "lib/convergence/norm_units.hpp"
#include "mms/level.hpp"
#include "mms/manufactured.hpp"
#include "verification/plumb/fit_text.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

Json level_json(const Study& study, const mms::StudyLevel& level) {
  Json row{{"n", level.n}, {"d", level.spacing}, {"dt", level.dt}, {"steps", level.steps}};
  for (const std::string& norm : mms::norms_of(study))
    row["relative_" + norm] = mms::norm_of(level, norm) / mms::size_of(level, norm);
  for (const std::string& norm : mms::norms_of(study)) row[norm] = mms::norm_of(level, norm);
  row["cpu_s"] = level.cpu_s;
  row["wall_s"] = level.wall_s;
  row["setup_s"] = level.setup_s;
  row["pair_evaluations"] = level.pair_evaluations;
  if (level.failure) row["status"] = "unstable: " + *level.failure;
  return row;
}

/// "l2_gauss" as "L2, Gauss".
std::string norm_text(std::string norm) {
  const bool gauss = norm.ends_with("_gauss");
  if (gauss) norm.erase(norm.size() - 6);
  for (const mms::NormName& known : mms::norm_names)
    if (known.name == norm) return fmt::format("{}, {}", known.meaning, gauss ? "Gauss" : "nodal");
  return norm;
}

/// What fits a screen and a picture: displacements and their gradient.
bool drawn(const std::string& norm) {
  return !norm.starts_with("velocity") && !norm.starts_with("stress");
}

}  // namespace

Json fit_json(const mms::StudyFit& fit) {
  const OrderFit& f = fit.fit;
  return {{"norm", fit.norm},
          {"order", f.order},
          {"ci95", {f.lower, f.upper}},
          {"pairwise", f.pairwise},
          {"drift", f.drift},
          {"levels", f.levels.size()},
          {"declared", fit.declared ? Json(*fit.declared) : Json(nullptr)},
          {"modelling_floor", fit.modelling_floor},
          {"verdict", fit.verdict}};
}

Json json_of(const Study& study, const mms::StudyResult& result) {
  Json levels = Json::array(), fits = Json::array();
  for (const auto& level : result.levels) levels.push_back(level_json(study, level));
  for (const auto& fit : result.fits) fits.push_back(fit_json(fit));
  Json out{{"study", study.name},  {"solution", study.solution},   {"parameters", study.parameters},
           {"force", study.force}, {"time", mms::end_time(study)}, {"levels", levels},
           {"fits", fits}};
  Json units = Json::object();
  for (const std::string& norm : mms::norms_of(study)) units[norm] = unit_of_norm(norm, study.dimension());
  out["units"] = units;
  if (study.expect) out["reason"] = study.expect->reason;
  out["notes"] = result.notes;
  out["status"] = result.status;
  return out;
}

Json shown(const Json& levels, bool relative) {
  constexpr std::string_view prefix = "relative_";
  Json rows = Json::array();
  for (const auto& level : levels) {
    Json row;
    for (const auto& [key, value] : level.items()) {
      const bool is_relative = key.starts_with(prefix);
      const std::string norm = is_relative ? key.substr(prefix.size()) : key;
      const bool is_norm = !unit_of_norm(norm, 2).empty();
      if (is_norm ? drawn(norm) && is_relative == relative
                  : key == "n" || key == "d" || key == "status" ||
                        (relative && (key == "dt" || key == "steps" || key == "cpu_s")))
        row[key] = value;
    }
    rows.push_back(row);
  }
  return rows;
}

std::string text_of(const std::vector<mms::StudyFit>& fits) {
  std::vector<FitLine> lines;
  for (const auto& fit : fits) lines.push_back({fit.norm, fit.fit, fit.declared, fit.verdict});
  return fits_text(lines);
}

Json solutions_json() {
  Json solutions = Json::array();
  for (const auto& entry : mms::solution_list()) {
    Json parameters = Json::array();
    for (const auto& p : entry.parameters.all())
      parameters.push_back({{"name", p.name},
                            {"default", p.value},
                            {"unit", p.unit},
                            {"range", {p.least, p.most}},
                            {"meaning", p.meaning}});
    solutions.push_back({{"name", entry.name},
                         {"summary", entry.summary},
                         {"dimensions", entry.dimensions},
                         {"material",
                          {{"young", entry.material.young},
                           {"poisson", entry.material.poisson},
                           {"density", entry.material.density}}},
                         {"parameters", parameters}});
  }
  return {{"solutions", solutions}};
}

Json json_of(const std::vector<mms::SolutionCheck>& checks) {
  Json rows = Json::array();
  for (const auto& check : checks)
    rows.push_back({{"solution", check.solution},
                    {"dimension", check.dimension},
                    {"material", check.material},
                    {"points", check.points},
                    {"force", check.force},
                    {"traction", check.traction},
                    {"velocity", check.velocity},
                    {"status", check.passed ? "pass" : "fail"}});
  return rows;
}

reports::Picture study_picture(const Study& study, const mms::StudyResult& result) {
  reports::Picture picture;
  picture.title = fmt::format("{}: error at t = {:.4g} s", study.name, mms::end_time(study));
  picture.x = {"spacing", "m", reports::Scale::log};
  picture.y = {"relative error", "", reports::Scale::log};
  picture.labels = reports::Labels::legend;
  for (const auto& fit : result.fits) {
    if (!drawn(fit.norm)) continue;
    reports::Series series;
    series.label = norm_text(fit.norm);
    for (const auto& level : result.levels) {
      series.x.push_back(level.spacing);
      series.y.push_back(mms::norm_of(level, fit.norm) / mms::size_of(level, fit.norm));
    }
    if (fit.declared && picture.triangles.empty())
      picture.triangles.push_back({*fit.declared, picture.series.size()});
    picture.series.push_back(series);
  }
  return picture;
}

reports::Picture static_picture(const Study& study, const mms::StaticResult& result) {
  reports::Picture picture;
  picture.title = fmt::format("{}: error of the equilibrium", study.name);
  picture.x = {"spacing", "m", reports::Scale::log};
  picture.y = {"relative error", "", reports::Scale::log};
  picture.labels = reports::Labels::legend;
  for (const mms::NormName& norm : mms::static_norms()) {
    reports::Series series;
    series.label = norm_text(std::string(norm.name));
    for (const mms::StaticLevel& level : result.levels) {
      series.x.push_back(level.spacing);
      series.y.push_back(level.relative(norm.value));
    }
    picture.series.push_back(series);
  }
  return picture;
}

}  // namespace plumb::app
