#pragma once
#include <chrono>
#include <cstdio>
#include <optional>
#include <string>

namespace plumb {

/// Progress of long work on standard error: a bar with rate and time left on a terminal, a line now and then
/// (after 2 s, then at intervals that double up to a minute) otherwise, nothing when quiet. Standard output
/// stays clean.
class Progress {
 public:
  enum class Style { none, lines, bar };

  /// The style that fits standard error.
  static Style style_for_stderr(bool quiet);

  Progress(std::string label, Style style, std::FILE* stream = stderr);
  ~Progress() { finish(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `fraction` done, in [0, 1], of which `before` was there at the start (a run that goes on); cheap enough
  /// to be called every step. `note` is appended ("t = 0.2 s").
  void update(double fraction, const std::string& note = {}, double before = 0);
  /// Ends the bar's line. Called by the destructor.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  void draw(double fraction, double elapsed, const std::string& note, double before);

  std::string label_;
  Style style_;
  std::FILE* stream_;
  Clock::time_point start_;
  double next_;      ///< seconds since the start at which the next line is due
  double interval_;  ///< seconds
  bool open_line_ = false;
};

/// "1.2 s", "3 min 20 s", "2 h 05 min": a duration for people. `seconds` >= 0.
std::string duration_text(double seconds);

/// Time that is left [s] when `elapsed` [s] took the work from the fraction `before` to `fraction`, at the
/// same rate; nothing while there is no rate.
std::optional<double> seconds_left(double elapsed, double fraction, double before);

/// "8.4 %/s", "1.2 %/min", "3 %/h": how fast `elapsed` [s] took the work from `before` to `fraction`, in the
/// unit that leaves a number of one or more; empty while there is no rate.
std::string rate_text(double elapsed, double fraction, double before);

}  // namespace plumb
