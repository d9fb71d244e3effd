// Points in HDF5, as h5py wrote them: tests/lib/input/write_hdf5.py.
#include <gtest/gtest.h>

#include <cmath>

#include "lib/core/error.hpp"
#include "lib/input/point_file.hpp"
#include "places.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

const std::string folder = PLUMBLINE_SOURCE_DIR "/tests/lib/input/hdf5/";

std::string refusal(const std::string& bytes) {
  try {
    parse_points(bytes, "a.h5");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

const PointColumn& column(const PointFile& file, const std::string& name) {
  const PointColumn* found = file.find({name});
  if (found == nullptr) throw std::runtime_error("no column " + name);
  return *found;
}

TEST(Hdf5Points, NamedDataSetsPackedAndInAnySequence) {
  const PointFile file = read_points(folder + "named.h5");
  ASSERT_EQ(file.count, 300u);
  EXPECT_EQ(file.time, 0.125);
  for (std::size_t k = 0; k < file.count; ++k) {  // by their ids
    const auto n = static_cast<double>(k);
    EXPECT_EQ(file.positions[3 * k], n / 7);
    EXPECT_EQ(file.positions[3 * k + 1], 1 / (n + 1));
    EXPECT_EQ(file.positions[3 * k + 2], 0);
    EXPECT_EQ(column(file, "displacement").values[2 * k + 1],
              static_cast<double>(static_cast<float>(-n / 9)));
    EXPECT_EQ(column(file, "volume").values[k], 0.5 + n);
  }
  EXPECT_EQ(file.find({"connectivity"}), nullptr);  // of another length
}

TEST(Hdf5Points, OneFrameOfH5md) {
  const PointFile file = read_points(folder + "h5md.h5");
  ASSERT_EQ(file.count, 300u);
  EXPECT_EQ(file.time, 0.25);
  EXPECT_EQ(file.positions[3 * 299 + 2], -299);
  EXPECT_EQ(column(file, "velocity").components, 3);
  EXPECT_EQ(column(file, "velocity").values[3 * 7 + 1], -7.0 / 9);
}

TEST(Hdf5Points, AQuantityEach) {
  const PointFile file = read_points(folder + "columns.h5");
  ASSERT_EQ(file.count, 300u);
  EXPECT_FALSE(file.time.has_value());
  EXPECT_EQ(file.positions[3 * 14], 2);
  EXPECT_EQ(column(file, "u").values, column(file, "u").values);
  EXPECT_EQ(column(file, "u").values[2 * 9], 3);
}

TEST(Hdf5Points, WhatIsNotOneBodyIsRefused) {
  const auto bytes = [](const std::string& name) { return test::content_of(folder + name); };
  EXPECT_NE(refusal(bytes("two_bodies.h5")).find("groups PartType0 and PartType1"), std::string::npos)
      << refusal(bytes("two_bodies.h5"));
  EXPECT_NE(refusal(bytes("two_frames.h5")).find("no positions"), std::string::npos);
  EXPECT_NE(refusal(bytes("no_positions.h5")).find("temperature (5 x 1)"), std::string::npos)
      << refusal(bytes("no_positions.h5"));
  const std::string whole = bytes("h5md.h5");
  EXPECT_NE(refusal(whole.substr(0, whole.size() / 2)), "");
  EXPECT_NE(refusal(whole.substr(0, 8)).find("cannot open"), std::string::npos);
}

}  // namespace
}  // namespace plumb
