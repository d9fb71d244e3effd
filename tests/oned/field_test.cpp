#include "oned/field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "lib/core/error.hpp"

namespace {

using namespace plumb;
using namespace plumb::oned;

TEST(TestField, ValuesByTheirFormulas) {
  EXPECT_DOUBLE_EQ(value(parse_field("poly:1,-2,0,3"), 1.5), 1 - 3 + 3 * 3.375);
  EXPECT_DOUBLE_EQ(value(parse_field("sin:5"), 0.3), std::sin(1.5));
  EXPECT_DOUBLE_EQ(value(parse_field("sin:2,5,0.1"), 0.3), 2 * std::sin(1.6));
  EXPECT_DOUBLE_EQ(value(parse_field("exp:-2"), 0.3), std::exp(-0.6));
  EXPECT_DOUBLE_EQ(value(parse_field("tanh:4,1"), 0.3), std::tanh(-2.8));
  EXPECT_DOUBLE_EQ(value(parse_field("runge"), 0.2), 0.5);
}

/// The same fields over the complex numbers, for derivatives by complex step.
std::complex<double> complex_value(const std::string& text, std::complex<double> X) {
  if (text == "poly:1,-2,0,3") return 1.0 - 2.0 * X + 3.0 * X * X * X;
  if (text == "sin:2,5,0.1") return 2.0 * std::sin(5.0 * X + 0.1);
  if (text == "exp:-2") return std::exp(-2.0 * X);
  if (text == "tanh:4,1") return std::tanh(4.0 * (X - 1.0));
  return 1.0 / (1.0 + 25.0 * X * X);
}

TEST(TestField, DerivativesByComplexStep) {
  for (const std::string text : {"poly:1,-2,0,3", "sin:2,5,0.1", "exp:-2", "tanh:4,1", "runge"}) {
    const TestField field = parse_field(text);
    for (const double X : {0.0, 0.13, 0.9, 2.4}) {
      const double step = 1e-30;  // no difference is formed, so the step may be as small as one likes
      const double expected = complex_value(text, {X, step}).imag() / step;
      EXPECT_NEAR(derivative(field, X), expected, 1e-14 * (1 + std::abs(expected))) << text << " at " << X;
    }
  }
}

/// The message of the error that the text causes.
std::string complaint(const std::string& text) {
  try {
    parse_field(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// A formula of the user's own: the same values, and slopes within what the docstring promises.
TEST(TestField, FormulasAreThoseOfTheNamedForms) {
  const std::vector<std::pair<const char*, const char*>> same{
      {"1 - 2*X + 3*X^3", "poly:1,-2,0,3"}, {"2*sin(5*X + 0.1)", "sin:2,5,0.1"}, {"exp(-2*X)", "exp:-2"},
      {"tanh(4*(X - 1))", "tanh:4,1"},      {"1/(1 + 25*X^2)", "runge"},         {"sin(60*X)", "sin:60"}};
  for (const auto& [formula, name] : same) {
    const TestField own = parse_field(formula), named = parse_field(name);
    EXPECT_EQ(own.text, formula);
    double largest = 0, off = 0;
    for (int k = 0; k <= 50; ++k) {
      const double X = 0.1 * k;
      EXPECT_NEAR(value(own, X), value(named, X), 1e-13 * (1 + std::abs(value(named, X)))) << formula;
      largest = std::max(largest, std::abs(derivative(named, X)));
      off = std::max(off, std::abs(derivative(own, X) - derivative(named, X)));
    }
    EXPECT_LT(off, slope_accuracy * largest) << formula;
  }
  EXPECT_NE(complaint("sin(3*Y)").find("Y"), std::string::npos) << complaint("sin(3*Y)");
}

TEST(TestField, KeepsTheTextAndTrimsIt) {
  EXPECT_EQ(parse_field(" poly:1, +2 ").text, "poly:1, +2");
  EXPECT_DOUBLE_EQ(value(parse_field("poly:1, +2"), 3), 7);
}

TEST(TestField, ErrorsNameTheFormOrTheNearestKind) {
  EXPECT_NE(complaint("sinn:5").find("Did you mean \"sin\"?"), std::string::npos);
  EXPECT_NE(complaint("sin:1,2").find("sin:A,k,phi"), std::string::npos);
  EXPECT_NE(complaint("poly:").find("poly:a0"), std::string::npos);
  EXPECT_NE(complaint("poly:1,,2").find("is not a number"), std::string::npos);
  EXPECT_NE(complaint("poly:1,2x").find("\"2x\""), std::string::npos);
  EXPECT_NE(complaint("exp:nan").find("is not a number"), std::string::npos);
  EXPECT_NE(complaint("tanh:1").find("tanh:k,x0"), std::string::npos);
  EXPECT_NE(complaint("runge:1").find("without parameters"), std::string::npos);
  EXPECT_NE(complaint("").find("unknown field"), std::string::npos);
}

TEST(TestField, RefusesValuesThatOverflow) {
  EXPECT_THROW(values(parse_field("exp:1000"), {Vec<1>(1.0)}), InputError);
  EXPECT_NO_THROW(values(parse_field("tanh:1000,0"), {Vec<1>(3.0)}));
  EXPECT_EQ(derivatives(parse_field("tanh:1000,0"), {Vec<1>(3.0)})[0], 0);
}

}  // namespace
