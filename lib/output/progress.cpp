#include "plumbline/output/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

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
  return fmt::format("{:.2g} %/{}", rate, unit);
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
  const std::string tail = note.empty() ? "" : ", " + note;
  if (style_ == Style::bar) {
    constexpr int cells = 30;
    const int filled = static_cast<int>(fraction * cells);
    fmt::print(stream_, "\r{} [{:#<{}}{:.<{}}] {:3.0f} %, {}{}\x1b[K", label_, "", filled, "", cells - filled,
               100 * fraction, left, tail);
    open_line_ = true;
  } else {
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
