#include "verification/plumb/oned_study.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "lib/convergence/status.hpp"
#include "oned/study.hpp"
#include "verification/plumb/drawing.hpp"
#include "verification/plumb/fit_text.hpp"
#include "verification/plumb/oned_options.hpp"
#include "verification/plumb/oned_pictures.hpp"
#include "verification/plumb/run/sittings.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
  return value;
}
Json number(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json study_row(const oned::StudyRow& r) {
  Json row{{"n", r.n},
           {"dx", r.dx},
           {"radius", r.radius},
           {"field", r.field},
           {"estimator", r.estimator},
           {"pair", name_of(r.pair)},
           {"rmse", r.norms.rmse},
           {"max", r.norms.max},
           {"interior_rmse", number(r.norms.interior_rmse)},
           {"interior_max", number(r.norms.interior_max)},
           {"boundary_max", number(r.norms.boundary_max)},
           {"cpu_s", number(r.cpu_s)}};
  if (!r.norms.interior_rmse) row["status"] = "no interior particles: 2R <= X <= L - 2R is empty";
  return row;
}

Json study_fit(const oned::StudyFit& f) {
  Json fit{{"field", f.field},
           {"estimator", f.estimator},
           {"pair", name_of(f.pair)},
           {"norm", f.norm},
           {"order", f.fit.order},
           {"ci95", {f.fit.lower, f.fit.upper}},
           {"pairwise", f.fit.pairwise},
           {"drift", f.fit.drift},
           {"levels", f.fit.levels.size()},
           {"verdict", name_of(f.trend)}};
  return fit;
}

/// Of the norms over the whole body: interior and boundary need not exist on every level.
std::string_view status_of(const std::vector<oned::StudyFit>& fits) {
  std::vector<Judged> judged;
  for (const auto& fit : fits)
    if (fit.norm == "rmse" || fit.norm == "max") judged.push_back({name_of(fit.trend), false});
  return plumb::status_of(judged);
}

/// The warnings of all levels, each text once.
std::vector<std::string> study_warnings(const OnedOptions& options,
                                        const std::vector<oned::TestField>& fields) {
  std::vector<std::string> all;
  oned::Discretisation level = options.discretisation();
  for (const Index n : options.n) {
    level.n = n;
    for (const auto& text : oned::warnings(level, fields))
      if (std::find(all.begin(), all.end(), text) == all.end()) all.push_back(text);
  }
  return all;
}

int study(const Session& session, OnedOptions options, const SittingOptions& where) {
  if (options.n.empty()) options.n = {20, 40, 80, 160, 320};
  const auto fields = options.parsed_fields();
  double particles = 0;
  for (const Index n : options.n) particles += static_cast<double>(n);
  Progress progress("oned study", session.progress());
  const auto result =
      in_one_sitting(session, where, {}, {parameters_of(options).dump()}, [&](Sitting& sitting) {
        sitting.tell(particles * static_cast<double>(fields.size() * options.methods().size()),
                     told(progress));
        return oned::refine(options.discretisation(), options.n, fields, options.methods(), sitting);
      });
  progress.finish();
  warn(session, study_warnings(options, fields));
  Json rows = Json::array(), fits = Json::array();
  for (const auto& r : result.rows) rows.push_back(study_row(r));
  session.write_table(rows);
  std::vector<FitLine> lines;
  for (const auto& f : result.fits) {
    fits.push_back(study_fit(f));
    lines.push_back({fmt::format("{} {} {} {}", f.field, f.estimator, name_of(f.pair), f.norm), f.fit,
                     std::nullopt, std::string(name_of(f.trend))});
  }
  const std::string_view status = status_of(result.fits);
  session.text() << '\n' << fits_text(lines) << "status: " << status << '\n';
  session.write_json(
      {{"parameters", parameters_of(options)}, {"rows", rows}, {"fits", fits}, {"status", status}});
  draw(session, study_picture(result));
  return exit_code_of(status);
}

}  // namespace

void add_oned_study(CLI::App& group, Session& session) {
  const auto options = std::make_shared<OnedOptions>();
  const auto where = std::make_shared<SittingOptions>();
  CLI::App& command = add_command(
      group, session,
      {"study", "error under refinement, with fitted orders",
       "plumb oned study --field poly:1,0,0,1 --n 20,40,80,160 --estimator improved --pair W1 --json -"},
      {.table = true, .plot = true}, [&session, options, where] { return study(session, *options, *where); });
  add_cloud_options(command, *options, true);
  add_field_option(command, *options);
  add_method_options(command, *options);
  add_sitting_options(command, *where);
  point_to_verdicts(command);
}

}  // namespace plumb::app
