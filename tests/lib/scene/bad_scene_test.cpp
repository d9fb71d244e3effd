// Every mistake in a scene gets one message with file, line and key, and nothing is built.
#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "lib/scene/read_scene.hpp"
#include "lib/scene/tlsph.hpp"

namespace plumb {
namespace {

const std::string good = R"([scene]
name = "test"
dimension = 2
end_time = "1 ms"
[body]
shape = "box"
size = [1, 1]
spacing = 0.1
layout = "cell"
[material]
model = "neo-hookean"
young = "17 MPa"
poisson = 0.45
density = 1100
[method]
kernel = "cubic"
beta = 0.9
pair = "W1"
gradient = "improved"
momentum = "adjoint"
integrator = "rk3"
cfl = 0.5
[initial]
velocity = ["Y", "-X"]
[[boundary]]
face = "x-"
kind = "clamped"
)";

/// A line of the good scene, what stands there instead, and what the message must hold: line, key, words.
struct Bad {
  std::string name, line, instead;
  int at;  ///< line that the message must name; 0: none
  std::string key, words;
};

void PrintTo(const Bad& bad, std::ostream* to) {
  *to << bad.instead;
}

std::string with(const Bad& bad) {
  std::string text = good;
  const auto place = text.find(bad.line);
  if (place == std::string::npos) throw std::logic_error("the good scene has no line " + bad.line);
  return text.replace(place, bad.line.size(), bad.instead);
}

class BadScene : public ::testing::TestWithParam<Bad> {};

TEST_P(BadScene, IsRefusedWithFileLineAndKey) {
  const Bad& bad = GetParam();
  try {
    parse_scene(with(bad), "bad.toml");
    FAIL() << "accepted";
  } catch (const SceneError& error) {
    const std::string message = error.what();
    SCOPED_TRACE(message);
    const std::string place = bad.at ? "bad.toml:" + std::to_string(bad.at) + ":" : "bad.toml";
    EXPECT_EQ(message.rfind(place, 0), 0u);
    EXPECT_EQ(error.key(), bad.key);
    EXPECT_NE(message.find(bad.words), std::string::npos) << "expected: " << bad.words;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Table, BadScene,
    ::testing::Values(
        Bad{"MisspeltRequiredKey", "young = \"17 MPa\"", "yuong = \"17 MPa\"", 10, "material.young",
            "\"yuong\" in line 12"},
        Bad{"UnknownKey", "cfl = 0.5", "cfl = 0.5\nbeata = 1", 23, "method.beata", "beta"},
        Bad{"UnknownSection", "[initial]", "[intial]", 23, "intial", "initial"},
        Bad{"MissingKey", "density = 1100\n", "", 10, "material.density", "missing key"},
        Bad{"MissingSection",
            "[material]\nmodel = \"neo-hookean\"\nyoung = \"17 MPa\"\npoisson = 0.45\ndensity = 1100\n", "",
            0, "material", "missing section"},
        Bad{"WrongType", "density = 1100", "density = true", 14, "material.density", "wrong type"},
        Bad{"TextForNumber", "poisson = 0.45", "poisson = \"big\"", 13, "material.poisson", "big"},
        Bad{"WrongUnit", "young = \"17 MPa\"", "young = \"17 m\"", 12, "material.young", "Pa"},
        Bad{"UnknownUnit", "young = \"17 MPa\"", "young = \"17 Mpsi\"", 12, "material.young", "Mpsi"},
        Bad{"TimeInMetres", "end_time = \"1 ms\"", "end_time = \"1 mm\"", 4, "scene.end_time", "mm"},
        Bad{"NegativeSize", "size = [1, 1]", "size = [1, -1]", 7, "body.size", "positive"},
        Bad{"ZeroSpacing", "spacing = 0.1", "spacing = 0", 8, "body.spacing", "positive"},
        Bad{"SizeOfWrongLength", "size = [1, 1]", "size = [1, 1, 1]", 7, "body.size", "dimension"},
        Bad{"Dimension", "dimension = 2", "dimension = 4", 3, "scene.dimension", "4"},
        Bad{"DimensionNotWhole", "dimension = 2", "dimension = 2.5", 3, "scene.dimension", "whole number"},
        Bad{"SpacingDoesNotDivide", "spacing = 0.1", "spacing = 0.3", 8, "body.spacing", "0.25"},
        Bad{"EmptyBody", "spacing = 0.1", "spacing = 3", 8, "body.spacing", "empty"},
        Bad{"TooManyParticles", "spacing = 0.1", "spacing = 1e-8", 8, "body.spacing", "particles"},
        Bad{"SpacingAgainstParticles", "spacing = 0.1", "spacing = 0.1\nparticles = [5, 5]", 8,
            "body.spacing", "contradicts"},
        Bad{"UnequalSpacings", "spacing = 0.1", "particles = [10, 7]", 8, "body.particles", "unequal"},
        Bad{"NoSpacing", "spacing = 0.1\n", "", 5, "body.spacing", "neither"},
        Bad{"Layout", "layout = \"cell\"", "layout = \"cel\"", 9, "body.layout", "cell"},
        Bad{"Shape", "shape = \"box\"", "shape = \"bxo\"", 6, "body.shape", "box"},
        Bad{"JitterTooLarge", "layout = \"cell\"", "layout = \"cell\"\njitter = 0.7", 10, "body.jitter",
            "0.5"},
        Bad{"JitterNegative", "layout = \"cell\"", "layout = \"cell\"\njitter = -0.1", 10, "body.jitter",
            "negative"},
        Bad{"PoissonHalf", "poisson = 0.45", "poisson = 0.5", 13, "material.poisson", "0.5"},
        Bad{"PoissonBelow", "poisson = 0.45", "poisson = -1", 13, "material.poisson", "-1"},
        Bad{"NegativeDensity", "density = 1100", "density = -1", 14, "material.density", "positive"},
        Bad{"NotFinite", "density = 1100", "density = inf", 14, "material.density", "finite"},
        Bad{"NotANumber", "beta = 0.9", "beta = nan", 17, "method.beta", "finite"},
        Bad{"UnknownModel", "model = \"neo-hookean\"", "model = \"neohookean\"", 11, "material.model",
            "neo-hookean"},
        Bad{"UnknownKernel", "kernel = \"cubic\"", "kernel = \"cubik\"", 16, "method.kernel", "cubic"},
        Bad{"UnknownPair", "pair = \"W1\"", "pair = \"W2\"", 18, "method.pair", "W1"},
        Bad{"UnknownGradient", "gradient = \"improved\"", "gradient = \"improoved\"", 19, "method.gradient",
            "improved"},
        Bad{"UnknownMomentum", "momentum = \"adjoint\"", "momentum = \"adjiont\"", 20, "method.momentum",
            "adjoint"},
        Bad{"UnknownIntegrator", "integrator = \"rk3\"", "integrator = \"rk4\"", 21, "method.integrator",
            "rk3"},
        Bad{"CflAndTimeStep", "cfl = 0.5", "cfl = 0.5\ntime_step = 1e-5", 23, "method.time_step", "cfl"},
        Bad{"CflNegative", "cfl = 0.5", "cfl = -0.5", 22, "method.cfl", "positive"},
        Bad{"NoEnd", "end_time = \"1 ms\"\n", "", 1, "scene.end_time", "max_steps"},
        Bad{"EndTimeZero", "end_time = \"1 ms\"", "end_time = 0", 4, "scene.end_time", "positive"},
        Bad{"ExpressionSyntax", "velocity = [\"Y\", \"-X\"]", "velocity = [\"Y\", \"-X*\"]", 24,
            "initial.velocity", "X*"},
        Bad{"ExpressionName", "velocity = [\"Y\", \"-X\"]", "velocity = [\"Y\", \"-T\"]", 24,
            "initial.velocity", "T"},
        Bad{"ThirdCoordinateInThePlane", "velocity = [\"Y\", \"-X\"]", "velocity = [\"Z\", \"-X\"]", 24,
            "initial.velocity", "Z"},
        Bad{"TooFewFormulas", "velocity = [\"Y\", \"-X\"]", "velocity = [\"Y\"]", 24, "initial.velocity",
            "dimension"},
        Bad{"VelocityAndSpin", "velocity = [\"Y\", \"-X\"]", "velocity = [\"Y\", \"-X\"]\nspin = [0, 0, 1]",
            25, "initial.spin", "contradicts"},
        Bad{"EmptyInitial", "velocity = [\"Y\", \"-X\"]\n", "", 23, "initial",
            "velocity, spin, displacement or temperature"},
        Bad{"FaceOfTheThirdAxis", "face = \"x-\"", "face = \"z-\"", 26, "boundary.0.face", "z-"},
        Bad{"NoPlaceOfTheBoundary", "face = \"x-\"\n", "", 25, "boundary.0", "face"},
        Bad{"BoundaryKind", "kind = \"clamped\"", "kind = \"clampd\"", 27, "boundary.0.kind", "clamped"},
        Bad{"RollerWithoutFace", "face = \"x-\"\nkind = \"clamped\"",
            "where = \"X < 0.1\"\nkind = \"roller\"", 27, "boundary.0.kind", "face"},
        Bad{"VelocityOfAClamp", "kind = \"clamped\"", "kind = \"clamped\"\nvelocity = [\"1\", \"0\"]", 28,
            "boundary.0.velocity", "contradicts"},
        Bad{"MissingVelocity", "kind = \"clamped\"", "kind = \"velocity\"", 25, "boundary.0.velocity",
            "missing key"},
        Bad{"TomlSyntax", "name = \"test\"", "name = \"test", 2, "", "TOML"}),
    [](const auto& row) { return row.param.name; });

TEST(GoodScene, IsAccepted) {
  const Scene scene = parse_scene(good, "good.toml");
  EXPECT_EQ(scene.dimension, 2);
  EXPECT_DOUBLE_EQ(scene.material.young, 17e6);
  EXPECT_DOUBLE_EQ(*scene.end_time, 1e-3);
  EXPECT_EQ(make_tlsph<2>(scene).solid.cloud.size(), 100);
}

TEST(GoodScene, OverridesReplaceValuesAndAreCheckedLikeTheFile) {
  EXPECT_DOUBLE_EQ(parse_scene(good, "good.toml", {"material.young=2 GPa"}).material.young, 2e9);
  EXPECT_THROW(parse_scene(good, "good.toml", {"material.young=-1"}), SceneError);
  EXPECT_THROW(parse_scene(good, "good.toml", {"material.yung=1"}), SceneError);
}

TEST(SingularNeighbourhood, IsRefusedWithParticlePositionAndCount) {
  const Scene scene =
      parse_scene(good, "good.toml", {"method.beta=0.4"});  // R = 0.8 d: every particle is alone
  try {
    make_tlsph<2>(scene);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("particle 0 at (0.05, 0.05)"), std::string::npos) << message;
    EXPECT_NE(message.find("0 neighbours"), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace plumb
