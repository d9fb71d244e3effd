#pragma once
#include <functional>
#include <string>
#include <vector>

#include "lib/output/progress.hpp"
#include "lib/output/sitting.hpp"
#include "verification/plumb/run/interrupt.hpp"
#include "verification/plumb/run/kept_folder.hpp"

namespace CLI {
class App;
}

namespace plumb::app {
struct Session;

/// Where the finished parts of a study wait that was interrupted; empty: they are not kept.
struct SittingOptions {
  std::string folder = kept_folder("unfinished-studies").string();
};

/// Adds --unfinished.
void add_sitting_options(CLI::App& command, SittingOptions& options);

/// What tells the progress how far a study is.
Sitting::Listener told(Progress& progress);

/// What a sitting's parts depend on, as text.
std::string content_of_study(const std::vector<std::string>& files, const std::vector<std::string>& choices);
/// Says how many parts were not made anew.
void tell_recalled(const Session& session, const Sitting& sitting);

/// Runs a study in one sitting that a signal ends in good order, and returns what `work` made.
/// `files` are those that the study reads and `choices` what else decides its results; this program's build
/// is added. Throws SittingEnded with what has become of the finished parts.
template <class Work>
auto in_one_sitting(const Session& session, const SittingOptions& options,
                    const std::vector<std::string>& files, const std::vector<std::string>& choices,
                    Work&& work) {
  const InterruptGuard guard;
  Sitting sitting(options.folder, content_of_study(files, choices), [] { return !interrupted(); });
  auto result = work(sitting);
  sitting.close();
  tell_recalled(session, sitting);
  return result;
}

}  // namespace plumb::app
