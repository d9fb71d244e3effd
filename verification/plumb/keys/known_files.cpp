#include "verification/plumb/keys/known_files.hpp"

#include "lib/core/error.hpp"
#include "lib/scene/known_keys.hpp"
#include "lib/stability/stability_study.hpp"
#include "mms/manufactured.hpp"

namespace plumb::app {

std::vector<std::string> known_files() {
  return {"scene", "study", "stability-study", "path"};
}

KeyNotes keys_of_file(const std::string& kind) {
  if (kind == "scene") return keys_of_scenes();
  if (kind == "study") return keys_of_studies(mms::solution_names());
  if (kind == "stability-study") return keys_of_stability_studies();
  if (kind == "path") return keys_of_paths();
  throw unknown_name("kind of file", kind, known_files());
}

}  // namespace plumb::app
