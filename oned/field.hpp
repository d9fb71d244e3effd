#pragma once
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lib/core/types.hpp"
#include "lib/input/expression.hpp"

namespace plumb::oned {

/// sum_m a_m X^m
struct Polynomial {
  std::vector<double> coefficients;
};
/// A sin(k X + phi); k in [1/m]
struct Sine {
  double amplitude, wave_number, phase;
};
/// exp(k X)
struct Exponential {
  double rate;
};
/// tanh(k (X - x0))
struct Tanh {
  double steepness, centre;
};
/// Runge's function 1 / (1 + 25 X^2)
struct Runge {};
/// A formula in X [m] of the user's own. Its derivative is found by differences, see derivative().
struct Formula {
  Expression expression;
};

/// A scalar function of X with its exact derivative: the deformation x(X) whose gradient is estimated.
struct TestField {
  std::string text;  ///< as the user wrote it, "poly:1,0,0,1"
  std::variant<Polynomial, Sine, Exponential, Tanh, Runge, Formula> form;
};

/// Reads "poly:a0,a1,.." | "sin:k" | "sin:A,k,phi" | "exp:k" | "tanh:k,x0" | "runge", or a formula in X as
/// scene files have them: "sin(3*X)*X". InputError says which form was expected, or names the nearest one.
TestField parse_field(std::string_view text);

/// x(X)
double value(const TestField& field, double X);
/// What the derivative of a user's formula may be off by, relative to the largest one: some times what was
/// seen for sines and exponentials, tests/oned/field_test.cpp.
inline constexpr double slope_accuracy = 1e-9;
/// dx/dX (X): of the named forms by their formulas; of a user's formula by the central differences of GSL of
/// the step that promises the least error, some 1e-11 of the derivative where the formula is smooth.
double derivative(const TestField& field, double X);

/// x at every position; InputError if a value is not finite.
std::vector<double> values(const TestField& field, const std::vector<Vec<1>>& positions);
/// dx/dX at every position; InputError if a value is not finite.
std::vector<double> derivatives(const TestField& field, const std::vector<Vec<1>>& positions);

}  // namespace plumb::oned
