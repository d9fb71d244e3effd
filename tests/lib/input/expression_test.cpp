#include "lib/input/expression.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lib/core/error.hpp"

namespace plumb::expression_test {
namespace {

struct Row {
  const char* formula;
  double value;  ///< at X = 0.5, Y = -2, Z = 3
};

/// Every operator and function that the header names, with its value by the C++ library.
TEST(Expression, EveryOperatorAndFunctionHasItsValue) {
  constexpr double X = 0.5, Y = -2, Z = 3;
  for (const Row& row : {Row{"X", X},
                         Row{"Y", Y},
                         Row{"Z", Z},
                         Row{"5*Z/3", 5},
                         Row{"X + Y - Z", -4.5},
                         Row{"-X^2", -0.25},
                         Row{"2^3^2", 512},
                         Row{"Z^-1", 1.0 / 3},
                         Row{"(X + Y)*Z", -4.5},
                         Row{"pi", std::numbers::pi},
                         Row{"sin(pi*X/2)", std::sqrt(0.5)},
                         Row{"cos(Z)", std::cos(Z)},
                         Row{"tan(X)", std::tan(X)},
                         Row{"asin(X)", std::numbers::pi / 6},
                         Row{"acos(X)", std::numbers::pi / 3},
                         Row{"atan(Y)", std::atan(Y)},
                         Row{"atan2(Y, X)", std::atan2(Y, X)},
                         Row{"sinh(X)", std::sinh(X)},
                         Row{"cosh(X)", std::cosh(X)},
                         Row{"tanh(X)", std::tanh(X)},
                         Row{"exp(Y)", std::exp(Y)},
                         Row{"ln(Z)", std::log(Z)},
                         Row{"log10(100*Z)", 2 + std::log10(Z)},
                         Row{"sqrt(Z + 1)", 2},
                         Row{"abs(Y)", 2},
                         Row{"min(X, Y, Z)", Y},
                         Row{"max(X, Y, Z)", Z},
                         Row{"sign(Y)", -1},
                         Row{"X < Z", 1},
                         Row{"X > Z", 0},
                         Row{"X <= 0.5", 1},
                         Row{"X >= 0.6", 0},
                         Row{"X == 0.5", 1},
                         Row{"X != 0.5", 0},
                         Row{"X < Z && Y > 0", 0},
                         Row{"X < Z || Y > 0", 1},
                         Row{"Y < 0 ? 7 : 8", 7},
                         Row{"Y > 0 ? 7 : 8", 8},
                         Row{"1e-3", 1e-3}})
    EXPECT_NEAR(Expression(row.formula).at({X, Y, Z}), row.value, 4e-16 * std::abs(row.value)) << row.formula;
}

TEST(Expression, ConstantsAndConditions) {
  for (const double value : {0.0, 1.0 / 3, -1e-300, 17e6, 0.1})
    EXPECT_EQ(Expression::constant(value).at({9, 9, 9}), value);  // 17 digits give the same double
  EXPECT_TRUE(Expression("Z < 0.1").holds_at({0, 0, 0}));
  EXPECT_FALSE(Expression("Z < 0.1").holds_at({0, 0, 0.1}));
  EXPECT_EQ(Expression("2*X").text(), "2*X");
}

struct Slip {
  const char* formula;
  int dimension;
  const char *problem, *suggestion;
};

TEST(Expression, SlipsGetTheRightHint) {
  const char* no_time = "what it says holds for the whole run";
  for (const Slip& slip :
       {Slip{"sin(t)", 2, "in \"sin(t)\": unknown name \"t\" at position 5", no_time},
        Slip{"2*t", 2, "in \"2*t\": unknown name \"t\" at position 3", no_time},
        Slip{"X*time", 2, "in \"X*time\": unknown name \"time\" at position 3", no_time},
        Slip{"0,5", 2, "in \"0,5\": a decimal comma", "write \"0.5\""},
        Slip{"1, 2", 2, "in \"1, 2\": 2 values", "write an array of formulas"},
        Slip{"x", 2, "in \"x\": unknown name \"x\" at position 1",
             "capital letters stand for the reference coordinates"},
        Slip{"Y", 1, "in \"Y\": unknown name \"Y\" at position 1", "the dimension is 1"},
        Slip{"Z", 2, "in \"Z\": unknown name \"Z\" at position 1", "the dimension is 2"},
        Slip{"sine(X)", 3, "in \"sine(X)\": unknown name \"sine\" at position 1", "did you mean \"sin\"?"},
        Slip{"X = 3", 3, "in \"X = 3\": assignment \"=\" at position 3", "write == to compare"},
        Slip{"", 3, "in \"\": the formula is empty", "write \"0\" for zero"}})
    try {
      Expression(slip.formula, slip.dimension);
      ADD_FAILURE() << slip.formula << " is accepted";
    } catch (const InputError& error) {
      EXPECT_EQ(error.problem(), slip.problem);
      EXPECT_EQ(error.suggestion(), slip.suggestion) << slip.formula;
    }
}

TEST(Expression, AValueThatIsNotFiniteIsRefusedWithItsPlace) {
  try {
    Expression("1/X", 2, "a.toml:3: velocity").at({0, 1, 0});
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.problem(), "a.toml:3: velocity: in \"1/X\": the value at (0, 1) is infinite");
  }
  try {
    Expression("1/t", 0, "", Variables::space_and_time).at({0, 0, 0});
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.problem(), "in \"1/t\": the value at (t = 0) is infinite");
  }
}

}  // namespace
}  // namespace plumb::expression_test
