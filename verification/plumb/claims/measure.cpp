#include "verification/plumb/claims/measure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "lib/core/error.hpp"

namespace plumb::app::claims {
namespace {

using Json = nlohmann::ordered_json;

/// Recorded numbers below this are zero.
constexpr double round_off = 1e-15;

std::vector<std::string> split_at(const std::string& text, const char* separator) {
  std::vector<std::string> parts;
  boost::split(parts, text, boost::is_any_of(separator));
  return parts;
}

/// Whether an object has every entry of "key=value;key=value".
bool has_entries(const Json& object, const std::vector<std::string>& wanted) {
  return std::all_of(wanted.begin(), wanted.end(), [&](const std::string& entry) {
    const auto equals = entry.find('=');
    const auto found = object.find(entry.substr(0, equals));
    if (found == object.end()) return false;
    return (found->is_string() ? found->get<std::string>() : found->dump()) == entry.substr(equals + 1);
  });
}

const Json* step_into(const Json& from, const std::string& step) {
  if (from.is_object()) return from.contains(step) ? &from.at(step) : nullptr;
  if (!from.is_array()) return nullptr;
  if (step.find('=') == std::string::npos) {
    const std::size_t index = std::strtoul(step.c_str(), nullptr, 10);
    return index < from.size() ? &from[index] : nullptr;
  }
  const auto wanted = split_at(step, ";");
  const auto found =
      std::find_if(from.begin(), from.end(), [&](const Json& object) { return has_entries(object, wanted); });
  return found == from.end() ? nullptr : &*found;
}

/// The product of the numbers at the paths "a/b * c/d".
double number_at(const Json& result, const std::string& paths) {
  double product = 1;
  for (auto path : split_at(paths, "*")) {
    boost::trim(path);
    const Json& entry = entry_at(result, path);
    if (!entry.is_number())
      throw InputError(fmt::format("\"{}\" is {}", path, entry.dump()), "a number is wanted",
                       "see the command's JSON");
    product *= entry.get<double>();
  }
  return product;
}

/// The mean or the largest value of a column of the run's series from a time on.
double over_window(const Json& result, const std::string& column, const Reading& reading) {
  const Json series = result.value("series", Json::object());
  if (!series.contains("time [s]") || !series.contains(column))
    throw InputError(fmt::format("no column \"{}\" over time", column), "the run wrote no such series",
                     "let it have output.series = true");
  const Json& times = series.at("time [s]");
  const Json& values = series.at(column);
  double sum = 0, largest = -std::numeric_limits<double>::infinity();
  std::size_t count = 0;
  for (std::size_t k = 0; k < times.size(); ++k) {
    if (times[k].get<double>() < reading.from) continue;
    const double value = values[k].get<double>();
    sum += value;
    largest = std::max(largest, value);
    ++count;
  }
  if (count < 2)
    throw InputError(fmt::format("{} rows of \"{}\" from {:g} s on", count, column, reading.from),
                     "a window has several", "begin it earlier, or let the run go on");
  return reading.take == "mean" ? sum / static_cast<double>(count) : largest;
}

/// What stands at the path of a result, or what the reading takes from the column of that name.
double found_at(const Json& result, const std::string& path, const Reading& reading) {
  return reading.take.empty() ? number_at(result, path) : over_window(result, path, reading);
}

}  // namespace

Json columns_of(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  const auto names = split_at(line, ",");
  Json columns = Json::object();
  for (const auto& name : names) columns[name] = Json::array();
  while (std::getline(lines, line)) {
    const auto cells = split_at(line, ",");
    for (std::size_t k = 0; k < names.size(); ++k) {
      char* end = nullptr;
      const double value = k < cells.size() ? std::strtod(cells[k].c_str(), &end) : 0;
      // a state that broke has no forces
      const bool unknown = std::isnan(value) && names[k].starts_with("reaction ");
      if (cells.size() != names.size() || end == cells[k].c_str() || *end != 0 ||
          !(std::isfinite(value) || unknown))
        throw InputError(fmt::format("\"{}\" is no row of numbers", line),
                         fmt::format("the series has {} columns", names.size()), "");
      columns[names[k]].push_back(value);
    }
  }
  return columns;
}

const Json& entry_at(const Json& result, const std::string& path) {
  const Json* at = &result;
  for (const auto& step : split_at(path, "/")) {
    at = step_into(*at, step);
    if (!at)
      throw InputError(fmt::format(R"(nothing at "{}" of "{}")", step, path), "the result has no such entry",
                       "see the command's JSON");
  }
  return *at;
}

double measured(const Reading& reading, const RunCommand& run) {
  const Json result = run(reading.command);
  if (!reading.is.empty()) return entry_at(result, reading.at) == reading.is ? 1 : 0;
  double value = reading.times * found_at(result, reading.at, reading);
  if (!reading.over.empty())
    value /=
        found_at(reading.over_command.empty() ? result : run(reading.over_command), reading.over, reading);
  return value;
}

CheckResult check(const std::vector<Claim>& claims, bool long_too, const RunCommand& run,
                  const std::function<void(double, const std::string&)>& progress) {
  CheckResult result;
  for (std::size_t n = 0; n < claims.size(); ++n) {
    const Claim& claim = claims[n];
    progress(static_cast<double>(n) / static_cast<double>(claims.size()), claim.id);
    std::vector<double> values;
    for (const Reading& reading : claim.readings) {
      values.push_back(reading.value);
      if (!reading.test.empty() || (reading.long_run && !long_too)) continue;
      const double value = values.back() = measured(reading, run);
      const double size = std::max(std::abs(reading.value), round_off);
      const bool same = std::abs(value - reading.value) <= reading.tolerance * size;
      result.readings.push_back({&claim, &reading, value, same});
      if (!same)
        result.changes.push_back(fmt::format("{}, {}: {:.8g} is recorded, {:.8g} was measured", claim.id,
                                             reading.name, reading.value, value));
    }
    const Status status = status_of(claim, values);
    if (status != claim.status)
      result.changes.push_back(fmt::format(R"({}: "{}" is recorded, the numbers make it "{}")", claim.id,
                                           name_of(claim.status), name_of(status)));
  }
  return result;
}

}  // namespace plumb::app::claims
