#pragma once

namespace plumb::testing {

/// Loads of a block that is held at y-, as lines of a scene.
struct Loading {
  const char* name;
  const char* text;
};

inline constexpr Loading loadings[] = {
    {"weight", "[load]\ngravity = [\"3\", \"-10\"]\n"},
    {"pressure", "[[boundary]]\nface = \"y+\"\nkind = \"pressure\"\npressure = \"1e5\"\n"},
    {"displacement",
     "[[boundary]]\nface = \"y+\"\nkind = \"displacement\"\ndisplacement = [\"0.1\", \"0.2\"]\nramp = "
     "0.2\n"}};

}  // namespace plumb::testing
