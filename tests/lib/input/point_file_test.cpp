// Points as other programs write them: tables, VTK's files, LAMMPS dumps.
#include "lib/input/point_file.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/core/error.hpp"
#include "lib/output/particles.hpp"
#include "places.hpp"
#include "tests/support/program.hpp"

namespace plumb::point_file_test {
namespace {

const PointColumn& column(const PointFile& file, const std::string& name) {
  const PointColumn* found = file.find({name});
  if (found == nullptr) throw std::runtime_error("no column " + name);
  return *found;
}

std::string refusal(const std::string& bytes, const std::string& name) {
  try {
    parse_points(bytes, name);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(PointFile, TablesGroupTheirColumns) {
  const PointFile file = parse_points(
      "x [m],y [m],ux,uy,F11,F12,F21,F22,m\n0,1,2,3,4,5,6,7,8\n10,11,12,13,14,15,16,17,18\n", "a.csv");
  EXPECT_EQ(file.count, 2u);
  EXPECT_EQ(file.positions, (std::vector<double>{0, 1, 0, 10, 11, 0}));
  EXPECT_EQ(column(file, "U").values, (std::vector<double>{2, 3, 12, 13}));
  EXPECT_EQ(column(file, "F").components, 4);
  EXPECT_EQ(column(file, "F").values[6], 16);
  EXPECT_EQ(column(file, "m").components, 1);
}

TEST(PointFile, TablesOfOtherPrograms) {
  const PointFile paraview = parse_points(
      "\"displacement:0\",\"displacement:1\",\"displacement:2\",\"Points:0\",\"Points:1\",\"Points:2\"\n1,2,"
      "3,4,5,6\n",
      "a.csv");
  EXPECT_EQ(paraview.positions, (std::vector<double>{4, 5, 6}));
  EXPECT_EQ(column(paraview, "displacement").values, (std::vector<double>{1, 2, 3}));
  const PointFile plain = parse_points("0.5 1.5\n2.5 3.5\n", "points.txt");
  EXPECT_EQ(plain.positions, (std::vector<double>{0.5, 1.5, 0, 2.5, 3.5, 0}));
  const PointFile both = parse_points("X;Y;x;y\n1;2;3,5;4\n", "a.csv");
  EXPECT_EQ(both.positions, (std::vector<double>{3.5, 4, 0}));
  EXPECT_EQ(column(both, "reference").values, (std::vector<double>{1, 2}));
  const PointFile spaced = parse_points("x y u_x u_y\n1 2 3 4\n", "a.csv");
  EXPECT_EQ(column(spaced, "u").values, (std::vector<double>{3, 4}));
}

TEST(PointFile, PointsStandInTheOrderOfTheirIds) {
  const PointFile file = parse_points("id,x,y,u\n3,0.3,1,30\n1,0.1,1,10\n2,0.2,1,20\n", "a.csv");
  EXPECT_EQ(column(file, "u").values, (std::vector<double>{10, 20, 30}));
  EXPECT_EQ(file.positions[0], 0.1);
  EXPECT_NE(refusal("id,x,y\n3,0,1\n3,1,1\n", "a.csv").find("two points have the id 3"), std::string::npos);
}

TEST(PointFile, LammpsDumps) {
  const std::string head =
      "ITEM: TIMESTEP\n100\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n0 1\n0 1\n0 1\n";
  const PointFile file = parse_points(head +
                                          "ITEM: ATOMS id element x y z vx vy vz v_u[1] v_u[2]\n2 Cu 1 2 3 4 "
                                          "5 6 7 8\n1 O .5 2 3 4 5 6 9 10\n",
                                      "dump.7");
  EXPECT_EQ(file.positions, (std::vector<double>{0.5, 2, 3, 1, 2, 3}));
  EXPECT_EQ(column(file, "v").values, (std::vector<double>{4, 5, 6, 4, 5, 6}));
  EXPECT_EQ(column(file, "u").values, (std::vector<double>{9, 10, 7, 8}));
  EXPECT_NE(refusal(head + "ITEM: ATOMS id xs ys zs\n1 0 0 0\n", "d").find("scaled positions"),
            std::string::npos);
  EXPECT_NE(refusal(head + "ITEM: ATOMS id x y z\n1 0 0\n", "d").find("d:10: 3 values, the heading names 4"),
            std::string::npos);
  EXPECT_NE(refusal(head + "ITEM: ATOMS id x y z\n1 0 0 0\n" + head + "ITEM: ATOMS id x y z\n1 0 0 0\n", "d")
                .find("second snapshot"),
            std::string::npos);
}

// Ours: base64 without packing.
TEST(PointFile, OwnFrames) {
  const std::vector<double> x{0.1, 0.2, 0.3, 0.4}, u{1e-17, 2, 3, 4};
  const std::vector<PointField> fields{{"displacement [m]", 2, u}};
  const PointFile file = parse_points(vtp_text({0.125, 2, x, fields}), "a.vtp");
  EXPECT_EQ(file.count, 2u);
  EXPECT_EQ(file.time, 0.125);
  EXPECT_EQ(file.positions, (std::vector<double>{0.1, 0.2, 0, 0.3, 0.4, 0}));
  EXPECT_EQ(column(file, "displacement").values, (std::vector<double>{1e-17, 2, 0, 3, 4, 0}));
}

TEST(PointFile, AllEncodingsThatVtkWrites) {
  const test::TemporaryFolder folder;
  const auto written = test::run_shell(
      "/usr/bin/python3 -B " PLUMBLINE_SOURCE_DIR "/tests/lib/input/write_vtk.py " + folder.path().string());
  ASSERT_EQ(written.code, 0) << written.error;
  std::istringstream names(written.out);
  int files = 0;
  for (std::string name; std::getline(names, name); ++files) {
    const PointFile file = read_points(name);
    ASSERT_EQ(file.count, 4000u) << name;
    for (std::size_t k = 0; k < file.count; ++k) {
      const auto n = static_cast<double>(k);
      const double tolerance = name.find("Ascii") != std::string::npos ? 1e-9 : 0;  // digits that VTK writes
      ASSERT_NEAR(file.positions[3 * k], n / 7, tolerance * (1 + n)) << name;
      ASSERT_NEAR(column(file, "displacement").values[3 * k + 1], -n / 9, tolerance * (1 + n)) << name;
      ASSERT_EQ(column(file, "volume").values[k], 0.5 + n) << name;
      ASSERT_EQ(column(file, "tag").values[k], std::fmod(n, 5)) << name;
    }
  }
  EXPECT_EQ(files, 32);
}

TEST(PointFile, RefusalsNameThePlace) {
  EXPECT_NE(refusal("x,y\n", "a.csv").find("a.csv holds no numbers"), std::string::npos);
  EXPECT_NE(refusal("a,b\n1,2\n", "a.csv").find("has no positions"), std::string::npos);
  EXPECT_NE(refusal("x,y\n1,nan\n", "a.csv").find("a.csv:2"), std::string::npos);
  EXPECT_NE(refusal("hello", "a.vtp").find("no VTKFile"), std::string::npos);
  const std::string begin = "<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"1\"><Points>";
  EXPECT_NE(
      refusal(begin + "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">1 2</DataArray>",
              "a.vtp")
          .find("2 numbers for 1 points of 3"),
      std::string::npos);
  EXPECT_NE(
      refusal(
          begin + "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"binary\">!!!!</DataArray>",
          "a.vtp")
          .find("no base64"),
      std::string::npos);
  EXPECT_NE(
      refusal(
          begin + "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"binary\">AAAA</DataArray>",
          "a.vtp")
          .find("24 are expected"),
      std::string::npos);
  EXPECT_NE(
      refusal(
          begin + "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"appended\" offset=\"9\"/>",
          "a.vtp")
          .find("beyond the end"),
      std::string::npos);
  const auto of_components = [&](const std::string& count) {
    return refusal(
        begin + "<DataArray type=\"Float64\" Name=\"a\" NumberOfComponents=\"" + count + "\">1</DataArray>",
        "a.vtp");
  };
  EXPECT_NE(of_components("101").find("a has 101 components"), std::string::npos) << of_components("101");
  EXPECT_NE(of_components("100").find("a has 1 numbers for 1 points of 100"), std::string::npos)
      << of_components("100");
  EXPECT_NE(refusal("<VTKFile byte_order=\"BigEndian\">", "a.vtu").find("big-endian"), std::string::npos);
  EXPECT_NE(refusal("<VTKFile compressor=\"vtkLZ4DataCompressor\">", "a.vtu").find("vtkLZ4DataCompressor"),
            std::string::npos);
}

}  // namespace
}  // namespace plumb::point_file_test
