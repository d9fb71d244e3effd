// Surfaces of triangles as CAD programs write them: STL, text and binary.
#include "lib/input/stl.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "lib/core/error.hpp"

namespace plumb::stl_test {
namespace {

const std::string two =
    "solid part of ours\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1e0 0 0\n   vertex 0 "
    "+2 0.5\n"
    "  endloop\n endfacet\n FACET NORMAL 0 0 0\nouter loop\nvertex 1 2 3\nvertex 4 5 6\nvertex 7 8 "
    "-9\nendloop\n"
    "endfacet\nendsolid part\n";

std::string refusal(const std::string& bytes) {
  try {
    parse_stl(bytes, "a.stl");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// The triangles as a binary file; its heading may begin as text does.
std::string binary(const std::vector<Triangle>& triangles, const std::string& heading = "solid") {
  std::string bytes = heading + std::string(80 - heading.size(), ' ');
  const auto put = [&bytes](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  put(static_cast<std::uint32_t>(triangles.size()));
  for (const Triangle& triangle : triangles) {
    for (int k = 0; k < 3; ++k) put(7.0F);  // a normal that nobody reads
    for (const Vec<3>& corner : triangle)
      for (const double x : corner) put(static_cast<float>(x));
    put(std::uint16_t{0});
  }
  return bytes;
}

std::string with(std::string text, const std::string& old, const std::string& replacement) {
  return text.replace(text.find(old), old.size(), replacement);
}

TEST(Stl, TextAndBinaryGiveTheSameTriangles) {
  const auto text = parse_stl(two, "a.stl");
  ASSERT_EQ(text.size(), 2u);
  EXPECT_EQ(text[0][2], Vec<3>(0, 2, 0.5));
  EXPECT_EQ(text[1][0], Vec<3>(1, 2, 3));
  EXPECT_EQ(text[1][2], Vec<3>(7, 8, -9));
  EXPECT_EQ(parse_stl(binary(text), "a.stl"), text);
}

TEST(Stl, TrianglesWithTwoEqualCornersAreLeftOut) {
  EXPECT_EQ(parse_stl(with(two, "vertex 4 5 6", "vertex 1 2 3"), "a.stl").size(), 1u);
}

TEST(Stl, WhatIsNoneIsRefusedWithItsPlace) {
  EXPECT_NE(refusal(with(two, "+2", "two")).find("a.stl:6: \"two\" is no number"), std::string::npos);
  EXPECT_NE(refusal(with(two, "vertex 1e0 0 0", "vertex 1 0")).find("a.stl:5: a vertex of 2 numbers"),
            std::string::npos);
  EXPECT_NE(refusal(with(two, "vertex 4 5 6\n", "")).find("a.stl:14: a facet of 2 vertices"),
            std::string::npos);
  EXPECT_NE(refusal(with(two, "outer loop", "vertex 1 1 1")).find("a.stl:6: a vertex outside"),
            std::string::npos);
  EXPECT_NE(refusal(with(two, "endloop", "loop")).find("a.stl:7: \"loop\""), std::string::npos);
  EXPECT_NE(refusal(with(two, "endsolid part", "")).find("cut off"), std::string::npos);
  EXPECT_NE(refusal(with(two, "vertex 0 0 0", "vertex 0 nan 0")).find("a.stl:8: a corner is not finite"),
            std::string::npos);
  EXPECT_NE(refusal("solid\nendsolid\n").find("no triangles"), std::string::npos);
  EXPECT_NE(refusal("x,y\n1,2\n").find("no STL"), std::string::npos);
  std::string cut = binary(parse_stl(two, "a.stl"), "made by hand");
  cut.pop_back();
  EXPECT_NE(refusal(cut).find("cut off"), std::string::npos);
  EXPECT_NE(refusal("").find("no STL"), std::string::npos);
}

}  // namespace
}  // namespace plumb::stl_test
