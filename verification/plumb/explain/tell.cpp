#include "verification/plumb/explain/tell.hpp"

#include <fmt/format.h>

#include <cmath>
#include <ostream>

#include "lib/core/error.hpp"
#include "lib/output/progress.hpp"
#include "lib/output/terminal.hpp"

namespace plumb::app {
namespace {

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

std::string cited(const Statement& statement) {
  return statement.text + (statement.theory.empty() ? "" : ". " + statement.theory);
}

/// Text from a column on, in lines that fit the terminal; those after the first begin there too.
std::string from_column(std::size_t column, const std::string& text) {
  return wrapped(text, static_cast<std::size_t>(terminal_columns(1)), column, column);
}

void tell_costs(std::ostream& out, const Costs& costs) {
  if (costs.parts.empty()) return;
  for (const bool built : {true, false}) {
    bool first = true;
    for (const PartCost& cost : costs.parts) {
      if (cost.built != built) continue;
      if (first)
        out << (built ? "\nOptional and there:\n"
                      : "\nLeft out: no code runs for it and no array is kept. It would take\n");
      first = false;
      const std::string said = fmt::format(
          "{:.0f} bytes a particle, {:+.0f} % time a step{}", cost.bytes_per_particle,
          100 * (cost.time_ratio - 1),
          cost.step_ratio ? fmt::format(", and steps {:.2g} times as long", *cost.step_ratio) : "");
      out << fmt::format("  {:<26} {}\n", cost.part, from_column(29, said));
    }
  }
  out << "  "
      << from_column(2, fmt::format("(measured on a free body of {} such particles; a large lattice shares "
                                    "more, and takes fewer bytes)",
                                    costs.particles))
      << '\n';
}

/// "with 3 evaluations of the force each"
std::string each_step(const Explanation& of) {
  if (!of.evaluations_per_step) return "by Newton's method";
  return fmt::format("with {} evaluation{} of the force each", *of.evaluations_per_step,
                     *of.evaluations_per_step == 1 ? "" : "s");
}

void tell_arrays(std::ostream& out, const Explanation& explanation) {
  out << "\nMemory:\n";
  for (const ArrayEntry& array : explanation.arrays)
    out << fmt::format("  {:<34} {:>10}\n", array.name, size_text(static_cast<double>(array.bytes)));
  const MemoryNeed& memory = explanation.memory;
  out << fmt::format("  {:<34} {:>10}, {:.4g} bytes a particle\n", "together",
                     size_text(static_cast<double>(memory.bytes)), memory.bytes_per_particle);
  out << fmt::format("  {:<34} {:>10}\n", "with all that the program takes",
                     size_text(static_cast<double>(memory.peak_rss)));
}

}  // namespace

void tell(std::ostream& out, const Explanation& of) {
  out << from_column(
             0,
             fmt::format("{} ({}D) solves the motion of an elastic body by {}.", of.scene, of.dimension,
                         of.scheme == "tlsph" ? "total Lagrangian SPH" : "the scheme \"" + of.scheme + "\""))
      << '\n';
  if (!of.shows.empty()) out << "  " << fmt::format("{:<12} {}\n", "shows", from_column(15, of.shows));
  for (const Statement& statement : of.solves)
    out << fmt::format("  {:<12} {}\n", statement.topic, from_column(15, cited(statement)));
  tell_costs(out, of.costs);
  if (!of.left_out.empty()) out << "  not built: " << from_column(15, join(of.left_out)) << '\n';
  tell_arrays(out, of);
  out << '\n'
      << from_column(0, fmt::format("Time step {:.6g} s: {}", of.dt, cited(of.dt_reason)))
      << fmt::format("\n{} step{} {}\n", of.steps, of.steps == 1 ? "" : "s", each_step(of));
  out << from_column(0, of.estimated_wall_s ? fmt::format("It will take {} and the time of its output, by a "
                                                          "few steps measured on this machine",
                                                          expected(*of.estimated_wall_s))
                                            : of.why_no_estimate)
      << '\n';
  for (const auto& warning : of.warnings) out << "\nMind: " << from_column(6, warning) << '\n';
}

}  // namespace plumb::app
