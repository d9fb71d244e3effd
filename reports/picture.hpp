#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// A picture as a value: what is to be seen, without a word about how it is drawn. `save` draws it through
/// gnuplot.
namespace plumb::reports {

enum class Scale { linear, log };
enum class Style { lines, points, both };
/// Where the names of the series stand: beside the right end of each line, or in a legend below the picture
/// (for lines that end in the same place).
enum class Labels { ends, legend };

/// One axis. `unit` is written in brackets behind the label; write "1" or leave it empty for a pure number.
struct Axis {
  std::string label;
  std::string unit = {};
  Scale scale = Scale::linear;
  std::optional<double> min = {}, max = {};  ///< ends of the axis; from the data if not given
  std::vector<double> ticks = {};            ///< where to put numbers; chosen by itself if empty
};

/// An interval around a line, for instance of 95 % confidence: low[k] <= y <= high[k] at the x[k] of its
/// series.
struct Band {
  std::vector<double> low, high;
};

/// One line or cloud of points y[k] over x[k].
struct Series {
  std::string label;
  std::vector<double> x, y;
  Style style = Style::both;
  std::optional<Band> band = {};
  std::optional<std::size_t> colour = {};  ///< number in the palette; the place in the list if not given
  bool dashed = false;
  bool hollow = false;  ///< points are outlines
};

/// A triangle of the given slope below series number `series`, on two logarithmic axes: what a declared order
/// looks like.
struct SlopeTriangle {
  double order = 2;
  std::size_t series = 0;
};

/// A straight line across the picture at x = at (vertical) or y = at.
struct ReferenceLine {
  double at = 0;
  std::string label = {};
  bool vertical = false;
};

/// Coloured cells around the grid points (x[i], y[j]); value z[j * x.size() + i]. Cells without a finite
/// value stay empty.
struct HeatMap {
  std::vector<double> x, y, z;
  std::string label;
  std::string unit = {};
  Scale scale = Scale::linear;
};

/// The same grid with a named category in each cell: z[..] is a place in `names`, a negative number leaves it
/// empty.
struct CategoryMap {
  std::vector<double> x, y;
  std::vector<int> z;
  std::vector<std::string> names;
};

/// A body as its particles: at (x[k], y[k]) a square of edge `size` (in units of the axes) coloured by z[k],
/// later ones over earlier ones.
struct PointMap {
  std::vector<double> x, y, z;
  double size = 1;
  std::string label;
  std::string unit = {};
};

/// Rows with a name, a value and its interval low <= value <= high, the first one on top; `expected[k]`, if
/// it is finite, is marked. The y axis shows the names.
struct Intervals {
  std::vector<std::string> names;
  std::vector<double> low, value, high, expected;
};

/// A labelled line of known length, which shows direction and scale where axes would say nothing.
struct Rod {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  std::string label = {};
};

/// The surface of a body as quadrilaterals with corners (x[4k..4k+3], y[4k..4k+3]), later ones over earlier
/// ones, coloured by z[k] on a scale from `low` to `high` (from the data if not given). Rods replace the
/// axes.
struct Patches {
  std::vector<double> x, y, z;
  std::string label;
  std::string unit = {};
  std::optional<double> low = {}, high = {};
  std::vector<Rod> rods = {};
};

/// The whole picture. Sizes are in pixels; the default is readable on a telephone and two fit side by side on
/// a desk.
struct Picture {
  std::string title;
  Axis x, y;
  std::vector<Series> series = {};
  Labels labels = Labels::ends;
  std::vector<SlopeTriangle> triangles = {};
  std::vector<ReferenceLine> lines = {};
  std::variant<std::monostate, HeatMap, CategoryMap, PointMap, Intervals, Patches> map = {};
  bool equal_axes = false;  ///< one unit of x as long as one of y (outlines of bodies)
  int width = 560, height = 380;
};

/// Points that could not be drawn: not finite, or not positive on a logarithmic axis. The picture says so
/// below itself.
struct Dropped {
  std::string series;
  std::size_t points = 0;
  std::string why;
};

/// Draws `picture` into `file`, as SVG or PNG by its ending (.svg, .png). The same picture gives the same
/// bytes. SVG text and lines follow the reader's dark mode.
/// @return what had to be left out.
/// @throws InputError if the ending is another, the file cannot be written, gnuplot is missing, lists differ
/// in length,
///         a series has no point that can be drawn, or a slope triangle stands on linear axes.
std::vector<Dropped> save(const Picture& picture, const std::filesystem::path& file);

/// The lines of the picture in letters, so many columns wide, by gnuplot's terminal "dumb": for a look at a
/// terminal. nullopt if it has a map or gnuplot is not installed.
std::optional<std::string> with_letters(const Picture& picture, std::size_t columns);

/// The picture as SVG text. `prefix` starts every id inside, so that several pictures can share one page.
/// @throws InputError as save().
std::string svg(const Picture& picture, const std::string& prefix = "plumb");

/// The lists of numbers behind the picture as CSV: series,x,y,low,high, x,y,value of a map, or
/// name,low,value,high,expected of intervals (17 significant digits).
std::string data_csv(const Picture& picture);

}  // namespace plumb::reports
