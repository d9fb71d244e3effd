#include "lib/input/section.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "lib/input/document.hpp"

namespace plumb::section_test {
namespace {

const char* const file = R"([body]
length = 2.5
quoted = "5 mm"
count = 7
flag = true
name = "tip"
sizes = [1, "20 cm", 3.0]
counts = [2, 3]
words = ["a", 2, 0.1]
field = ["2*X", "3 km/s", 4]
any = "3 kN"
kind = "roller"
[[body.hole]]
radius = 1
[[body.hole]]
radius = 2
[body.inner]
a = 1
)";

struct Body {
  TomlValue document = parse_document(file, "a.toml");
  Section section{*document.find("body"), "body"};
};

/// Every getter with the value that it must give, in SI units.
TEST(Section, EveryGetterGivesItsValue) {
  const Body body;
  const Section& s = body.section;
  EXPECT_EQ(s.number("length", quantity::length), 2.5);
  EXPECT_DOUBLE_EQ(s.number("quoted", quantity::length), 0.005);
  EXPECT_EQ(s.number("count", quantity::number), 7);
  EXPECT_DOUBLE_EQ(s.any_number("any"), 3000);
  EXPECT_EQ(s.any_number("length"), 2.5);
  EXPECT_EQ(s.number_or("length", 9, quantity::length), 2.5);
  EXPECT_EQ(s.number_or("absent", 9, quantity::length), 9);
  EXPECT_EQ(s.optional_number("length", quantity::length), 2.5);
  EXPECT_EQ(s.optional_number("absent", quantity::length), std::nullopt);
  EXPECT_EQ(s.integer_or("count", 1, 7), 7);
  EXPECT_EQ(s.integer_or("absent", 1, 7), 1);
  EXPECT_EQ(s.optional_integer("count", 0), 7);
  EXPECT_EQ(s.optional_integer("absent", 0), std::nullopt);
  EXPECT_TRUE(s.flag_or("flag", false));
  EXPECT_TRUE(s.flag_or("absent", true));
  EXPECT_EQ(s.text("name"), "tip");
  EXPECT_EQ(s.text_or("absent", "x"), "x");
  EXPECT_EQ(s.choice_or("kind", "clamped", {"clamped", "roller"}), "roller");
  EXPECT_EQ(s.choice_or("absent", "clamped", {"clamped", "roller"}), "clamped");
  EXPECT_EQ(s.numbers("sizes", 3, quantity::length), (std::vector<double>{1, 0.2, 3}));
  EXPECT_EQ(s.integers("counts", 2, 2), (std::vector<long>{2, 3}));
  EXPECT_EQ(s.texts("words"), (std::vector<std::string>{"a", "2", "0.1"}));
  EXPECT_TRUE(s.is_array("sizes"));
  EXPECT_FALSE(s.is_array("length"));
  ASSERT_EQ(s.sections("hole").size(), 2u);
  EXPECT_EQ(s.sections("hole")[1].number("radius", quantity::length), 2);
  EXPECT_EQ(s.sections("hole")[1].path(), "body.hole.1");
  EXPECT_EQ(s.sections("absent").size(), 0u);
  EXPECT_EQ(s.section("inner").number("a", quantity::number), 1);
  EXPECT_FALSE(s.optional_section("absent"));
  EXPECT_EQ(s.where("count").line, 4);
}

TEST(Section, FormulasAreFormulasQuantitiesAndNumbers) {
  const TomlValue document =
      parse_document("v = [\"2*X + Y\", \"3 km/s\", 4]\nw = [\"2*t\", \"1\", \"1\"]\n", "a.toml");
  const Section s(document, "");
  const auto v = s.formulas("v", 3, quantity::velocity);
  EXPECT_EQ(v[0].at({1, 5, 0}), 7);
  EXPECT_DOUBLE_EQ(v[1].at({1, 5, 0}), 3000);
  EXPECT_EQ(v[2].at({1, 5, 0}), 4);
  EXPECT_THROW(s.formulas("w", 3, quantity::velocity), SceneError) << "t is the time, not a tonne";
}

TEST(Section, RowsOfFormulasAreOfTheTimeAlone) {
  const TomlValue document =
      parse_document("F = [[\"0.1*t\", 2], [\"1e3*t\", \"1 + t\"]]\nG = [[\"X\"]]\nH = [[1, 2]]\n", "a.toml");
  const Section s(document, "");
  const auto F = s.formula_rows("F", quantity::number);
  EXPECT_DOUBLE_EQ(F[0][0].at({0, 0, 0}, 2), 0.2);
  EXPECT_DOUBLE_EQ(F[0][1].at({0, 0, 0}, 2), 2);
  EXPECT_DOUBLE_EQ(F[1][0].at({0, 0, 0}, 2), 2000);
  EXPECT_DOUBLE_EQ(F[1][1].at({0, 0, 0}, 2), 3);
  EXPECT_THROW(s.formula_rows("G", quantity::number), SceneError);
  EXPECT_THROW(s.formula_rows("H", quantity::number), SceneError);
}

struct Refused {
  std::string key, problem;
  std::function<void(const Section&)> read;
};

TEST(Section, EveryGetterRefusesWhatItCannotRead) {
  const Body body;
  for (const Refused& row : std::vector<Refused>{
           {"absent", "missing key", [](const Section& s) { s.number("absent", quantity::length); }},
           {"name", "\"tip\" is not a quantity",
            [](const Section& s) { s.number("name", quantity::length); }},
           {"quoted", "\"5 mm\" has the wrong unit",
            [](const Section& s) { s.number("quoted", quantity::time); }},
           {"flag", "wrong type", [](const Section& s) { s.number("flag", quantity::number); }},
           {"count", "7 is too small", [](const Section& s) { s.integer_or("count", 1, 8); }},
           {"length", "wrong type", [](const Section& s) { s.integer_or("length", 1, 0); }},
           {"name", "wrong type", [](const Section& s) { s.flag_or("name", true); }},
           {"count", "wrong type", [](const Section& s) { s.text("count"); }},
           {"kind", "unknown kind \"roller\"",
            [](const Section& s) {
              s.choice_or("kind", "a", {"a", "b"});
            }},
           {"sizes", "3 values", [](const Section& s) { s.numbers("sizes", 2, quantity::length); }},
           {"length", "wrong type", [](const Section& s) { s.sections("length"); }},
           {"hole", "wrong type", [](const Section& s) { s.section("hole"); }},
           {"inner", "unknown key", [](const Section& s) {
              for (const char* key : {"length", "quoted", "count", "flag", "name", "sizes", "counts", "words",
                                      "field", "any", "kind", "hole"})
                s.has(key);
              s.reject_unknown();
            }}}) {
    SCOPED_TRACE(row.key + ": " + row.problem);
    try {
      row.read(Section(*body.document.find("body"), "body"));
      ADD_FAILURE() << "accepted";
    } catch (const SceneError& error) {
      EXPECT_EQ(error.key(), "body." + row.key);
      EXPECT_NE(error.problem().find(row.problem), std::string::npos) << error.problem();
    }
  }
}

TEST(Section, SignsAreHeld) {
  const TomlValue document = parse_document("zero = 0\nminus = -1\nplus = 1\n", "a.toml");
  const Section s(document, "");
  const auto accepted = [&](const char* key, Sign sign) {
    try {
      s.number(key, quantity::number, sign);
      return true;
    } catch (const SceneError&) {
      return false;
    }
  };
  EXPECT_TRUE(accepted("plus", Sign::positive));
  EXPECT_FALSE(accepted("zero", Sign::positive));
  EXPECT_FALSE(accepted("minus", Sign::positive));
  EXPECT_TRUE(accepted("zero", Sign::not_negative));
  EXPECT_FALSE(accepted("minus", Sign::not_negative));
  EXPECT_TRUE(accepted("minus", Sign::any));
}

}  // namespace
}  // namespace plumb::section_test
