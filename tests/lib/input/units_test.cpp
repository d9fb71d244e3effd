#include "lib/input/units.hpp"

#include <gtest/gtest.h>

#include <map>
#include <numbers>

#include "lib/core/error.hpp"
#include "lib/input/unit_names.hpp"

namespace plumb::units_test {
namespace {

constexpr double pi = std::numbers::pi;

struct Value {
  double in_si;
  Dimension dimension;  ///< kg, m, s
};

/// Every unit by its definition in the SI, from kilogram, metre and second up.
const std::map<std::string, Value>& definitions() {
  constexpr double minute = 60;  // s
  constexpr double hour = 60 * minute;
  constexpr double gram = 1e-3;      // kg
  constexpr double newton = 1;       // kg m/s^2
  constexpr double pascal = newton;  // N/m^2
  constexpr double joule = newton;   // N m
  constexpr double watt = joule;     // J/s
  static const std::map<std::string, Value> all{{"m", {1, {0, 1, 0}}},
                                                {"g", {gram, {1, 0, 0}}},
                                                {"s", {1, {0, 0, 1}}},
                                                {"Pa", {pascal, {1, 1 - 2, -2}}},
                                                {"N", {newton, {1, 1, -2}}},
                                                {"J", {joule, {1, 1 + 1, -2}}},
                                                {"W", {watt, {1, 1 + 1, -2 - 1}}},
                                                {"rad", {1, {0, 0, 0}}},
                                                {"deg", {2 * pi / 360, {0, 0, 0}}},
                                                {"rev", {2 * pi, {0, 0, 0}}},
                                                {"rpm", {2 * pi / minute, {0, 0, -1}}},
                                                {"min", {minute, {0, 0, 1}}},
                                                {"h", {hour, {0, 0, 1}}},
                                                {"t", {1000 * 1000 * gram, {1, 0, 0}}},
                                                {"bar", {1e5 * pascal, {1, -1, -2}}},
                                                {"%", {0.01, {0, 0, 0}}}};
  return all;
}

const std::map<std::string, double>& powers_of_ten() {
  static const std::map<std::string, double> all{{"n", 1e-9},      {"u", 1e-6}, {"\u00b5", 1e-6},
                                                 {"\u03bc", 1e-6}, {"m", 1e-3}, {"c", 1e-2},
                                                 {"k", 1e3},       {"M", 1e6},  {"G", 1e9}};
  return all;
}

void expect(const std::string& text, const Value& right) {
  SCOPED_TRACE(text);
  const Measured found = parse_measured(text);
  EXPECT_DOUBLE_EQ(found.value, right.in_si);  // 4 units in the last place: products in another order
  EXPECT_EQ(found.dimension, right.dimension) << text_of(found.dimension);
}

TEST(Units, EveryUnitOfTheCatalogueHasItsValue) {
  EXPECT_EQ(unit_names().size(), definitions().size());
  for (const auto& unit : unit_names()) {
    ASSERT_TRUE(definitions().contains(unit)) << unit;
    const Value one = definitions().at(unit);
    expect("1 " + unit, one);
    expect("2.5" + unit, {2.5 * one.in_si, one.dimension});
    expect("1 / " + unit, {1 / one.in_si, {-one.dimension.mass, -one.dimension.length, -one.dimension.time}});
  }
}

TEST(Units, EveryPrefixHasItsPowerOfTen) {
  EXPECT_EQ(prefix_names().size(), powers_of_ten().size());
  for (const auto& prefix : prefix_names()) {
    ASSERT_TRUE(powers_of_ten().contains(prefix)) << prefix;
    for (const char* unit : {"m", "g", "s", "Pa", "N", "J", "W"}) {
      const Value one = definitions().at(unit);
      expect("3 " + prefix + unit, {3 * powers_of_ten().at(prefix) * one.in_si, one.dimension});
    }
    for (const char* unit : {"rad", "deg", "bar", "t", "h"})
      EXPECT_THROW(parse_measured("1 " + prefix + unit), InputError) << prefix << unit;
  }
}

TEST(Units, ProductsQuotientsAndPowers) {
  const Dimension density{1, -3, 0}, stress{1, -1, -2}, acceleration{0, 1, -2};
  expect("17 MPa", {17e6, stress});
  expect("5mm", {5e-3, {0, 1, 0}});
  expect("0.2 s", {0.2, {0, 0, 1}});
  expect("1.1 g/cm^3", {1.1 * 1e-3 / 1e-6, density});
  expect("9.81 m s^-2", {9.81, acceleration});
  expect("9.81 m/s^2", {9.81, acceleration});
  expect("9.81 m/s/s", {9.81, acceleration});
  expect("3 kN*m", {3e3, {1, 2, -2}});
  expect("3 kN m", {3e3, {1, 2, -2}});
  expect("30 %", {0.3, {0, 0, 0}});
  expect("90 deg", {pi / 2, {0, 0, 0}});
  expect("36 km/h", {10, {0, 1, -1}});
  expect("105 rad/s", {105, {0, 0, -1}});
  expect("60 rev/min", {2 * pi, {0, 0, -1}});
  expect("-2e-3 m", {-2e-3, {0, 1, 0}});
  expect("+4", {4, {0, 0, 0}});
}

/// As engineers write them.
TEST(Units, PowersWithoutTheirSign) {
  const Dimension density{1, -3, 0}, stress{1, -1, -2};
  expect("1100 kg/m3", {1100, density});
  expect("1100 kg/m\u00b3", {1100, density});
  expect("1100 kg m-3", {1100, density});
  expect("1100 kg\u00b7m\u207b\u00b3", {1100, density});
  expect("17 N/mm2", {17e6, stress});
  expect("17 N/mm\u00b2", {17e6, stress});
  expect("2 m2", {2, {0, 2, 0}});
  expect("9.81 m s-2", {9.81, {0, 1, -2}});
}

struct Slip {
  const char *text, *problem, *suggestion;
};

TEST(Units, SlipsGetTheRightHint) {
  for (const Slip& slip :
       {Slip{"0,5 s", "\"0,5 s\" has a decimal comma", "write \"0.5 s\""},
        Slip{"1,1 g/cm^3", "\"1,1 g/cm^3\" has a decimal comma", "write \"1.1 g/cm^3\""},
        Slip{"1/3", "\"1/3\" is a fraction", "write 0.3333, with as many digits as you need"},
        Slip{"1/4 m", "\"1/4 m\" is a fraction", "write \"0.25 m\", with as many digits as you need"},
        Slip{"17 mpa", "unknown unit \"mpa\"", "did you mean \"MPa\"?"},
        Slip{"17 MPA", "unknown unit \"MPA\"", "did you mean \"MPa\"?"},
        Slip{"3 MM", "unknown unit \"MM\"", "did you mean \"mm\"?"},
        Slip{"3 KG", "unknown unit \"KG\"", "did you mean \"kg\"?"},
        Slip{"3 n", "unknown unit \"n\"", "did you mean \"N\"?"},
        Slip{"2 m^x", "\"m^x\" is not a power of a unit", "write for example \"kg/m^3\""},
        Slip{"2 m10", "\"m10\" is not a power of a unit", "write for example \"kg/m^3\""}}) {
    SCOPED_TRACE(slip.text);
    try {
      parse_measured(slip.text);
      ADD_FAILURE() << "accepted";
    } catch (const InputError& error) {
      EXPECT_EQ(error.problem(), slip.problem);
      EXPECT_EQ(error.suggestion(), slip.suggestion);
    }
  }
}

TEST(Units, AQuantityMustHaveTheExpectedDimension) {
  EXPECT_DOUBLE_EQ(parse_quantity("17 N/mm2", quantity::stress), 17e6);
  EXPECT_DOUBLE_EQ(parse_quantity("0.25", quantity::number), 0.25);
  EXPECT_DOUBLE_EQ(parse_quantity("25 %", quantity::number), 0.25);
  EXPECT_DOUBLE_EQ(parse_quantity("120 rpm", quantity::angular_velocity), 4 * pi);
  EXPECT_DOUBLE_EQ(parse_quantity("5 1/s", quantity::rate), 5);
  EXPECT_DOUBLE_EQ(parse_quantity("5/s", quantity::rate), 5);
  EXPECT_THROW(parse_quantity("5 1", quantity::number), InputError);
  for (const char* text : {"17", "17 m", "17 %"})
    EXPECT_THROW(parse_quantity(text, quantity::stress), InputError) << text;
  EXPECT_TRUE(looks_measured("5 m/s"));
  for (const char* text : {"5", "X", "5*X", "sin(2)", "5 mph"}) EXPECT_FALSE(looks_measured(text)) << text;
}

}  // namespace
}  // namespace plumb::units_test
