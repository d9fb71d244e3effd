#pragma once
#include <map>
#include <string>
#include <vector>

#include "lib/input/scene_error.hpp"

namespace plumb {

/// A value of a TOML file with the place it comes from. The rest of the room reads these, so that TOML's own
/// headers stay in document.cpp.
struct TomlValue {
  enum class Kind { boolean, integer, real, text, array, table, other };

  Kind kind = Kind::table;
  bool flag = false;    ///< boolean
  long whole = 0;       ///< integer
  double number = 0.0;  ///< integer and real
  std::string text;     ///< text
  std::vector<std::string>
      names;  ///< table: the keys, in the order of their lines; items[i] belongs to names[i]
  std::vector<TomlValue> items;  ///< array and table
  Location where;

  bool is(Kind k) const { return kind == k; }
  /// The entry of a table; nullptr if there is none.
  const TomlValue* find(const std::string& name) const;
  TomlValue* find(const std::string& name);
};

/// "a number", "a string", "an array", .. for messages; shows short values: the string "abc".
std::string description_of(const TomlValue& value);

/// Keys of which a section holds one only, such as body.spacing and body.particles: an override of one takes
/// the others out.
using Alternatives = std::vector<std::vector<std::string>>;

/// Parses TOML and applies the overrides "section.key=value" in order. A number steps into an array of
/// tables: "boundary.0.kind=roller". Sections that are not there are made. Throws SceneError for a syntax
/// error or an override that does not fit.
TomlValue parse_document(const std::string& text, const std::string& file_name,
                         const std::vector<std::string>& overrides = {},
                         const Alternatives& alternatives = {});

/// Every setting by its dotted key ("boundary.0.kind") as text, numbers with all their digits: two documents
/// that differ in comments, order or layout only give the same.
std::map<std::string, std::string> settings_of(const TomlValue& document);

/// The whole text of a file. Throws SceneError if it cannot be read.
std::string read_text(const std::string& path);

}  // namespace plumb
