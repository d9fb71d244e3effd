#pragma once
#include <string>

#include "lib/core/error.hpp"

namespace plumb {

/// A place in a scene or study file. `file` is "--set" and `line` 0 for a value from the command line.
struct Location {
  std::string file;
  long line = 0;
};

/// "FILE:LINE" or "FILE".
inline std::string text_of(const Location& where) {
  return where.line > 0 ? where.file + ":" + std::to_string(where.line) : where.file;
}

/// A scene or study file that cannot be used: "FILE:LINE: key: problem. Why. Suggestion.".
class SceneError : public InputError {
 public:
  SceneError(Location where, std::string key, const std::string& what_is_wrong, std::string why,
             std::string suggestion)
      : InputError(text_of(where) + ": " + (key.empty() ? "" : key + ": ") + what_is_wrong, std::move(why),
                   std::move(suggestion)),
        where_(std::move(where)),
        key_(std::move(key)) {}

  const Location& where() const { return where_; }
  /// Dotted, such as "material.young"; empty when the file as a whole is at fault.
  const std::string& key() const { return key_; }

 private:
  Location where_;
  std::string key_;
};

}  // namespace plumb
