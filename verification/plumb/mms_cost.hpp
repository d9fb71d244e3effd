#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "mms/temporal.hpp"
#include "mms/work_precision.hpp"
#include "reports/picture.hpp"

namespace plumb::app {

/// Every combination of what is to be varied, for every study file. Each entry of `vary` is
/// "section.key=value,value,..". Throws InputError.
std::vector<mms::Contender> variants_of(const std::vector<std::string>& files,
                                        const std::vector<std::string>& vary,
                                        const std::vector<std::string>& overrides,
                                        const std::vector<std::string>& solutions);

/// {"threads", "repeats", "points", "cheapest"}.
nlohmann::ordered_json json_of(const mms::WorkPrecision& result, int repeats);
/// Errors over CPU seconds, one line per variant, the Pareto front as points.
reports::Picture work_picture(const mms::WorkPrecision& result);

/// {"study", "d", "n", "reference_step", "spatial_error", "rows", "fits", "status"}.
nlohmann::ordered_json json_of(const Study& study, const mms::TemporalResult& result);
/// Errors over the time step, one line per integrator, and the error of the space discretisation.
reports::Picture temporal_picture(const Study& study, const mms::TemporalResult& result);

}  // namespace plumb::app
