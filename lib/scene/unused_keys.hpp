#pragma once
#include <string>
#include <vector>

#include "lib/input/section.hpp"
#include "lib/scene/study.hpp"

namespace plumb {

/// A key, or a whole section if `key` is empty, that a use of the file does not look at.
struct UnusedKey {
  std::string section, key;
  std::string why;
  bool also_in_files = false;  ///< refused in a file too: left there it would say what is not so
};

/// Those of a study file.
std::vector<UnusedKey> keys_unused_by(StudyOf use);

/// Those of a scene of which only the equations are wanted, linearised about the reference state.
std::vector<UnusedKey> keys_unused_by_spectrum();

/// Those of a scene whose steps Newton's method makes.
std::vector<UnusedKey> keys_unused_by_newton();

/// Returns those that are given, as "method.cfl is not used by scheme = \"implicit\": why". None is refused: scenes are handed from one
/// scheme to another.
std::vector<std::string> unused_by_scheme(const Section& root, const std::string& scheme,
                                          const std::vector<UnusedKey>& keys);

/// Refuses those that are asked for on the command line, and those of the file that are refused there.
/// Returns the others that the file has, as "method.cfl is not used by this command: why". Throws SceneError.
std::vector<std::string> refuse_unused(const Section& root, const std::vector<UnusedKey>& keys);

}  // namespace plumb
