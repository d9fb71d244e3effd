#include "verification/plumb/run/result_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <nlohmann/json.hpp>

#include "lib/core/error.hpp"
#include "lib/output/file.hpp"
#include "lib/output/particles.hpp"
#include "lib/run/checkpoint.hpp"

namespace plumb::app {

namespace fs = std::filesystem;

namespace {

bool is_result(const std::string& name) {
  for (const char* one : {"series.csv", "budget.csv", "summary.json", "checkpoint.h5", "particles.pvd"})
    if (name == one) return true;
  return name.starts_with("particles_") && name.ends_with(".vtp");
}

}  // namespace

ResultFolder::ResultFolder(fs::path path) : path_(std::move(path)) {
  require_folder(path_, "--out");
  take();
}

/// What cannot be opened or has no locks is not locked.
void ResultFolder::take() {
  if (file_ >= 0) return;
  file_ = ::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file_ < 0 || ::flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  ::close(file_);
  throw InputError(fmt::format("another run writes into \"{}\"", path_.string()), "their rows would be mixed",
                   "wait for its end, or give another folder with --out");
}

ResultFolder::~ResultFolder() {
  if (file_ >= 0) ::close(file_);
}

void ResultFolder::make(bool goes_on) {
  make_folder(path_, "--out");
  take();
  remove_unfinished_files(path_, is_result);
  if (goes_on) return;
  for (const auto& file : {path_ / "series.csv", budget(), summary(), checkpoint()}) fs::remove(file);
  ParticleSeries(path_, "particles").clear();
}

void require_no_checkpoint(const fs::path& folder) {
  const fs::path file = folder / "checkpoint.h5";
  if (!fs::exists(file)) return;
  throw InputError(fmt::format("{} is the checkpoint of a run that did not come to its end", file.string()),
                   "a new run would throw it away",
                   "go on from it with --resume, or say --overwrite, or give another folder with --out");
}

std::optional<nlohmann::ordered_json> completed_summary(const fs::path& folder,
                                                        const std::map<std::string, std::string>& settings) {
  std::ifstream in(folder / "summary.json");
  auto summary = nlohmann::ordered_json::parse(in, nullptr, false);
  if (!summary.is_object() || !summary.contains("settings") || summary.value("status", "") != "completed")
    return std::nullopt;
  require_same_settings((folder / "summary.json").string(), settings,
                        summary["settings"].get<std::map<std::string, std::string>>());
  return summary;
}

}  // namespace plumb::app
