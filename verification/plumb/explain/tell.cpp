#include "verification/plumb/explain/tell.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>

#include "lib/output/progress.hpp"
#include "lib/output/terminal.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

/// "1.2 MB": bytes for people.
std::string size_text(double bytes) {
  const char* unit = "B";
  for (const char* next : {"kB", "MB", "GB", "TB"}) {
    if (std::abs(bytes) < 1000) break;
    bytes /= 1000;
    unit = next;
  }
  return fmt::format("{:.4g} {}", bytes, unit);
}

/// A time to wait, no more exact than it is known.
std::string expected(double seconds) {
  return seconds < 0.1 ? "less than 0.1 s" : "about " + duration_text(seconds);
}

std::string cited(const Json& statement) {
  const auto theory = statement["theory"].get<std::string>();
  return statement["text"].get<std::string>() + (theory.empty() ? "" : ". " + theory);
}

/// Text from a column on, in lines that fit the terminal; those after the first begin there too.
std::string from_column(std::size_t column, const std::string& text) {
  return wrapped(text, static_cast<std::size_t>(terminal_columns(1)), column, column);
}

void tell_costs(std::ostream& out, const Json& costs) {
  if (costs["parts"].empty()) return;
  for (const bool built : {true, false}) {
    bool first = true;
    for (const auto& cost : costs["parts"]) {
      if (cost["built"] != built) continue;
      if (first)
        out << (built ? "\nOptional and there:\n"
                      : "\nLeft out: no code runs for it and no array is kept. It would take\n");
      first = false;
      const std::string said = fmt::format(
          "{:.0f} bytes a particle, {:+.0f} % time a step{}", cost["bytes_per_particle"].get<double>(),
          100 * (cost["step_time_ratio"].get<double>() - 1),
          cost["dt_ratio"].is_null()
              ? ""
              : fmt::format(", and steps {:.2g} times as long", cost["dt_ratio"].get<double>()));
      out << fmt::format("  {:<26} {}\n", cost["part"].get<std::string>(), from_column(29, said));
    }
  }
  out << "  "
      << from_column(2, fmt::format("(measured on a free body of {} such particles; a large lattice shares "
                                    "more, and takes fewer bytes)",
                                    costs["particles"].get<long>()))
      << '\n';
}

void tell_arrays(std::ostream& out, const Json& json) {
  out << "\nMemory:\n";
  for (const auto& array : json["arrays"])
    out << fmt::format("  {:<34} {:>10}\n", array["name"].get<std::string>(),
                       size_text(array["bytes"].get<double>()));
  out << fmt::format("  {:<34} {:>10}, {:.4g} bytes a particle\n", "together",
                     size_text(json["memory"]["bytes"].get<double>()),
                     json["memory"]["bytes_per_particle"].get<double>());
  out << fmt::format("  {:<34} {:>10}\n", "with all that the program takes",
                     size_text(json["memory"]["peak_rss"].get<double>()));
}

}  // namespace

void tell(std::ostream& out, const Json& json) {
  const auto scheme = json["scheme"].get<std::string>();
  out << from_column(
             0, fmt::format("{} ({}D) solves the motion of an elastic body by {}.",
                            json["scene"].get<std::string>(), json["dimension"].get<int>(),
                            scheme == "tlsph" ? "total Lagrangian SPH" : "the scheme \"" + scheme + "\""))
      << '\n';
  if (const auto shows = json["shows"].get<std::string>(); !shows.empty())
    out << "  " << fmt::format("{:<12} {}\n", "shows", from_column(15, shows));
  for (const auto& statement : json["solves"])
    out << fmt::format("  {:<12} {}\n", statement["topic"].get<std::string>(),
                       from_column(15, cited(statement)));
  tell_costs(out, json["costs"]);
  std::string left_out;
  for (const auto& part : json["left_out"])
    left_out += (left_out.empty() ? "" : ", ") + part.get<std::string>();
  if (!left_out.empty()) out << "  not built: " << from_column(15, left_out) << '\n';
  tell_arrays(out, json);
  out << '\n'
      << from_column(
             0, fmt::format("Time step {:.6g} s: {}", json["dt"].get<double>(), cited(json["dt_reason"])))
      << fmt::format("\n{} steps with {} evaluation{} of the force each\n", json["steps"].get<long>(),
                     json["evaluations_per_step"].get<int>(), json["evaluations_per_step"] == 1 ? "" : "s");
  out << (json["estimated_wall_s"].is_null()
              ? std::string("the first steps fail: the run would end unstable at once\n")
              : from_column(
                    0, fmt::format("It will take {} and the time of its output, "
                                   "by a few steps measured on this machine",
                                   expected(json["estimated_wall_s"].get<double>()))) +
                    "\n");
  for (const auto& warning : json["warnings"])
    out << "\nMind: " << from_column(6, warning.get<std::string>()) << '\n';
}

}  // namespace plumb::app
