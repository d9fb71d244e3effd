// The names that papers have for parameters are second keys: the same scene by either.
#include <gtest/gtest.h>

#include "lib/core/error.hpp"
#include "lib/scene/read_scene.hpp"

namespace plumb {
namespace {

/// A block of the scheme "eulerian" with these lines in [material] and after [method].
Scene block_with(const std::string& material, const std::string& after = "") {
  return parse_scene(
      "[scene]\ndimension = 2\nend_time = 1e-5\n[body]\nsize = [0.01, 0.01]\nspacing = 0.001\n"
      "layout = \"cell\"\n[material]\nyoung = \"70 GPa\"\npoisson = 0.3\ndensity = 2700\n" +
          material + "[method]\nscheme = \"eulerian\"\n" + after,
      "block.toml");
}

std::string said_of_block(const std::string& material, const std::string& after = "") {
  try {
    block_with(material, after);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

const std::string cook =
    "model = \"johnson-cook\"\nreference_rate = 5\nreference_temperature = 300\n"
    "melting_temperature = 900\nheat_capacity = 880\n";

TEST(PaperNames, AreSecondKeysOfJohnsonAndCook) {
  const Scene by_words = block_with(
      cook +
      "yield = \"324 MPa\"\nhardening = \"114 MPa\"\nhardening_exponent = 0.42\nrate_factor = 0.002\n"
      "softening_exponent = 1.34\nheat_share = 0.8\ndamage_1 = -0.77\ndamage_2 = 1.45\ndamage_3 = -0.47\n"
      "damage_4 = 0.01\ndamage_5 = 1.6\nfracture_floor = 0.02\n");
  const Scene by_letters =
      block_with(cook +
                 "A = \"324 MPa\"\nB = \"114 MPa\"\nn = 0.42\nC = 0.002\nm = 1.34\neta = 0.8\n"
                 "damage = [-0.77, 1.45, -0.47, 0.01, 1.6]\nfracture_strain_floor = 0.02\n");
  EXPECT_EQ(by_letters.material.parameters, by_words.material.parameters);
  EXPECT_EQ(by_letters.material.parameters.at("yield"), 324e6);
  EXPECT_EQ(by_letters.material.parameters.at("damage_5"), 1.6);
  EXPECT_EQ(by_letters.material.parameters.size(), 16U);
}

TEST(PaperNames, AreRefusedBesideTheOthers) {
  EXPECT_NE(said_of_block(cook + "A = 3e8\nyield = 3e8\n").find("material.A: contradicts yield."),
            std::string::npos);
  EXPECT_NE(said_of_block(cook + "A = 3e8\ndamage_2 = 1\ndamage = [1, 2, 3, 4, 5]\n")
                .find("material.damage: contradicts damage_2."),
            std::string::npos);
  EXPECT_NE(said_of_block(cook + "A = 3e8\ndamage = [1, 2]\n").find("material.damage"), std::string::npos);
  EXPECT_NE(said_of_block(cook + "A = 3e8\neta = 1.5\n").find("material.eta: 1.5 is too large."),
            std::string::npos);
  EXPECT_NE(said_of_block("model = \"j2-logarithmic\"\nA = 3e8\n").find("yield"), std::string::npos);
}

TEST(PaperNames, AreSecondKeysOfEulerianKernels) {
  const EulerianOptions words = block_with("",
                                           "[eulerian]\nforce = \"printed\"\ndamping = \"objective\"\n"
                                           "viscosity_linear = 0.3\nviscosity_quadratic = 0.4\n"
                                           "artificial_stress = 0.2\nartificial_exponent = 3\n")
                                    .method.eulerian,
                        names = block_with("",
                                           "[eulerian]\nforce = \"shepard\"\ndamping = \"stress\"\n"
                                           "error_vector = \"total\"\n[viscosity]\nalpha = 0.3\nbeta = 0.4\n"
                                           "[artificial_stress]\nepsilon = 0.2\nn = 3\n")
                                    .method.eulerian;
  EXPECT_EQ(names.in_words(), words.in_words());
  EXPECT_EQ(names.force, "printed");
  EXPECT_EQ(names.viscosity_linear, 0.3);
  EXPECT_EQ(names.viscosity_quadratic, 0.4);
  EXPECT_EQ(names.artificial_stress, 0.2);
  EXPECT_EQ(names.artificial_exponent, 3);
}

TEST(PaperNames, SectionsOfViscosityBelongToEulerianKernels) {
  EXPECT_NE(said_of_block("", "[eulerian]\nviscosity_linear = 1\n[viscosity]\nalpha = 1\n")
                .find("viscosity.alpha: contradicts [eulerian] viscosity_linear."),
            std::string::npos);
  EXPECT_NE(said_of_block("", "[viscosity]\ngamma = 1\n").find("viscosity.gamma"), std::string::npos);
  EXPECT_THROW(
      parse_scene("[scene]\ndimension = 2\nend_time = 1\n[body]\nsize = [1, 1]\nspacing = 0.1\n[material]\n"
                  "young = 1\npoisson = 0.3\ndensity = 1\n[viscosity]\nalpha = 1\n",
                  "tlsph.toml"),
      InputError);
}

}  // namespace
}  // namespace plumb
