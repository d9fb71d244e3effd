#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace plumb::app {

/// The version, "0.1.0".
std::string version();

/// The day of the commit, "2026-11-25"; empty if it is not known.
std::string commit_date();

/// What --version prints: version, commit and build.
std::string version_text();

/// The same and a hash of the code that computes: kept results of another build are not taken.
std::string build_identity();

/// {commit, compiler, flags, build, host_cores, threads, date}: where a result comes from. The date is UTC,
/// ISO 8601; threads is what OpenMP will use.
nlohmann::ordered_json provenance();

}  // namespace plumb::app
