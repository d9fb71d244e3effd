#pragma once
#include <string>
#include <vector>

namespace plumb::app {

/// Something that a scene, a study or an option can name.
struct NamedPart {
  std::string kind;     ///< "kernel"
  std::string key;      ///< of a scene, "method.kernel"; or the option or the study's key
  std::string name;     ///< "cubic"
  std::string meaning;  ///< what it is, a clause
  std::string theory;   ///< "THEORY (2.1)", or empty
};

/// All of them, kind by kind, from the lists that the readers compare with.
std::vector<NamedPart> named_parts();

}  // namespace plumb::app
