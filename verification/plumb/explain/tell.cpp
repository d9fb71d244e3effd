#include "plumb/explain/tell.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>
#include <sstream>

#include "plumbline/output/progress.hpp"

namespace plumb {
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

/// Text in lines of at most 110 characters, those after the first indented.
std::string wrapped(const std::string& text, std::size_t indent) {
  constexpr std::size_t width = 110;
  std::string result;
  std::size_t column = indent;
  std::istringstream words(text);
  for (std::string word; words >> word; column += word.size() + 1) {
    if (column + word.size() > width) {
      result += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (!result.empty()) {
      result += ' ';
    }
    result += word;
  }
  return result;
}

void tell_costs(std::ostream& out, const Json& costs) {
  for (const bool built : {true, false}) {
    bool first = true;
    for (const auto& cost : costs["parts"]) {
      if (cost["built"] != built) continue;
      if (first)
        out << (built ? "\nOptional and there:\n"
                      : "\nLeft out: no code runs for it and no array is kept. It would take\n");
      first = false;
      out << fmt::format(
          "  {:<26} {:.0f} bytes a particle, {:+.0f} % time a step{}\n", cost["part"].get<std::string>(),
          cost["bytes_per_particle"].get<double>(), 100 * (cost["step_time_ratio"].get<double>() - 1),
          cost["dt_ratio"].is_null()
              ? ""
              : fmt::format(", and steps {:.2g} times as long", cost["dt_ratio"].get<double>()));
    }
  }
  out << fmt::format(
      "  (measured on a free body of {} such particles; a large lattice shares more, and takes fewer "
      "bytes)\n",
      costs["particles"].get<long>());
}

void tell_arrays(std::ostream& out, const Json& json) {
  out << "\nMemory:\n";
  for (const auto& array : json["arrays"])
    out << fmt::format("  {:<34} {:>10}\n", array["name"].get<std::string>(),
                       size_text(array["bytes"].get<double>()));
  out << fmt::format("  {:<34} {:>10}, {:.4g} bytes a particle; {} with all that the program takes\n",
                     "together", size_text(json["memory"]["bytes"].get<double>()),
                     json["memory"]["bytes_per_particle"].get<double>(),
                     size_text(json["memory"]["peak_rss"].get<double>()));
}

}  // namespace

void tell(std::ostream& out, const Json& json) {
  out << fmt::format("{} ({}D) solves the motion of an elastic body by total Lagrangian SPH.\n",
                     json["scene"].get<std::string>(), json["dimension"].get<int>());
  if (const auto shows = json["shows"].get<std::string>(); !shows.empty())
    out << "  " << fmt::format("{:<12} {}\n", "shows", wrapped(shows, 15));
  for (const auto& statement : json["solves"])
    out << fmt::format("  {:<12} {}\n", statement["topic"].get<std::string>(), wrapped(cited(statement), 15));
  tell_costs(out, json["costs"]);
  std::string left_out;
  for (const auto& part : json["left_out"])
    left_out += (left_out.empty() ? "" : ", ") + part.get<std::string>();
  out << "  not built: " << wrapped(left_out, 13) << '\n';
  tell_arrays(out, json);
  out << fmt::format("\nTime step {:.6g} s: {}\n{} steps with {} evaluation{} of the force each\n",
                     json["dt"].get<double>(), cited(json["dt_reason"]), json["steps"].get<long>(),
                     json["evaluations_per_step"].get<int>(), json["evaluations_per_step"] == 1 ? "" : "s");
  out << (json["estimated_wall_s"].is_null()
              ? std::string("the first steps fail: the run would end unstable at once\n")
              : fmt::format(
                    "It will take {} and the time of its output, by a few steps measured on this machine\n",
                    expected(json["estimated_wall_s"].get<double>())));
  for (const auto& warning : json["warnings"])
    out << "\nMind: " << wrapped(warning.get<std::string>(), 6) << '\n';
}

}  // namespace plumb
