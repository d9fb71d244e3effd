#pragma once
#include <optional>
#include <string>
#include <vector>

namespace plumb::app {

/// A key of [material] that a law has beside young, poisson and density.
struct NamedParameter {
  std::string name, unit, meaning;
  bool required;

  template <class Self, class Visit>
  static void members(Self& self, Visit&& visit) {
    visit("name", self.name);
    visit("unit", self.unit);
    visit("meaning", self.meaning);
    visit("required", self.required);
  }
};

/// Something that a scene, a study or an option can name.
struct NamedPart {
  std::string kind;     ///< "kernel"
  std::string key;      ///< of a scene, "method.kernel"; or the option or the study's key
  std::string name;     ///< "cubic"
  std::string meaning;  ///< what it is, a clause
  std::string theory;   ///< "THEORY (2.1)", or empty
  std::optional<std::vector<NamedParameter>> parameters = {};  ///< of materials

  template <class Self, class Visit>
  static void members(Self& self, Visit&& visit) {
    visit("kind", self.kind);
    visit("key", self.key);
    visit("name", self.name);
    visit("meaning", self.meaning);
    visit("theory", self.theory);
    visit("parameters", self.parameters);
  }
};

/// All of them, kind by kind, from the lists that the readers compare with.
std::vector<NamedPart> named_parts();

}  // namespace plumb::app
