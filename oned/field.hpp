#pragma once
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lib/core/types.hpp"

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

/// A scalar function of X with its exact derivative: the deformation x(X) whose gradient is estimated.
struct TestField {
  std::string text;  ///< as the user wrote it, "poly:1,0,0,1"
  std::variant<Polynomial, Sine, Exponential, Tanh, Runge> form;
};

/// Reads "poly:a0,a1,.." | "sin:k" | "sin:A,k,phi" | "exp:k" | "tanh:k,x0" | "runge".
/// InputError says which form was expected, or names the nearest one.
TestField parse_field(std::string_view text);

/// x(X)
double value(const TestField& field, double X);
/// dx/dX (X), by the formula, not by differences
double derivative(const TestField& field, double X);

/// x at every position; InputError if a value is not finite.
std::vector<double> values(const TestField& field, const std::vector<Vec<1>>& positions);
/// dx/dX at every position; InputError if a value is not finite.
std::vector<double> derivatives(const TestField& field, const std::vector<Vec<1>>& positions);

}  // namespace plumb::oned
