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
std::vector<std::string> study_warnings(const OnedOptions& options, oned::Discretisation level,
                                        const std::vector<oned::TestField>& fields) {
  std::vector<std::string> all;
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
  const auto variants = options.variants();
  Progress progress("oned study", session.progress());
  const auto studies =
      in_one_sitting(session, where, {}, {parameters_of(options).dump()}, [&](Sitting& sitting) {
        sitting.tell(
            particles * static_cast<double>(fields.size() * options.methods().size() * variants.size()),
            told(progress));
        std::vector<std::pair<std::string, oned::RefinementStudy>> all;
        for (const OnedVariant& variant : variants)
          all.emplace_back(variant.named(""), oned::refine(variant.discretisation, options.n, fields,
                                                           options.methods(), sitting));
        return all;
      });
  progress.finish();
  Json rows = Json::array(), fits = Json::array();
  std::vector<FitLine> lines;
  std::vector<oned::StudyFit> judged;
  for (std::size_t v = 0; v < variants.size(); ++v) {
    warn(session, study_warnings(options, variants[v].discretisation, fields));
    const oned::RefinementStudy& study = studies[v].second;
    for (const auto& r : study.rows) {
      rows.push_back(study_row(r));
      rows.back().update(variants[v].keys);
    }
    for (const auto& f : study.fits) {
      fits.push_back(study_fit(f));
      fits.back().update(variants[v].keys);
      lines.push_back(
          {variants[v].named(fmt::format("{} {} {} {}", f.field, f.estimator, name_of(f.pair), f.norm)),
           f.fit, std::nullopt, std::string(name_of(f.trend))});
      judged.push_back(f);
    }
  }
  session.write_table(rows);
  const std::string_view status = status_of(judged);
  session.text() << '\n' << fits_text(lines) << "status: " << status << '\n';
  session.write_json(
      {{"parameters", parameters_of(options)}, {"rows", rows}, {"fits", fits}, {"status", status}});
  draw(session, study_picture(studies));
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
  add_cloud_options(command, *options, {.n = true, .variants = true});
  add_field_option(command, *options);
  add_method_options(command, *options);
  add_sitting_options(command, *where);
  point_to_verdicts(command);
}

}  // namespace plumb::app
