#include "lib/output/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "lib/output/bar_line.hpp"
#include "lib/output/terminal.hpp"

namespace plumb {

std::string duration_text(double seconds) {
  if (seconds < 10) return fmt::format("{:.1f} s", seconds);
  if (seconds < 99.5) return fmt::format("{:.0f} s", seconds);
  const auto whole = std::llround(seconds);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

std::optional<double> seconds_left(double elapsed, double fraction, double before) {
  if (!(fraction > before)) return std::nullopt;
  return elapsed * (1 - fraction) / (fraction - before);
}

std::string rate_text(double elapsed, double fraction, double before) {
  if (!(fraction > before) || !(elapsed > 0)) return {};
  double rate = 100 * (fraction - before) / elapsed;
  const char* unit = "s";
  for (const char* longer : {"min", "h"}) {
    if (rate >= 1) break;
    rate *= 60;
    unit = longer;
  }
  return rate < 9.95 ? fmt::format("{:.2g} %/{}", rate, unit) : fmt::format("{:.0f} %/{}", rate, unit);
}

std::string bar_line(const std::string& label, double fraction, const std::string& left,
                     const std::string& note, std::size_t columns) {
  constexpr std::size_t most_cells = 30, least_cells = 5;
  const std::string said =
      fmt::format("{:3.0f} %, {}{}{}", 100 * fraction, left, note.empty() ? "" : ", ", note);
  const std::size_t around = label.size() + said.size() + 4;  // blanks and brackets
  const std::size_t cells = std::min(most_cells, columns > around ? columns - around : 0);
  if (cells < least_cells) return shortened(label + " " + said, columns);
  const auto filled = static_cast<std::size_t>(fraction * static_cast<double>(cells));
  return fmt::format("{} [{:#<{}}{:.<{}}] {}", label, "", filled, "", cells - filled, said);
}

Progress::Style Progress::style_for_stderr(bool quiet) {
  if (quiet) return Style::none;
  return ::isatty(STDERR_FILENO) != 0 ? Style::bar : Style::lines;
}

Progress::Progress(std::string label, Style style, std::FILE* stream)
    : label_(std::move(label)),
      style_(style),
      stream_(stream),
      start_(Clock::now()),
      next_(style == Style::bar ? 0.2 : 2),
      interval_(style == Style::bar ? 0.1 : 2) {}

void Progress::update(double fraction, const std::string& note, double before) {
  if (style_ == Style::none) return;
  const double elapsed = std::chrono::duration<double>(Clock::now() - start_).count();
  if (elapsed < next_) return;
  if (style_ == Style::lines) interval_ = std::min(2 * interval_, 60.0);
  next_ = elapsed + interval_;
  draw(std::clamp(fraction, 0.0, 1.0), elapsed, note, before);
}

void Progress::draw(double fraction, double elapsed, const std::string& note, double before) {
  const auto seconds = seconds_left(elapsed, fraction, before);
  const std::string left =
      seconds ? rate_text(elapsed, fraction, before) + ", " + duration_text(*seconds) + " left"
              : "time left unknown";
  if (style_ == Style::bar) {
    // the last column stays free: some terminals go to the next line once it is written
    const auto columns = static_cast<std::size_t>(terminal_columns(::fileno(stream_)) - 1);
    fmt::print(stream_, "\r{}\x1b[K", bar_line(label_, fraction, left, note, columns));
    open_line_ = true;
  } else {
    const std::string tail = note.empty() ? "" : ", " + note;
    fmt::print(stream_, "{}: {:.0f} % after {}, {}{}\n", label_, 100 * fraction, duration_text(elapsed), left,
               tail);
  }
  std::fflush(stream_);
}

void Progress::finish() {
  if (open_line_) {
    fmt::print(stream_, "\r\x1b[K");
    std::fflush(stream_);
  }
  open_line_ = false;
}

}  // namespace plumb
