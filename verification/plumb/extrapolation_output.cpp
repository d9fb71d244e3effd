#include "verification/plumb/extrapolation_output.hpp"

#include <fmt/format.h>

#include "lib/convergence/least_squares.hpp"
#include "lib/convergence/words.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const GridFit& fit) {
  Json grids = Json::array();
  for (const GridUncertainty& grid : fit.grids)
    grids.push_back({{"spacing", grid.spacing},
                     {"value", grid.value},
                     {"fitted", grid.fitted},
                     {"error", grid.error},
                     {"uncertainty", grid.uncertainty}});
  return {{"expansion", name_of(fit.expansion)},
          {"weighted", fit.weighted},
          {"order", fit.order ? Json(*fit.order) : Json()},
          {"limit", fit.limit},
          {"deviation", fit.deviation},
          {"range", fit.range},
          {"safety", fit.safety},
          {"uncertainty", fit.grids.front().uncertainty},
          {"grids", grids}};
}

std::string text_of(const GridFit& fit) {
  const GridUncertainty& finest = fit.grids.front();
  return fmt::format(
      "\nleast squares over {} grids (Eca and Hoekstra 2014): {}{}\n"
      "  order of the power law {}\n"
      "  value at spacing 0: {:.10g}\n"
      "  standard deviation {:.4g}, data range {:.4g}, safety factor {:g}\n"
      "  finest grid: {:.10g} +- {:.4g}\n",
      fit.grids.size(), name_of(fit.expansion), fit.weighted ? ", weights 1/h" : "",
      fit.order ? fmt::format("{:.4f}", *fit.order) : "not between 0.01 and 20", fit.limit, fit.deviation,
      fit.range, fit.safety, finest.value, finest.uncertainty);
}

/// "0.1031 %, 0.3562 %" or "0.001, 0.0034".
std::string list_of(const std::vector<GridIndex>& all, bool relative) {
  std::string text;
  for (const GridIndex& index : all) {
    if (!text.empty()) text += ", ";
    if (!relative)
      text += fmt::format("{:.4g}", index.absolute);
    else
      text += index.relative ? fmt::format("{:.4g} %", 100 * *index.relative) : "none (the value is 0)";
  }
  return text;
}

std::string text_of(const Extrapolation& found, bool four) {
  const std::string ratio = found.asymptotic_ratio
                                ? fmt::format("{:.4f} (1 in the asymptotic range)", *found.asymptotic_ratio)
                            : four ? "none (the coarser three grids have no order)"
                                   : "none (1 by construction with three grids; give a fourth, or --order)";
  return fmt::format(
      "observed order {:.4f}\n"
      "value at spacing 0: {:.10g}, in the unit of the values\n"
      "grid convergence index of each pair, finest first\n"
      "  relative to the finer value (ASME V&V 20): {}\n"
      "  absolute, in the unit of the values: {}\n"
      "asymptotic ratio: {}\n",
      found.order, found.limit, list_of(found.gci, true), list_of(found.gci, false), ratio);
}

/// Whether three grids could be extrapolated: that is all that is judged.
std::string_view status_of(Extrapolation::Behaviour behaviour) {
  if (behaviour == Extrapolation::Behaviour::divergent) return "fail";
  return behaviour == Extrapolation::Behaviour::oscillatory ? "inconclusive" : "pass";
}

}  // namespace

Extrapolated extrapolated(const std::vector<Sample>& samples, double safety,
                          std::optional<double> declared_order) {
  const Extrapolation found = richardson(samples, safety, declared_order);
  const bool monotone = found.behaviour == Extrapolation::Behaviour::monotone, four = samples.size() >= 4;
  Json relative = Json::array(), absolute = Json::array();
  for (const GridIndex& index : found.gci) {
    relative.push_back(index.relative ? Json(*index.relative) : Json());
    absolute.push_back(index.absolute);
  }
  Extrapolated out;
  out.status = status_of(found.behaviour);
  out.text = monotone
                 ? text_of(found, four)
                 : fmt::format("{}: {}\n", name_of(found.behaviour), meaning_of(name_of(found.behaviour)));
  out.json = {{"behaviour", name_of(found.behaviour)},
              {"order", found.order},
              {"limit", found.limit},
              {"gci", relative},
              {"gci_absolute", absolute},
              {"gci_fine",
               found.gci.empty() ? Json() : absolute.front()},  // of the two finest pairs, for older readers
              {"gci_coarse", found.gci.size() < 2 ? Json() : absolute.at(1)},
              {"asymptotic_ratio", found.asymptotic_ratio ? Json(*found.asymptotic_ratio) : Json()},
              {"safety", safety},
              {"least_squares", Json()},
              {"uncertainty", Json()},
              {"status", out.status}};
  if (four) {
    const GridFit fit = fit_grids(samples);
    out.text += text_of(fit);
    out.json["least_squares"] = json_of(fit);
    out.json["uncertainty"] = fit.grids.front().uncertainty;
  }
  out.text += fmt::format("status: {}\n", out.status);
  return out;
}

}  // namespace plumb::app
