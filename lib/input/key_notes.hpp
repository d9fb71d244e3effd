#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

#include "lib/core/quantity.hpp"

namespace plumb {

/// Names a key of a section at the call that reads it, and says there what it means. The meaning may be left
/// out where another call for the same key says it.
struct Key {
  std::string name;
  std::string meaning;

  Key(const char* name_) : name(name_) {}
  Key(std::string name_) : name(std::move(name_)) {}
  Key(std::string name_, std::string meaning_) : name(std::move(name_)), meaning(std::move(meaning_)) {}
};

/// Tells which getter of a Section reads a value.
enum class ValueKind {
  number,      ///< in the unit of a quantity
  any_number,  ///< in whatever unit
  integer,
  flag,
  text,
  choice,  ///< one of some words
  numbers,
  points,
  integers,
  texts,
  choices,  ///< a list of some words
  formula,
  formulas,
  number_rows,
  formula_rows,
  section,
  sections  ///< a list of tables
};

/// Describes the values that one getter takes.
struct ValueForm {
  ValueKind kind = ValueKind::text;
  Quantity quantity = quantity::number;
  Sign sign = Sign::any;
  long least = 0;                       ///< of whole numbers
  std::size_t count = 0;                ///< entries of a list; 0: at least one
  std::vector<std::string> words = {};  ///< of a choice
};

/// Collects what readers ask of one key.
struct KeyNote {
  std::string path;              ///< dotted; every list of sections has the number 0: "boundary.0.kind"
  std::string meaning;           ///< a phrase
  std::vector<ValueForm> forms;  ///< one for each getter; empty: it was only asked whether the key is there
  std::set<std::string> otherwise;  ///< defaults, as TOML; several where they depend on other keys
  bool optional = false;            ///< some call does without it
};

/// Takes down every key that a Section is asked for: the declaration of a file, made by those who read it.
class KeyNotes {
 public:
  /// Notes one call for a key. `otherwise`: its default as TOML, or empty.
  void take(const std::string& section, const Key& key, const std::vector<ValueForm>& forms, bool optional,
            const std::string& otherwise = "");
  /// Notes that a section was read to its end, and which keys were asked for until then.
  void close(const std::string& section, const std::set<std::string>& asked);

  /// Takes over what others have noted.
  void add(const KeyNotes& other);

  /// Returns the keys in the order in which they were first asked for.
  const std::vector<KeyNote>& keys() const { return keys_; }
  const KeyNote* find(const std::string& path) const;
  /// Returns the path of the last call if it was for a key that must be there, otherwise nothing: a reader that
  /// stops there has missed it.
  const std::string& demanded() const { return demanded_; }
  /// True if the section was read to its end.
  bool closed(const std::string& section) const { return always_.contains(section); }
  /// True for a key without which no reading of its section comes to an end.
  bool required(const KeyNote& key) const;
  /// Returns how much has been found: keys, the forms of their values, and words of choices.
  std::size_t extent() const;

 private:
  std::vector<KeyNote> keys_;
  std::string demanded_;
  std::map<std::string, std::set<std::string>> always_;  ///< keys that every reading of a section asked for
};

}  // namespace plumb
