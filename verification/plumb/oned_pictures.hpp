#pragma once
#include <string>
#include <utility>
#include <vector>

#include "oned/explorer.hpp"
#include "oned/function.hpp"
#include "oned/profile.hpp"
#include "oned/response.hpp"
#include "oned/study.hpp"
#include "reports/picture.hpp"

namespace plumb::app {

/// Rows with the name of their variant (OnedVariant::named), empty where there is one only.
template <class Row>
using OfVariants = std::vector<std::pair<std::string, std::vector<Row>>>;

/// W, W0 and W1 over the support as curves with the particles on them, or the five gradients.
reports::Picture kernel_picture(const oned::Discretisation& discretisation, const oned::KernelView& view,
                                bool gradients);

/// alpha, beta R, sum V W and the negative share along the body; of several variants alpha alone.
reports::Picture correction_picture(const oned::Discretisation& discretisation,
                                    const OfVariants<oned::ProfileRow>& rows);

/// The function and its estimates over X.
reports::Picture function_picture(const oned::Discretisation& discretisation,
                                  const OfVariants<oned::FunctionRow>& rows);

/// Exact derivative and estimates over X, or their errors.
reports::Picture gradient_picture(const oned::Discretisation& discretisation,
                                  const OfVariants<oned::GradientRow>& rows, bool errors);

/// RMSE over dx, with a slope triangle where a fit is asymptotic.
reports::Picture study_picture(const std::vector<std::pair<std::string, oned::RefinementStudy>>& studies);

/// Response over theta, with the exact line.
reports::Picture response_picture(const OfVariants<oned::ResponseRow>& rows);

/// "standard W1, sin:5: rms 0.01, inside 2e-3, near the ends 0.1 at most": one line.
std::string errors_text(const std::string& of, const oned::GradientErrors& errors);

}  // namespace plumb::app
