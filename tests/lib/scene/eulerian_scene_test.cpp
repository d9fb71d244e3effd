// Scenes by the Eulerian-kernel scheme: the period of the plate of paper 001, and what a restart carries.
#include <gtest/gtest.h>

#include "lib/core/error.hpp"
#include "lib/scene/read_scene.hpp"
#include "lib/scene/simulation.hpp"
#include "places.hpp"

namespace plumb {
namespace {

/// Time of the second passage of the tip through its first place [s].
double period_of_plate(const std::vector<std::string>& overrides) {
  auto simulation =
      make_simulation<2>(
          read_scene(PLUMBLINE_SOURCE_DIR "/verification/scenes/eulerian-oscillating-plate.toml", overrides))
          .simulation;
  const Snapshot<2> first = simulation.snapshot();
  EXPECT_EQ(first.X.size(), 1048u);
  Index tip = 0;
  for (std::size_t i = 0; i < first.X.size(); ++i)
    if ((first.X[i] - Vec<2>(0.199, 0.001)).norm() < 1e-9) tip = static_cast<Index>(i);
  double before = 0, at = 0;
  std::vector<double> zeros;
  RunRecord record;
  run<2>(
      simulation,
      [&] {
        const double now = simulation.at(tip).u[1], time = simulation.steps.now().time;
        if (before * now < 0) zeros.push_back(at + (time - at) * before / (before - now));
        before = now;
        at = time;
        return zeros.size() < 2;
      },
      record);
  return zeros.size() < 2 ? 0 : zeros[1];
}

TEST(LongEulerianPeriod, OfTheOscillatingPlate) {
  // 10 particles across, v_l = 0.05 c_s, of an independent program; its lists and ours change at other times: 2e-4
  EXPECT_NEAR(period_of_plate({"method.paper=\"001\"", "output.series=false"}), 0.263169, 2e-4);
  // the adjoint force, there without damping: that of the defaults takes 0.6 % of the energy
  EXPECT_NEAR(period_of_plate({"output.series=false"}), 0.269035, 3e-4);
}

/// The bar of the scene after 80 us, with that force: energies over that of the start, and what it looks like.
struct Bar {
  double balance, made, plastic, heat, length, foot;
};
Bar bar_by(const std::string& force) {
  const Scene scene = read_scene(PLUMBLINE_SOURCE_DIR "/verification/scenes/eulerian-taylor-bar.toml",
                                 {"eulerian.force=" + force, "output.series=false"});
  auto simulation = make_simulation<3>(scene).simulation;
  const double start = simulation.energy().total(), spacing = 0.00126583333333;
  RunRecord record;
  EXPECT_TRUE(run<3>(simulation, {}, record).completed());
  const Energy end = simulation.energy();
  const Snapshot<3> shown = simulation.snapshot();
  Bar bar{(end.total() + end.dissipated.value_or(0)) / start - 1, 0, 0, 0, 0, 0};
  for (const auto& part : end.more) {
    if (part.name == "force less stress") bar.made = -part.value / start;
    if (part.name == "plastic work") bar.plastic = part.value / start;
  }
  for (const auto& more : shown.more)
    if (more.name == "temperature")
      for (std::size_t i = 0; i < more.values.size(); ++i)
        bar.heat += 885 * shown.mass[i] * (more.values[i] - 292) / 0.9 / start;
  for (const Vec<3>& x : shown.x) {
    bar.length = std::max(bar.length, x[2] + spacing / 2);
    bar.foot = std::max(bar.foot, 2 * x[0] + spacing);
  }
  return bar;
}

TEST(LongEulerianTaylorBar, TheAdjointForceMakesNoEnergy) {
  const Bar adjoint = bar_by("adjoint"), printed = bar_by("printed");
  EXPECT_NEAR(adjoint.balance, 0, 0.01);  // the elastic energy of rates, and volumes of the step before
  EXPECT_NEAR(adjoint.made, 0, 0.005);
  EXPECT_NEAR(adjoint.heat / adjoint.plastic, 1, 0.005);  // one is counted by mass, the other by volume
  EXPECT_GT(adjoint.plastic, 0.85);
  EXPECT_GT(printed.made, 0.05);  // what it makes goes into the foot
  EXPECT_GT(printed.foot, adjoint.foot + 1e-3);
  // against a wall that the bar can leave an independent program has 27.05 mm
  EXPECT_NEAR(adjoint.length, 0.02711, 5e-5);
}

Scene plate(const std::string& more) {
  return parse_scene(R"toml([scene]
dimension = 2
end_time = "4 ms"
[body]
size = [1, 1]
spacing = 0.1
layout = "cell"
[material]
model = "j2-logarithmic"
young = "17 MPa"
poisson = 0.3
density = 1100
yield = "0.2 MPa"
[initial]
velocity = ["30*sin(4*Y)", "20*X"]
[method]
)toml" + more,
                     "test.toml");
}

TEST(EulerianScene, ARestartCarriesReferencesAndWorks) {
  for (const std::string more : {"scheme = \"eulerian\"\n[eulerian]\nskin = 0.05\n",
                                 "paper = \"001\"\n[eulerian]\nhourglass = \"mixed\"\nrereference = 5\n"}) {
    const Scene scene = plate(more);
    auto whole = make_simulation<2>(scene).simulation, second = make_simulation<2>(scene).simulation;
    RunRecord record;
    ASSERT_TRUE(run<2>(whole, {}, record).completed());
    const SavedState end = whole.save();
    for (const long stop : {1L, 7L, end.now.step / 2}) {
      RunRecord halves;
      auto part = make_simulation<2>(scene).simulation;
      run<2>(
          part, [&] { return part.steps.now().step < stop; }, halves);
      second.restore(part.save());
      run<2>(second, {}, halves);
      const SavedState again = second.save();
      ASSERT_EQ(end.fields.size(), again.fields.size());
      for (std::size_t k = 0; k < end.fields.size(); ++k)
        EXPECT_EQ(end.fields[k].values, again.fields[k].values) << more << end.fields[k].name << ' ' << stop;
    }
    const SavedField* place = field_named(end.fields, "displacement of the reference");
    ASSERT_NE(place, nullptr);
    double most = 0;
    for (const double u : place->values) most = std::max(most, std::abs(u));
    EXPECT_GT(most, 0.01) << "no reference but the first: the test sees nothing of it";
  }
}

}  // namespace
}  // namespace plumb
