#include "lib/scene/limits.hpp"

#include <gtest/gtest.h>

#include "lib/scene/read_scene.hpp"

namespace plumb {
namespace {

const std::string scene = R"([scene]
dimension = 2
end_time = "1 ms"
[body]
size = [1, 1]
spacing = 0.1
[material]
young = "17 MPa"
poisson = 0.3
density = 1100
)";

std::vector<std::string> limits(const std::vector<std::string>& changes) {
  return limits_of(parse_scene(scene, "a.toml", changes));
}

struct Row {
  std::vector<std::string> changes;
  const char* words;  ///< of the only limit; empty: there is none
};

TEST(Limits, ClippedParticlesAlternate) {
  const auto ball = [](const std::string& more) {
    std::string text = scene;
    text.replace(text.find("size = [1, 1]"), 13, "shape = \"ball\"\ncentre = [0, 0]\nradius = 1");
    return limits_of(
        parse_scene(text + "[method]\ngradient = \"compatible\"\n" + more, "a.toml", {"body.layout=cell"}));
  };
  ASSERT_EQ(ball("").size(), 1u);
  EXPECT_NE(ball("")[0].find("clips, without [hourglass]"), std::string::npos) << ball("")[0];
  EXPECT_TRUE(ball("[hourglass]\n").empty());
}

/// plumb static with affine-patch says which of them miss linear fields: compatible and variational do not.
TEST(Limits, AreToldWhereTheSchemeHasThem) {
  for (const Row& row :
       {Row{{}, ""}, Row{{"method.gradient=improved"}, "patch test"},
        Row{{"method.momentum=symmetrised"}, "patch test"}, Row{{"method.gradient=standard"}, "patch test"},
        Row{{"method.momentum=variational"}, ""}, Row{{"body.layout=cell"}, ""}, Row{{"body.jitter=0.2"}, ""},
        Row{{"material.poisson=0.495"}, "[hourglass]"},
        Row{{"material.poisson=0.495", "hourglass.alpha=2"}, ""},
        Row{{"body.jitter=0.2", "method.gradient=improved"},
            "jitter = 0.2: none of the tables but that of compatible bonds"},
        Row{{"body.jitter=0.2", "method.momentum=variational"}, "compatible bonds"},
        Row{{"body.cloud=blue-noise"}, ""},
        Row{{"body.cloud=blue-noise", "method.gradient=improved"}, "blue noise: none of the tables"},
        Row{{"body.cloud=blue-noise", "body.layout=cell"}, "blue noise: none of the tables"}}) {
    const auto found = limits(row.changes);
    SCOPED_TRACE(row.changes.empty() ? "default" : row.changes.front());
    if (*row.words == 0) {
      EXPECT_TRUE(found.empty()) << found.front();
    } else {
      ASSERT_EQ(found.size(), 1u);
      EXPECT_NE(found.front().find(row.words), std::string::npos) << found.front();
    }
  }
}

}  // namespace
}  // namespace plumb
