#pragma once
#include <array>
#include <memory>
#include <string>

namespace plumb {

/// Tells which variables a formula may use.
enum class Variables {
  space,          ///< X, Y, Z as far as the dimension goes
  space_and_time  ///< and t [s]
};

/// A formula in the reference coordinates X, Y, Z [m], and in the time t [s] where it is allowed, as scene
/// files write it: "5*Z/3", "sin(pi*X/2)", "Z < 0.1", "0.1*t". pi is known, also the usual functions (sin cos
/// tan asin acos atan atan2 sinh cosh tanh exp ln log10 sqrt abs min max sign), + - * / ^, comparisons and &&
/// || (1 is true, 0 false) and c ? a : b. A value: copies share the compiled formula, and evaluating from
/// several threads is safe (one at a time). Formulas are evaluated at set-up, and in the loops only where a
/// load or a motion depends on time.
class Expression {
 public:
  /// Compiles `text` for a body of `dimension` 1, 2 or 3 (then only X; X, Y; X, Y, Z are known); 0 with
  /// space_and_time: a formula of the time alone.
  /// `where` is put in front of messages, such as "column.toml:12: initial.velocity".
  /// Throws InputError, which names the unknown name and its position.
  explicit Expression(std::string text, int dimension = 3, std::string where = "",
                      Variables variables = Variables::space);

  /// The constant `value`.
  static Expression constant(double value);

  /// The value at X [m] (components beyond the dimension are not read) and at a time [s].
  /// Throws InputError when the value is not finite (division by zero, root of a negative number).
  double at(const std::array<double, 3>& X, double time = 0) const;

  /// Says whether the time stands in the formula.
  bool uses_time() const;

  /// True where a condition holds: the value is not 0.
  bool holds_at(const std::array<double, 3>& X) const { return at(X) != 0.0; }

  /// The formula as written.
  const std::string& text() const;

 private:
  struct Compiled;
  std::shared_ptr<const Compiled> compiled_;
};

}  // namespace plumb
