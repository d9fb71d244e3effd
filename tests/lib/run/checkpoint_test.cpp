// A checkpoint gives back every bit, and a file with any fault is refused with a message.
#include "lib/run/checkpoint.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "lib/core/error.hpp"
#include "lib/output/hdf5_image.hpp"
#include "lib/output/sealed.hpp"

namespace plumb {
namespace {

Checkpoint example() {
  Checkpoint c;
  c.program = "plumb 0.1.0 (commit abc)";
  c.scene = {{"scene.name", "\"a scene\""}, {"material.poisson", "0.45000000000000001"}};
  c.dimension = 2;
  c.state.now = {0.1 + 0.2, 1234567};
  c.state.work = {1L << 40, 1L << 50};
  c.state.fields = {{"displacement", 2, {0.1, -0.0, 5e-324, 1e300, 2.0 / 3, -7}},
                    {"integrator", 2, {-1, -2, -3, -4, -5, -1.0 / 3}},
                    {"stress", 4, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}},
                    {"supports", 2, {0.7, -2.0 / 7}}};
  c.record.dt = {1e-5, 0.9e-5, 1.1e-5, 1.05e-5};
  c.record.initial_energy = 1.1;
  c.record.initial_momentum = {{1, 2, 3}, {4, 5, 6}, 7, 8};
  c.record.wall_s = 12.5, c.record.cpu_s = 25, c.record.writing_s = 1.5;
  c.record.next_row = 3, c.record.recorded_step = 99, c.record.series_bytes = 4711;
  c.record.particle_times = {0, 0.1, 0.2};
  return c;
}

std::string message_of(const std::string& bytes) {
  try {
    checkpoint_of(bytes, "file");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Checkpoint, GivesBackEveryBit) {
  const Checkpoint c = example(), back = checkpoint_of(bytes_of(c), "file");
  EXPECT_EQ(back.program, c.program);
  EXPECT_EQ(back.scene, c.scene);
  EXPECT_EQ(back.dimension, 2);
  EXPECT_EQ(back.state.now.step, 1234567);
  EXPECT_EQ(back.state.now.time, c.state.now.time);
  ASSERT_EQ(back.state.fields.size(), c.state.fields.size());
  for (std::size_t i = 0; i < c.state.fields.size(); ++i) {
    EXPECT_EQ(back.state.fields[i].name, c.state.fields[i].name);
    EXPECT_EQ(back.state.fields[i].components, c.state.fields[i].components);
    EXPECT_EQ(back.state.fields[i].values, c.state.fields[i].values);
  }
  EXPECT_TRUE(std::signbit(field_named(back.state.fields, "displacement")->values[1]));
  EXPECT_EQ(back.record.dt.least, c.record.dt.least);
  EXPECT_EQ(back.record.dt.last, c.record.dt.last);
  EXPECT_EQ(back.record.initial_energy, 1.1);
  EXPECT_EQ(back.record.writing_s, 1.5);
  EXPECT_EQ(back.record.initial_momentum.angular, c.record.initial_momentum.angular);
  EXPECT_EQ(back.record.initial_momentum.angular_scale, 8);
  EXPECT_EQ(back.state.work.pair_evaluations, 1L << 50);
  EXPECT_EQ(back.record.cpu_s, 25);
  EXPECT_EQ(back.record.series_bytes, 4711);
  EXPECT_EQ(back.record.particle_times, c.record.particle_times);
}

TEST(Checkpoint, WhatIsNotThereStaysAway) {
  Checkpoint c = example();
  c.state.fields.resize(1);
  c.record.particle_times.clear();
  const Checkpoint back = checkpoint_of(bytes_of(c), "file");
  EXPECT_EQ(field_named(back.state.fields, "integrator"), nullptr);
  EXPECT_TRUE(back.record.particle_times.empty());
}

TEST(Checkpoint, EveryTruncationIsRefused) {
  const std::string bytes = bytes_of(example());
  for (std::size_t length = 0; length < bytes.size(); length += 7) {
    const std::string message = message_of(bytes.substr(0, length));
    EXPECT_NE(message.find("cannot be used"), std::string::npos) << length << ": " << message;
  }
  EXPECT_NE(message_of(bytes + "x").find("grown"), std::string::npos);
}

TEST(Checkpoint, EveryChangedByteIsRefused) {
  const std::string bytes = bytes_of(example());
  for (std::size_t at = 0; at < bytes.size(); at += at < 600 ? 1 : 13) {
    std::string changed = bytes;
    changed[at] = static_cast<char>(changed[at] ^ 4);
    EXPECT_NE(message_of(changed).find("cannot be used"), std::string::npos) << at;
  }
}

TEST(Checkpoint, WhatDoesNotFitTogetherIsRefused) {
  const auto refused = [](auto change, const char* words) {
    Checkpoint c = example();
    change(c);
    EXPECT_NE(message_of(bytes_of(c)).find(words), std::string::npos) << message_of(bytes_of(c));
  };
  refused([](Checkpoint& c) { c.dimension = 4; }, "dimension");
  refused([](Checkpoint& c) { c.state.fields[2].values.resize(8); },
          "displacement and stress differ in size");
  refused([](Checkpoint& c) { c.state.fields[1].values.resize(4); }, "displacement and integrator differ");
  refused([](Checkpoint& c) { c.state.fields[1].values[1] = std::numeric_limits<double>::quiet_NaN(); },
          "not finite");
  refused([](Checkpoint& c) { c.state.now.step = -1; }, "negative");
  EXPECT_NE(message_of(sealed("not HDF5")).find("HDF5"), std::string::npos);
  EXPECT_NE(message_of(sealed(Hdf5Image().bytes())).find("\"program\" is missing"), std::string::npos);
}

TEST(Checkpoint, IsAnHdf5FileBehindABlockThatHdf5Skips) {
  // HDF5 looks for its signature at 0, 512, 1024, ..
  EXPECT_EQ(bytes_of(example()).substr(512, 8), "\x89HDF\r\n\x1a\n");
}

TEST(Checkpoint, AnotherSceneOrBuildIsRefusedWithTheDifference) {
  const Checkpoint c = example();
  const auto message = [&c](const std::string& program, const std::map<std::string, std::string>& scene) {
    try {
      require_same_origin(c, program, scene, "file");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_EQ(message(c.program, c.scene), "accepted");
  EXPECT_NE(message("plumb 0.2.0", c.scene).find("lumb 0.1.0 (commit abc); this is plumb 0.2.0"),
            std::string::npos);
  auto scene = c.scene;
  scene["material.poisson"] = "0.3";
  EXPECT_NE(message(c.program, scene).find("material.poisson is 0.3 here and 0.45000000000000001 there"),
            std::string::npos);
  scene = c.scene;
  scene["jst.eta4"] = "0.1";
  EXPECT_NE(message(c.program, scene).find("jst.eta4 = 0.1 is not in it"), std::string::npos);
  scene = c.scene;
  scene.erase("scene.name");
  EXPECT_NE(message(c.program, scene).find("t has scene.name"), std::string::npos);
}

}  // namespace
}  // namespace plumb
