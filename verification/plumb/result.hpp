#pragma once
#include <exception>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

/// The one shape of everything that --json writes: plumbline, command, provenance, kind, status, exit_code,
/// the keys of the command, rows. verification/schema/result.json describes it.
namespace plumb::app {

/// Which call a result comes from and how it ended.
struct Call {
  std::string kind;     ///< words of the subcommand: "oned study"
  std::string command;  ///< the line as typed
  int exit_code = 0;
};

/// The word for the end of a call: the one that the command decided ("status" of its result), or else
/// "completed" for 0 and "fail" for any other exit code.
std::string status_of(const nlohmann::ordered_json& result, int exit_code);

/// A result in the common shape. "rows" is the command's own table, by whatever name it has it besides
/// (levels, claims, ..), and empty where it makes none. A sentence under "status" is moved to "reason".
nlohmann::ordered_json document(const nlohmann::ordered_json& result, const Call& call);

/// An error in the common shape: kind "error", problem, why, suggestion, and the place (file, line, key)
/// where it is known. What is not known is null.
nlohmann::ordered_json error_document(const std::exception& error, const Call& call);

/// The value of --json on a command line, also on one that cannot be parsed; empty if there is none.
std::string json_destination(const std::vector<std::string>& arguments);

}  // namespace plumb::app
