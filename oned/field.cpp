#include "oned/field.hpp"

#include <fmt/format.h>
#include <gsl/gsl_deriv.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "lib/core/error.hpp"

namespace plumb::oned {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

double parse_number(std::string_view text, std::string_view field) {
  text = trimmed(text);
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double number = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (status != std::errc{} || end != text.data() + text.size() || !std::isfinite(number))
    throw InputError(fmt::format(R"(field "{}": "{}" is not a number)", field, text),
                     "parameters are finite decimal numbers", "Write for example poly:1,0,0,1 for X^3 + 1.");
  return number;
}

std::vector<double> parse_numbers(std::string_view list, std::string_view field) {
  std::vector<double> numbers;
  for (;;) {
    const auto comma = list.find(',');
    numbers.push_back(parse_number(list.substr(0, comma), field));
    if (comma == std::string_view::npos) return numbers;
    list.remove_prefix(comma + 1);
  }
}

InputError wrong_count(std::string_view field, std::size_t given, std::string_view form) {
  return InputError(fmt::format("field \"{}\" has {} parameter{}", field, given, given == 1 ? "" : "s"),
                    fmt::format("the form is {}", form), "");
}

const std::vector<std::string> kinds = {"poly", "sin", "exp", "tanh", "runge"};

}  // namespace

TestField parse_field(std::string_view given) {
  const std::string_view text = trimmed(given);
  const auto colon = text.find(':');
  const std::string_view kind = trimmed(text.substr(0, colon));
  const std::vector<double> p = colon == std::string_view::npos || trimmed(text.substr(colon + 1)).empty()
                                    ? std::vector<double>{}
                                    : parse_numbers(text.substr(colon + 1), text);
  const std::string name(text);
  if (!text.empty() && colon == std::string_view::npos &&
      std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
    return {name, Formula{Expression(name, 1, "field")}};
  if (kind == "poly") {
    if (p.empty()) throw wrong_count(text, 0, "poly:a0,a1,a2,.. for a0 + a1 X + a2 X^2 + ..");
    return {name, Polynomial{p}};
  }
  if (kind == "sin") {
    if (p.size() == 1) return {name, Sine{1, p[0], 0}};
    if (p.size() == 3) return {name, Sine{p[0], p[1], p[2]}};
    throw wrong_count(text, p.size(), "sin:k for sin(k X), or sin:A,k,phi for A sin(k X + phi)");
  }
  if (kind == "exp") {
    if (p.size() != 1) throw wrong_count(text, p.size(), "exp:k for exp(k X)");
    return {name, Exponential{p[0]}};
  }
  if (kind == "tanh") {
    if (p.size() != 2) throw wrong_count(text, p.size(), "tanh:k,x0 for tanh(k (X - x0))");
    return {name, Tanh{p[0], p[1]}};
  }
  if (kind == "runge") {
    if (!p.empty()) throw wrong_count(text, p.size(), "runge, without parameters, for 1/(1 + 25 X^2)");
    return {name, Runge{}};
  }
  throw unknown_name("field", kind, kinds);
}

namespace {

struct Value {
  double X;
  double operator()(const Polynomial& f) const {
    double sum = 0;
    for (auto a = f.coefficients.rbegin(); a != f.coefficients.rend(); ++a) sum = sum * X + *a;
    return sum;
  }
  double operator()(const Sine& f) const { return f.amplitude * std::sin(f.wave_number * X + f.phase); }
  double operator()(const Exponential& f) const { return std::exp(f.rate * X); }
  double operator()(const Tanh& f) const { return std::tanh(f.steepness * (X - f.centre)); }
  double operator()(const Runge&) const { return 1 / (1 + 25 * X * X); }
  double operator()(const Formula& f) const { return f.expression.at({X, 0, 0}); }
};

/// For GSL: the formula at X; not a number where it has no value.
double formula_at(double X, void* formula) {
  try {
    return static_cast<const Formula*>(formula)->expression.at({X, 0, 0});
  } catch (const InputError&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

double slope_of(Formula f, double X) {
  const gsl_function function{formula_at, &f};
  double best = std::numeric_limits<double>::quiet_NaN(), least = std::numeric_limits<double>::infinity();
  for (double step = 1e-2; step > 1e-6; step /= 4) {
    double slope = 0, error = 0;
    gsl_deriv_central(&function, X, step * (1 + std::abs(X)), &slope, &error);
    if (std::isfinite(slope) && error < least) best = slope, least = error;
  }
  return best;
}

struct Derivative {
  double X;
  double operator()(const Polynomial& f) const {
    double sum = 0;
    for (std::size_t m = f.coefficients.size(); m-- > 1;)
      sum = sum * X + static_cast<double>(m) * f.coefficients[m];
    return sum;
  }
  double operator()(const Sine& f) const {
    return f.amplitude * f.wave_number * std::cos(f.wave_number * X + f.phase);
  }
  double operator()(const Exponential& f) const { return f.rate * std::exp(f.rate * X); }
  double operator()(const Tanh& f) const {
    const double c = std::cosh(f.steepness * (X - f.centre));
    return f.steepness / c / c;
  }
  double operator()(const Runge&) const {
    const double denominator = 1 + 25 * X * X;
    return -50 * X / denominator / denominator;
  }
  double operator()(const Formula& f) const { return slope_of(f, X); }
};

template <class Function>
std::vector<double> sampled(const TestField& field, const std::vector<Vec<1>>& positions, Function function) {
  std::vector<double> samples;
  samples.reserve(positions.size());
  for (const Vec<1>& position : positions) {
    const double X = position[0];
    samples.push_back(function(field, X));
    if (!std::isfinite(samples.back()))
      throw InputError(fmt::format("field \"{}\" is not finite at X = {:.6g} m", field.text, X),
                       "its value or derivative overflows there",
                       "Use a smaller parameter or a shorter length.");
  }
  return samples;
}

}  // namespace

double value(const TestField& field, double X) {
  return std::visit(Value{X}, field.form);
}
double derivative(const TestField& field, double X) {
  return std::visit(Derivative{X}, field.form);
}

std::vector<double> values(const TestField& field, const std::vector<Vec<1>>& positions) {
  return sampled(field, positions, value);
}
std::vector<double> derivatives(const TestField& field, const std::vector<Vec<1>>& positions) {
  return sampled(field, positions, derivative);
}

}  // namespace plumb::oned
