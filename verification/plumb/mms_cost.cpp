#include "verification/plumb/mms_cost.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "lib/convergence/norm_units.hpp"
#include "lib/core/error.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

/// One key with the values that it takes.
struct Axis {
  std::string key;
  std::vector<std::string> values;
};

Axis read_axis(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals + 1 == text.size())
    throw InputError("--vary " + text, "no value to vary",
                     "Write --vary method.momentum=adjoint,symmetrised.");
  Axis axis{text.substr(0, equals), {}};
  for (std::size_t at = equals + 1; at <= text.size();) {
    const auto comma = std::min(text.find(',', at), text.size());
    axis.values.push_back(text.substr(at, comma - at));
    at = comma + 1;
  }
  return axis;
}

/// A combination: what to set, and its name.
struct Choice {
  std::string label;
  std::vector<std::string> set;
};

std::vector<Choice> combinations(const std::vector<std::string>& vary) {
  std::vector<Choice> all{{}};
  for (const auto& text : vary) {
    const Axis axis = read_axis(text);
    std::vector<Choice> longer;
    for (const auto& choice : all)
      for (const auto& value : axis.values) {
        Choice next = choice;
        const std::string key = axis.key.substr(axis.key.rfind('.') + 1);
        const bool is_number = value.find_first_not_of("0123456789.+-e") == std::string::npos;
        if (!next.label.empty()) next.label += ", ";
        next.label += is_number ? fmt::format("{} {}", key, value) : value;
        next.set.push_back(axis.key + "=" + value);
        longer.push_back(next);
      }
    all = std::move(longer);
  }
  return all;
}

/// Nothing is declared of costs. A run that broke is a failure, one that could not be built is not computed.
std::string_view status_of(const mms::WorkPrecision& result) {
  std::string_view status = "undeclared";
  for (const auto& point : result.points)
    if (point.failure) status = point.refused && status != "fail" ? "inconclusive" : "fail";
  return status;
}

Json number_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

}  // namespace

std::vector<mms::Contender> variants_of(const std::vector<std::string>& files,
                                        const std::vector<std::string>& vary,
                                        const std::vector<std::string>& overrides,
                                        const std::vector<std::string>& solutions) {
  std::vector<mms::Contender> variants;
  for (const auto& file : files)
    for (const auto& choice : combinations(vary)) {
      std::vector<std::string> set = overrides;
      set.insert(set.end(), choice.set.begin(), choice.set.end());
      const Study study = read_study(file, set, solutions, StudyOf::cost);
      std::string label = choice.label.empty() ? study.name : choice.label;
      if (files.size() > 1 && !choice.label.empty()) label = fmt::format("{}: {}", study.name, label);
      variants.push_back({label, study});
    }
  return variants;
}

Json json_of(const mms::WorkPrecision& result, int repeats) {
  Json points = Json::array(), cheapest = Json::array();
  for (const auto& p : result.points) {
    Json row{{"method", result.labels[p.variant]},
             {"d", p.spacing},
             {"error", number_or_null(p.error)},
             {"cpu_s", number_or_null(p.cpu_s)},
             {"cpu_spread_s", p.cpu_spread_s},
             {"wall_s", number_or_null(p.wall_s)},
             {"pair_evaluations", p.pair_evaluations},
             {"front_cpu", p.front_cpu},
             {"front_work", p.front_work}};
    if (p.failure) row["status"] = (p.refused ? "refused: " : "unstable: ") + *p.failure;
    points.push_back(row);
  }
  for (const auto& c : result.cheapest)
    cheapest.push_back(
        {{"error", c.error}, {"measure", c.measure}, {"method", result.labels[c.variant]}, {"cost", c.cost}});
  return {{"threads", omp_get_max_threads()},
          {"repeats", repeats},
          {"points", points},
          {"cheapest", cheapest},
          {"status", status_of(result)}};
}

reports::Picture work_picture(const mms::WorkPrecision& result) {
  reports::Picture picture;
  picture.title = "Error against run time";
  picture.x = {"CPU time", "s", reports::Scale::log};
  picture.y = {"relative L2 error", "", reports::Scale::log};
  picture.labels = reports::Labels::legend;
  for (std::size_t v = 0; v < result.labels.size(); ++v) {
    reports::Series series;
    series.label = result.labels[v];
    for (const auto& p : result.points)
      if (p.variant == v && std::isfinite(p.error)) series.x.push_back(p.cpu_s), series.y.push_back(p.error);
    if (!series.x.empty()) picture.series.push_back(series);
  }
  reports::Series front;
  front.label = "Pareto front";
  front.style = reports::Style::points;
  for (const auto& p : result.points)
    if (p.front_cpu) front.x.push_back(p.cpu_s), front.y.push_back(p.error);
  if (!front.x.empty()) picture.series.push_back(front);
  return picture;
}

Json json_of(const Study& study, const mms::TemporalResult& result) {
  Json rows = Json::array(), fits = Json::array();
  for (const auto& order : result.orders) {
    for (std::size_t k = 0; k < order.levels.size(); ++k) {
      const Level& level = order.levels[k];
      Json row{{"integrator", order.integrator}, {"dt", level.spacing}, {"l2", number_or_null(level.error)}};
      row["status"] = mms::at_floor(order, k) ? "at-floor" : "fitted";
      rows.push_back(row);
    }
    const OrderFit& f = order.fit;
    fits.push_back({{"integrator", order.integrator},
                    {"order", number_or_null(f.order)},
                    {"ci95", {number_or_null(f.lower), number_or_null(f.upper)}},
                    {"levels", f.levels.size()},
                    {"declared", order.declared},
                    {"verdict", order.verdict}});
  }
  return {{"study", study.name},
          {"d", result.spacing},
          {"n", result.n},
          {"reference_step", result.reference_step},
          {"spatial_error", result.spatial_error},
          {"units", {{"l2", unit_of_norm("l2", study.dimension())}}},
          {"rows", rows},
          {"fits", fits},
          {"notes", study.unused},
          {"status", result.status}};
}

reports::Picture temporal_picture(const Study& study, const mms::TemporalResult& result) {
  reports::Picture picture;
  picture.title = fmt::format("{}: error of the time steps at d = {:g} m", study.name, result.spacing);
  picture.x = {"time step", "s", reports::Scale::log};
  picture.y = {"L2 difference to the fine-step run", unit_of_norm("l2", study.dimension()),
               reports::Scale::log};
  picture.labels = reports::Labels::legend;
  for (const auto& order : result.orders) {
    reports::Series series;
    series.label = fmt::format("{}: order {:.2f}", order.integrator, order.fit.order);
    for (const auto& level : order.levels) series.x.push_back(level.spacing), series.y.push_back(level.error);
    picture.series.push_back(series);
  }
  picture.lines.push_back({result.spatial_error, "error in space"});
  return picture;
}

}  // namespace plumb::app
