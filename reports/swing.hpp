#pragma once
#include <vector>

namespace plumb::reports {

/// The last swing of a motion that comes and goes: what benchmarks of undamped motion print.
struct Swing {
  double mean;       ///< half the sum of its highest and its lowest value
  double amplitude;  ///< half their difference
  double frequency;  ///< one over the time between its lowest point and the one before
};

/// The last swing of a series: from its last low point back to the one before, with the highest value between
/// them, each from the parabola through the three rows around it. Low points are those below the middle of the
/// range of all values, one for each stay there, so that small wiggles do not count. Rows at equal intervals of
/// time.
/// @throws MissingResult if there are no two.
Swing last_swing(const std::vector<double>& time, const std::vector<double>& value);

/// The swing that goes from the lowest to the highest value of the whole series, with the frequency of the last one. Where a
/// motion beats, no single swing goes so far.
/// @throws MissingResult where last_swing() does.
Swing widest_swing(const std::vector<double>& time, const std::vector<double>& value);

}  // namespace plumb::reports
