#include "lib/scene/known_keys.hpp"

#include <fmt/format.h>

#include "lib/input/explored_keys.hpp"
#include "lib/scene/material_path.hpp"
#include "lib/scene/read_scene.hpp"
#include "lib/scene/study.hpp"

namespace plumb {
namespace {

/// What no body can do without.
constexpr const char* material = "[material]\nyoung = 1\npoisson = 0.25\ndensity = 1\n";

/// The edges of a box of one spacing.
std::string ones(int dimension) {
  return dimension == 1 ? "[1]" : dimension == 2 ? "[1, 1]" : "[1, 1, 1]";
}

/// Readers ask for other keys in other dimensions: one document in each.
template <class Write>
std::vector<TomlValue> in_each_dimension(Write&& write) {
  std::vector<TomlValue> all;
  for (const int d : {2, 3, 1}) all.push_back(parse_document(write(d) + material, "sample"));
  return all;
}

}  // namespace

KeyNotes keys_of_scenes() {
  std::vector<TomlValue> first;
  for (const char* body : {"[body]", "[[body]]"}) {
    const auto text = [&](int d) {
      return fmt::format("[scene]\ndimension = {}\nend_time = 1\n{}\nsize = {}\nspacing = 1\n", d, body,
                         ones(d));
    };
    for (TomlValue& document : in_each_dimension(text)) first.push_back(std::move(document));
  }
  return explored_keys(first,
                       [](const TomlValue& document, KeyNotes& notes) { scene_of(document, "", &notes); });
}

KeyNotes keys_of_studies(const std::vector<std::string>& solutions) {
  const auto text = [&](int d) {
    return fmt::format("[study]\nsolution = \"{}\"\nspacings = [1]\ntime = 1\n[body]\nsize = {}\n",
                       solutions.front(), ones(d));
  };
  return explored_keys(in_each_dimension(text), [&](const TomlValue& document, KeyNotes& notes) {
    study_of(document, "", solutions, StudyOf::space, &notes);
  });
}

KeyNotes keys_of_paths() {
  std::vector<TomlValue> first;
  for (const char* head : {"[path]\n", "[[path]]\n"})
    for (const char* motion : {"deformation = [[1, 0], [0, 1]]\n", "gradient = [[0, 0], [0, 0]]\n"})
      first.push_back(parse_document(std::string(head) + motion + material, "sample"));
  return explored_keys(
      first, [](const TomlValue& document, KeyNotes& notes) { material_path_of(document, &notes); });
}

}  // namespace plumb
