#include "verification/plumb/run/sittings.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <ostream>

#include "lib/input/section.hpp"
#include "verification/plumb/provenance.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {

void add_sitting_options(CLI::App& command, SittingOptions& options) {
  command
      .add_option("--unfinished", options.folder,
                  "folder where finished parts wait if this is interrupted; empty: they are not kept (" +
                      kept_folder_text("unfinished-studies") + ")")
      ->type_name("DIR");
}

Sitting::Listener told(Progress& progress) {
  return [&progress](double fraction, const std::string& note) { progress.update(fraction, note); };
}

std::string content_of_study(const std::vector<std::string>& files, const std::vector<std::string>& choices) {
  std::string content = build_identity() + "\n";
  for (const auto& file : files) content += read_text(file) + "\n";
  for (const auto& choice : choices) content += choice + "\n";
  return content;
}

void tell_recalled(const Session& session, const Sitting& sitting) {
  if (sitting.recalled() > 0)
    session.text() << fmt::format("{} parts are of an earlier call that was interrupted\n",
                                  sitting.recalled());
}

}  // namespace plumb::app
