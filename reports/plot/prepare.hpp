#pragma once
#include <string>
#include <vector>

#include "reports/picture.hpp"

/// What has to be known before a picture can be drawn: the points that can be shown, the ends of the axes,
/// and the places of labels and slope triangles.
namespace plumb::reports::plot {

/// Ends of an axis, with positions on it as fractions from 0 (low end) to 1.
struct Range {
  double low = 0, high = 1;
  bool log = false;
  double fraction(double value) const;
  double value(double fraction) const;
};

/// Free pixels around the plotting area.
struct Margins {
  double left = 0, right = 0, top = 0, bottom = 0;
};

/// The name of a series beside the right end of its line: from (x, y) in data units to `height` (fraction of
/// the y axis).
struct EndLabel {
  std::size_t series = 0;
  double x = 0, y = 0, height = 0;
};

/// Corners of a slope triangle in data units; the third one is the right angle.
struct Triangle {
  double x[3] = {}, y[3] = {};
  double order = 0;
};

struct Prepared {
  Picture picture;               ///< with the points that cannot be drawn taken out
  std::vector<Dropped> dropped;  ///< what was taken out
  Range x, y;
  std::vector<double> x_borders, y_borders;  ///< of the cells of a map
  Margins margins;
  std::vector<EndLabel> labels;
  std::vector<Triangle> triangles;
  std::vector<std::string> title;  ///< broken into lines that fit
  std::size_t legend_columns = 1, legend_rows = 0;
};

/// Size of the letters, and the width that one takes on average [pixels].
inline constexpr double font_px = 13, letter_px = 7.0, line_px = 17;
/// Height of a row of the legend, as gnuplot spaces it [pixels].
inline constexpr double legend_px = 21;

/// Checks and prepares a picture. @throws InputError as plumb::reports::save().
Prepared prepare(const Picture& picture);

/// Where the cells around rising grid points end: halfway between them, on the axis as drawn.
std::vector<double> cell_borders(const std::vector<double>& grid, bool log);

/// The text in lines of at most `letters` letters, broken at spaces.
std::vector<std::string> wrap(const std::string& text, std::size_t letters);

/// Number of letters (code points of UTF-8).
std::size_t letters(const std::string& text);

}  // namespace plumb::reports::plot
