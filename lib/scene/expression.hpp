#pragma once
#include <array>
#include <memory>
#include <string>

namespace plumb {

/// A formula in the reference coordinates X, Y, Z [m], as scene files write it: "5*Z/3", "sin(pi*X/2)", "Z <
/// 0.1". pi is known, also the usual functions (sin cos tan asin acos atan atan2 sinh cosh tanh exp ln log10
/// sqrt abs min max sign), + - * / ^, comparisons and && || (1 is true, 0 false) and c ? a : b. A value:
/// copies share the compiled formula, and evaluating from several threads is safe (one at a time). Formulas
/// are evaluated at set-up only, never in a hot loop.
class Expression {
 public:
  /// Compiles `text` for a body of `dimension` 1, 2 or 3 (then only X; X, Y; X, Y, Z are known); 0: a formula
  /// of the time t [s] alone, which at({t}) evaluates. `where` is put in front of messages, such as
  /// "column.toml:12: initial.velocity". Throws InputError, which names the unknown name and its position.
  explicit Expression(std::string text, int dimension = 3, std::string where = "");

  /// The constant `value`.
  static Expression constant(double value);

  /// The value at X [m] (components beyond the dimension are not read).
  /// Throws InputError when the value is not finite (division by zero, root of a negative number).
  double at(const std::array<double, 3>& X) const;

  /// True where a condition holds: the value is not 0.
  bool holds_at(const std::array<double, 3>& X) const { return at(X) != 0.0; }

  /// The formula as written.
  const std::string& text() const;

 private:
  struct Compiled;
  std::shared_ptr<const Compiled> compiled_;
};

}  // namespace plumb
