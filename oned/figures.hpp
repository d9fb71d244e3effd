#pragma once
#include <string>
#include <vector>

#include "oned/study.hpp"

namespace plumb::oned {

/// One line of a chart.
struct Curve {
  std::string label;
  std::vector<double> x, y;
};

/// The data of one picture.
struct Chart {
  std::string name;   ///< "figure-2a": for file names
  std::string title;  ///< what is shown, with the numbers that define it
  std::string x_label, x_unit, y_label, y_unit;
  std::vector<Curve> curves;
  bool log_x = false, log_y = false;
  std::vector<std::string> notes;  ///< what the data say, with fitted orders where there are any
};

/// How R behaves while N grows in Figure 6. The text does not say; only one reading fits its sentences.
enum class Reading {
  fixed_ratio,  ///< R = 4 dx
  fixed_radius  ///< R = 0.5 m, which is 4 dx at the paper's dx = 1/8 m
};

/// Figure 2 of paper 000: W, W0, W1 and the five gradients at x = 1 m (a, b) and x = 0 (c, d); body (0, 2), N
/// = 200, R = 1 m.
std::vector<Chart> figure_2();

/// Figure 4: x = X + 1 on (0, 5), dx = 1/8 m, R = 4 dx, W1: the field (a) and three estimates of its gradient
/// (b).
std::vector<Chart> figure_4();

/// Figure 5: gradients of X^2 + 1 (a) and X^3 + 1 (b) by the standard estimate with W1 and the improved one
/// with W1 and W0, and their errors (c, d), which the paper's figure does not resolve.
std::vector<Chart> figure_5();

/// The studies behind Figure 6: X^3 + 1 and sin(5X), the three methods of Figure 5, N = 40 to 5120.
Study figure_6_study(Reading reading);
/// Figure 6 in one reading: RMSE of the gradient over N for X^3 + 1 (a) and sin(5X) (b).
std::vector<Chart> figure_6(Reading reading);

/// Error against CPU time from the rows of a study: one chart per field.
std::vector<Chart> cost_charts(const Study& study, const std::string& name);

/// Response of standard, bond and improved to exp(ikX) at R = 4 dx, with the exact line.
Chart response_chart();

}  // namespace plumb::oned
