#pragma once
#include <map>
#include <nlohmann/json.hpp>

#include "verification/plumb/bench/cases.hpp"
#include "verification/plumb/bench/machine.hpp"

/// What `plumb-house bench` writes, from what it has measured.
namespace plumb::app::bench {

using Json = nlohmann::ordered_json;

/// Limits of the machine by number of threads; that of one core must be there.
Json json_of(const std::map<int, Machine>& machines);

/// One measured run; shares of what as many cores can do, both in wall time.
Json row_of(const Case& c, const Speed& s, const Machine& machine);

/// Wall time on one thread over that on more, for every case and size that was run on both.
Json speed_ups_of(const Json& rows);

/// CPU time of one evaluation for all particles, and of the set-up [s].
double of_an_evaluation(const Json& row);
double of_the_setup(const Json& row);

/// Slope of log(cost) over log(N), by case, where there are two sizes or more on one thread.
Json exponents_of(const Json& rows, double (*cost)(const Json& row));

}  // namespace plumb::app::bench
