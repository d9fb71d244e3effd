#pragma once
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "lib/input/document.hpp"
#include "lib/input/expression.hpp"
#include "lib/input/units.hpp"

namespace plumb {

/// A section of a scene or study file as its reader sees it. Every getter marks its key as known; after the
/// last one reject_unknown() refuses whatever else stands there. So a reader is the declaration of its
/// section. Getters throw SceneError with file, line and key for a wrong type, unit or range; those without a
/// default also when the key is missing. The document must outlive the section.
class Section {
 public:
  /// `path` is the dotted name in messages, such as "body"; empty for the whole file.
  Section(const TomlValue& table, std::string path);

  /// True if the key is there; marks it as known.
  bool has(const std::string& key) const;
  bool is_array(const std::string& key) const;

  double number(const std::string& key, const Quantity& expected, Sign sign = Sign::any) const;
  double number_or(const std::string& key, double otherwise, const Quantity& expected,
                   Sign sign = Sign::any) const;
  std::optional<double> optional_number(const std::string& key, const Quantity& expected,
                                        Sign sign = Sign::any) const;
  /// A number or a quantity of whatever dimension, in SI units.
  double any_number(const std::string& key) const;
  /// Whole numbers of at least `least`.
  long integer_or(const std::string& key, long otherwise, long least) const;
  std::optional<long> optional_integer(const std::string& key, long least) const;
  bool flag_or(const std::string& key, bool otherwise) const;
  /// A string that is not empty.
  std::string text(const std::string& key) const;
  std::string text_or(const std::string& key, const std::string& otherwise) const;
  /// One of the valid names.
  std::string choice_or(const std::string& key, const std::string& otherwise,
                        const std::vector<std::string>& valid) const;
  /// An array of numbers; of `count` of them unless that is 0 (then at least one).
  std::vector<double> numbers(const std::string& key, std::size_t count, const Quantity& expected,
                              Sign sign = Sign::any) const;
  /// An array of points of `dimension` numbers each, nested or one after the other; all their numbers.
  std::vector<double> points(const std::string& key, std::size_t dimension, const Quantity& expected) const;
  std::vector<long> integers(const std::string& key, std::size_t count, long least) const;
  /// An array of strings, numbers taken as they are written (to 17 digits); at least one.
  std::vector<std::string> texts(const std::string& key) const;
  /// One formula in X, Y, Z, and in t where it may change in time; a bare number and a number with a unit are
  /// constants.
  Expression formula(const std::string& key, int dimension, const Quantity& expected,
                     Variables variables = Variables::space) const;
  /// An array of `dimension` of them.
  std::vector<Expression> formulas(const std::string& key, int dimension, const Quantity& expected,
                                   Variables variables = Variables::space) const;

  /// A square array of rows of numbers, and of formulas of the time t.
  std::vector<std::vector<double>> number_rows(const std::string& key, const Quantity& expected) const;
  std::vector<std::vector<Expression>> formula_rows(const std::string& key, const Quantity& expected) const;

  /// A section within this one.
  Section section(const std::string& key) const;
  std::optional<Section> optional_section(const std::string& key) const;
  /// The sections of an array of tables; empty if there is none.
  std::vector<Section> sections(const std::string& key) const;

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
  const TomlValue* find(const std::string& key) const;
  const TomlValue& required(const std::string& key) const;
  std::string dotted(const std::string& key) const;
  double as_number(const TomlValue& value, const std::string& key, const Quantity& expected, Sign sign) const;
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
  mutable std::set<std::string> known_;
};

}  // namespace plumb
