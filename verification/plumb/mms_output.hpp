#pragma once
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "mms/check.hpp"
#include "mms/static_study.hpp"
#include "mms/study.hpp"
#include "reports/picture.hpp"

namespace plumb::app {

/// {"study", "solution", "time", "levels", "fits", "notes", "status"}.
nlohmann::ordered_json json_of(const Study& study, const mms::StudyResult& result);
/// The columns of "levels" that fit a screen: spacing, steps, relative errors of the displacement and its
/// gradient, CPU time; or spacing and the absolute errors.
nlohmann::ordered_json shown(const nlohmann::ordered_json& levels, bool relative);
/// The catalogue: name, summary, dimensions, material, parameters with unit and range.
nlohmann::ordered_json solutions_json();
/// One object per solution, dimension and material.
nlohmann::ordered_json json_of(const std::vector<mms::SolutionCheck>& checks);

/// One fitted order: "norm", "order", "ci95", "pairwise", "drift", "levels", "declared", "verdict".
nlohmann::ordered_json fit_json(const mms::StudyFit& fit);

/// The orders as lines for people.
std::string text_of(const std::vector<mms::StudyFit>& fits);

/// Relative errors over spacing, one line per norm, with the triangle of the declared order.
reports::Picture study_picture(const Study& study, const mms::StudyResult& result);
/// Relative errors of an equilibrium over the spacing.
reports::Picture static_picture(const Study& study, const mms::StaticResult& result);

}  // namespace plumb::app
