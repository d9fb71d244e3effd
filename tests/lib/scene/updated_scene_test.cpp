// Scenes by the updated scheme: the period of the plate of paper 002, and what a restart carries.
#include <gtest/gtest.h>

#include "lib/core/error.hpp"
#include "lib/scene/read_scene.hpp"
#include "lib/scene/simulation.hpp"
#include "places.hpp"

namespace plumb {
namespace {

/// Time of the second passage of the tip through its first place [s].
double period(const std::vector<std::string>& overrides) {
  auto simulation =
      make_simulation<2>(
          read_scene(PLUMBLINE_SOURCE_DIR "/verification/scenes/updated-oscillating-plate.toml", overrides))
          .simulation;
  const Snapshot<2> first = simulation.snapshot();
  Index tip = 0;
  for (std::size_t i = 0; i < first.X.size(); ++i)
    if ((first.X[i] - Vec<2>(0.199, 0.001)).norm() < 1e-9) tip = static_cast<Index>(i);
  double before = 0, at = 0;
  std::vector<double> zeros;
  RunRecord history;
  run<2>(
      simulation,
      [&] {
        const double now = simulation.at(tip).u[1], time = simulation.steps.now().time;
        if (before * now < 0) zeros.push_back(at + (time - at) * before / (before - now));
        before = now;
        at = time;
        return zeros.size() < 2;
      },
      history);
  return zeros.size() < 2 ? 0 : zeros[1];
}

TEST(LongUpdatedPeriod, OfTheOscillatingPlate) {
  // 10 particles across, v_f = 0.05; 1e-4 s: a step of the run is 2e-5 s
  EXPECT_NEAR(period({"output.series=false"}), 0.26768, 1e-4);
  EXPECT_NEAR(period({"output.series=false", "updated.reaction=false"}), 0.26635, 1e-4);
  const std::vector<std::string> printed{"method.paper=\"002\"", "updated.reference_speed=2.85",
                                         "output.series=false"};
  EXPECT_NEAR(period(printed), 0.27892, 1e-4);
  auto eno = printed;
  eno.emplace_back("updated.form=eno");
  EXPECT_NEAR(period(eno), 0.26061, 1e-4);
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

TEST(UpdatedScene, ARestartCarriesPairsAndClocks) {
  for (const std::string more :
       {"scheme = \"updated\"\n",
        "paper = \"002\"\n[updated]\nreference_speed = \"30 m/s\"\nyield_ratio = true\n"}) {
    const Scene scene = plate(more);
    auto whole = make_simulation<2>(scene).simulation, first = make_simulation<2>(scene).simulation,
         second = make_simulation<2>(scene).simulation;
    RunRecord history;
    ASSERT_TRUE(run<2>(whole, {}, history).completed());
    const SavedState end = whole.save();
    const bool pairs = field_named(end.fields, "stretch of pairs") != nullptr;
    EXPECT_EQ(pairs, more.find("paper") == std::string::npos);
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
    SavedState torn = first.save();
    std::erase_if(torn.fields, [](const SavedField& field) { return field.name == "last step"; });
    EXPECT_THROW(second.restore(torn), InputError);
  }
}

}  // namespace
}  // namespace plumb
