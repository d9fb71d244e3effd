// Headings of the series and of the budget, written out: names in their order, axes and units of 2D (per
// metre of thickness) and of 3D.
#include <gtest/gtest.h>

#include "tests/support/run_scene.hpp"

namespace plumb {
namespace {

std::string heading(const std::string& dimension, const std::string& size, const std::string& file) {
  const test::SceneFolder scene("[scene]\ndimension = " + dimension +
                                "\nmax_steps = 1\n[body]\nsize = " + size +
                                "\nspacing = 0.25\n[material]\nyoung = 1e7\npoisson = 0.3\ndensity = 1000\n"
                                "[output]\nevery = \"1 ms\"\nvtk = false\nseries = true\nbudget = true\n"
                                "[[output.probe]]\nname = \"end\"\nat = " +
                                size + "\n");
  const auto outcome = scene.run("out", "--quiet");
  EXPECT_EQ(outcome.code, 0) << outcome.error;
  const std::string text = test::content_of(scene.file("out", file));
  return text.substr(0, text.find('\n'));
}

TEST(Headings, OfTheSeries) {
  EXPECT_EQ(
      heading("2", "[1, 1]", "series.csv"),
      "step,time [s],kinetic energy [J/m],strain energy [J/m],total energy [J/m],linear momentum x [kg/s],"
      "linear momentum y [kg/s],angular momentum z [kg m/s],hourglass share,end position x [m],"
      "end position y [m],end displacement x [m],end displacement y [m],end velocity x [m/s],"
      "end velocity y [m/s]");
  EXPECT_EQ(heading("3", "[1, 1, 1]", "series.csv"),
            "step,time [s],kinetic energy [J],strain energy [J],total energy [J],linear momentum x [kg m/s],"
            "linear momentum y [kg m/s],linear momentum z [kg m/s],angular momentum x [kg m^2/s],"
            "angular momentum y [kg m^2/s],angular momentum z [kg m^2/s],hourglass share,end position x [m],"
            "end position y [m],end position z [m],end displacement x [m],end displacement y [m],"
            "end displacement z [m],end velocity x [m/s],end velocity y [m/s],end velocity z [m/s]");
}

TEST(Headings, OfTheBudget) {
  const auto expected = [](const std::vector<std::string>& quantities) {
    std::string all = "step,time [s]";
    for (const std::string part : {"internal force", "integrator"})
      for (const auto& quantity : quantities) all += "," + part + ": " + quantity;
    return all + ",gap of linear momentum,gap of angular momentum,gap of energy";
  };
  EXPECT_EQ(heading("2", "[1, 1]", "budget.csv"),
            expected({"linear momentum x [kg/s]", "linear momentum y [kg/s]", "angular momentum z [kg m/s]",
                      "energy [J/m]"}));
  EXPECT_EQ(heading("3", "[1, 1, 1]", "budget.csv"),
            expected({"linear momentum x [kg m/s]", "linear momentum y [kg m/s]",
                      "linear momentum z [kg m/s]", "angular momentum x [kg m^2/s]",
                      "angular momentum y [kg m^2/s]", "angular momentum z [kg m^2/s]", "energy [J]"}));
}

}  // namespace
}  // namespace plumb
