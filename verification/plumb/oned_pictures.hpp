#pragma once
#include <vector>

#include "oned/explorer.hpp"
#include "oned/response.hpp"
#include "oned/study.hpp"
#include "reports/picture.hpp"

namespace plumb::app {

/// W, W0 and W1 over the support, or the five gradients.
reports::Picture kernel_picture(const oned::KernelView& view, bool gradients);

/// Exact derivative and estimates over X, or their errors.
reports::Picture gradient_picture(const std::vector<oned::GradientRow>& rows, bool errors);

/// RMSE over dx, with a slope triangle where a fit is asymptotic.
reports::Picture study_picture(const oned::RefinementStudy& study);

/// Response over theta, with the exact line.
reports::Picture response_picture(const std::vector<oned::ResponseRow>& rows);

}  // namespace plumb::app
