// The section [implicit] of a scene: what it sets, and what it refuses.
#include "lib/schemes/implicit/implicit_options.hpp"

#include <gtest/gtest.h>

#include "lib/input/section.hpp"

namespace plumb {
namespace {

ImplicitOptions read(const std::string& text) {
  const TomlValue document = parse_document("[implicit]\n" + text, "scene.toml");
  return ImplicitOptions::read(Section(document, "").section("implicit"));
}

std::string refusal(const std::string& text) {
  try {
    read(text);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(ImplicitOptions, Defaults) {
  const ImplicitOptions o = read("");
  EXPECT_EQ(o.steps, 4);
  EXPECT_FALSE(o.time_step);
  EXPECT_TRUE(o.adaptive);
  EXPECT_EQ(o.tolerance, 1e-10);
  EXPECT_EQ(o.first_step(3.0), 0.25);
  EXPECT_EQ(o.in_words(),
            "equilibrium by Newton's method, 4 steps (halved "
            "and grown as needed), residual 1e-10 of the forces");
}

TEST(ImplicitOptions, ValuesAreRead) {
  const ImplicitOptions o = read(
      "time_step = \"10 ms\"\nadaptive = false\ntolerance = 1e-8\nsolver = \"direct\"\ndynamics = \"none\"");
  EXPECT_EQ(o.first_step(0.04), 0.25);
  EXPECT_EQ(o.first_step(0.001), 1);  // longer than the path
  EXPECT_FALSE(o.adaptive);
  EXPECT_EQ(o.tolerance, 1e-8);
  EXPECT_EQ(o.in_words(), "equilibrium by Newton's method, steps of 0.01 s, residual 1e-08 of the forces");
  EXPECT_EQ(read("steps = 7").steps, 7);
  EXPECT_FALSE(o.midpoint);
  const ImplicitOptions moving = read("dynamics = \"midpoint\"\ntime_step = \"10 ms\"");
  EXPECT_TRUE(moving.midpoint);
  EXPECT_EQ(moving.in_words(), "implicit midpoint rule, steps of 0.01 s, residual 1e-10 of the forces");
  const ImplicitOptions exact = read("dynamics = \"energy-momentum\"\nsteps = 3");
  EXPECT_TRUE(exact.energy_momentum && exact.moves() && moving.moves() && !o.moves());
  EXPECT_EQ(exact.in_words(), "energy-momentum rule, 3 steps, residual 1e-10 of the forces");
}

TEST(ImplicitOptions, NonsenseIsRefused) {
  EXPECT_NE(refusal("steps = 0").find("implicit.steps"), std::string::npos);
  EXPECT_NE(refusal("steps = 2\ntime_step = 1").find("contradicts time_step"), std::string::npos);
  EXPECT_NE(refusal("tolerance = 1").find("is no tolerance"), std::string::npos);
  EXPECT_NE(refusal("tolerance = -1").find("implicit.tolerance"), std::string::npos);
  EXPECT_NE(refusal("dynamics = \"trapezium\"").find("dynamics"), std::string::npos);
  EXPECT_NE(refusal("step = 3").find("steps"), std::string::npos);
}

}  // namespace
}  // namespace plumb
