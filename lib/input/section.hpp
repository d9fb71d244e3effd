#pragma once
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "lib/input/document.hpp"
#include "lib/input/expression.hpp"
#include "lib/input/key_notes.hpp"
#include "lib/input/units.hpp"

namespace plumb {

/// A section of a scene or study file as its reader sees it. Every getter marks its key as known; after the
/// last one reject_unknown() refuses whatever else stands there. So a reader is the declaration of its
/// section. Getters throw SceneError with file, line and key for a wrong type, unit or range; those without a
/// default also when the key is missing. The document must outlive the section, and so must the notes: they
/// take down what is asked for, in this section and those within it.
class Section {
 public:
  /// `path` is the dotted name in messages, such as "body"; empty for the whole file.
  Section(const TomlValue& table, std::string path, KeyNotes* notes = nullptr);

  /// Marks keys as known that other readers look at.
  void mark_known(const std::vector<std::string>& keys) const;
  /// True if the key is there; marks it as known.
  bool has(const Key& key) const;
  bool is_array(const Key& key) const;

  double number(const Key& key, const Quantity& expected, Sign sign = Sign::any) const;
  double number_or(const Key& key, double otherwise, const Quantity& expected, Sign sign = Sign::any) const;
  std::optional<double> optional_number(const Key& key, const Quantity& expected,
                                        Sign sign = Sign::any) const;
  /// A number or a quantity of whatever dimension, in SI units.
  double any_number(const Key& key) const;
  /// Whole numbers of at least `least`.
  long integer(const Key& key, long least) const;
  long integer_or(const Key& key, long otherwise, long least) const;
  std::optional<long> optional_integer(const Key& key, long least) const;
  bool flag_or(const Key& key, bool otherwise) const;
  /// A string that is not empty.
  std::string text(const Key& key) const;
  std::string text_or(const Key& key, const std::string& otherwise) const;
  /// One of the valid names; all are, if the list is empty.
  std::string choice(const Key& key, const std::vector<std::string>& valid) const;
  std::string choice_or(const Key& key, const std::string& otherwise,
                        const std::vector<std::string>& valid) const;
  /// An array of numbers; of `count` of them unless that is 0 (then at least one).
  std::vector<double> numbers(const Key& key, std::size_t count, const Quantity& expected,
                              Sign sign = Sign::any) const;
  /// An array of points of `dimension` numbers each, nested or one after the other; all their numbers.
  std::vector<double> points(const Key& key, std::size_t dimension, const Quantity& expected) const;
  std::vector<long> integers(const Key& key, std::size_t count, long least) const;
  /// An array of strings, numbers taken as they are written (to 17 digits); at least one.
  std::vector<std::string> texts(const Key& key) const;
  /// An array of words of which there are some only; the caller refuses what is none of them.
  std::vector<std::string> texts(const Key& key, const std::vector<std::string>& words) const;
  /// One formula in X, Y, Z, and in t where it may change in time; a bare number and a number with a unit are
  /// constants.
  Expression formula(const Key& key, int dimension, const Quantity& expected,
                     Variables variables = Variables::space) const;
  /// An array of `dimension` of them.
  std::vector<Expression> formulas(const Key& key, int dimension, const Quantity& expected,
                                   Variables variables = Variables::space) const;

  /// A square array of rows of numbers, and of formulas of the time t.
  std::vector<std::vector<double>> number_rows(const Key& key, const Quantity& expected) const;
  std::vector<std::vector<Expression>> formula_rows(const Key& key, const Quantity& expected) const;

  /// A section within this one.
  Section section(const Key& key) const;
  std::optional<Section> optional_section(const Key& key) const;
  /// The sections of an array of tables; empty if there is none.
  std::vector<Section> sections(const Key& key) const;

  /// Refuses keys that no getter asked for; names the nearest one that was.
  void reject_unknown() const;
  /// Marks every key as known.
  const std::vector<std::string>& all_keys() const;

  /// Refuses the value of `key` (or the section, if key is empty or not there) with its file and line.
  [[noreturn]] void fail(const std::string& key, const std::string& problem, const std::string& why,
                         const std::string& suggestion = "") const;
  Location where(const std::string& key) const;
  const std::string& path() const { return path_; }

 private:
  /// Takes down a call for a key, with the form of its value if the call says it.
  void note(const Key& key, const std::vector<ValueForm>& forms, bool optional,
            const std::string& otherwise = "") const;
  const TomlValue* find(const std::string& key) const;
  const TomlValue& required(const std::string& key) const;
  std::string dotted(const std::string& key) const;
  double as_number(const TomlValue& value, const std::string& key, const Quantity& expected, Sign sign) const;
  double read_number(const std::string& key, const Quantity& expected, Sign sign) const;
  std::vector<double> read_numbers(const std::string& key, std::size_t count, const Quantity& expected,
                                   Sign sign) const;
  std::string read_text(const std::string& key) const;
  std::string read_choice(const std::string& key, const std::string& name,
                          const std::vector<std::string>& valid) const;
  Section read_section(const std::string& key) const;
  long as_integer(const TomlValue& value, const std::string& key, long least) const;
  Expression as_formula(const TomlValue& value, const std::string& key, int dimension,
                        const Quantity& expected, Variables variables) const;
  const TomlValue& array(const std::string& key, std::size_t count, const std::string& of_what) const;
  /// The entries of a square array, each by read(value).
  template <class Read>
  auto square_of(const std::string& key, Read&& read) const;
  [[noreturn]] void wrong_type(const TomlValue& value, const std::string& key, const std::string& expected,
                               const std::string& suggestion = "") const;

  const TomlValue* table_;
  std::string path_;
  KeyNotes* notes_;
  mutable std::set<std::string> known_;
};

}  // namespace plumb
