#pragma once
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "verification/plumb/claims/ledger.hpp"

namespace plumb::app::claims {

/// The entry of a result at a path of steps between slashes: a key ("energy/relative_change"), an index
/// ("levels/3/l2"), or the first object of a list that has the given entries
/// ("rows/estimator=improved;n=40/rmse"). Throws InputError if there is none.
const nlohmann::ordered_json& entry_at(const nlohmann::ordered_json& result, const std::string& path);

/// The columns of a CSV file of numbers by their headings, as {"time [s]": [0, 0.01], ..}. Throws InputError
/// if it is not one.
nlohmann::ordered_json columns_of(const std::string& csv);

/// The JSON of `plumb COMMAND`; of a run that wrote a series with its columns_of() as "series".
using RunCommand = std::function<nlohmann::ordered_json(const std::string& command)>;

/// The value of a reading, measured anew. Throws InputError if its command gives no such number.
double measured(const Reading& reading, const RunCommand& run);

/// One reading measured again.
struct Remeasured {
  const Claim* claim;
  const Reading* reading;
  double value;
  bool same;  ///< as recorded, to the reading's tolerance
};

struct CheckResult {
  std::vector<Remeasured> readings;
  std::vector<std::string> changes;  ///< numbers and statuses that are not what the ledger says
};

/// Measures the readings again, the long ones only if `long_too`, and compares numbers and statuses.
CheckResult check(const std::vector<Claim>& claims, bool long_too, const RunCommand& run,
                  const std::function<void(double, const std::string&)>& progress);

}  // namespace plumb::app::claims
