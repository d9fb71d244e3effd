// Bytes of an update, THEORY (10.8), term by term: neighbours are counted from the positions, everything else
// is the sum in the text.
#include "lib/schemes/tlsph/run/traffic.hpp"

#include <gtest/gtest.h>

#include "lib/scene/read_scene.hpp"
#include "lib/scene/tlsph.hpp"

namespace plumb {
namespace {

std::string plate(int d, const std::string& behind = "") {
  return "[scene]\ndimension = " + std::to_string(d) +
         "\nmax_steps = 1\n[body]\nsize = " + (d == 2 ? "[1, 1]" : "[1, 1, 1]") +
         "\nspacing = 0.2\nlayout = \"cell\"\n[material]\nyoung = 1e7\npoisson = 0.3\ndensity = 1000\n"
         "[method]\nkernel = \"cubic\"\nbeta = 0.9\npair = \"W1\"\ngradient = \"improved\"\nmomentum = "
         "\"adjoint\"\n" +
         behind;
}

/// Mean number of other particles within the support, 2 h = 1.8 spacings.
template <int d>
double neighbours(const Cloud<d>& cloud) {
  double pairs = 0;
  for (Index i = 0; i < cloud.size(); ++i)
    for (Index j = 0; j < cloud.size(); ++j)
      pairs += j != i && (cloud.X[j] - cloud.X[i]).norm() < 2 * 0.9 * cloud.spacing ? 1 : 0;
  return pairs / static_cast<double>(cloud.size());
}

template <int d>
void expect_counts() {
  const double vector = 8 * d, tensor = 8 * d * d, verlet = 8 * vector, rk3 = 6 * vector;
  for (const bool rows : {false, true}) {  // a row of the tables for each particle, or shared ones
    const std::string jitter = rows ? "body.jitter=0.2" : "body.jitter=0";
    const auto bytes = [&](const std::string& behind, std::vector<std::string> set = {}) {
      set.push_back(jitter);
      const TlsphBody<d> s = make_tlsph<d>(parse_scene(plate(d, behind), "plate.toml", set));
      return bytes_per_update<d>(s.solid, s.integrator);
    };
    const TlsphBody<d> s = make_tlsph<d>(parse_scene(plate(d), "plate.toml", {jitter}));
    SCOPED_TRACE(std::to_string(d) + "D, " + jitter);
    const double n = rows ? neighbours<d>(s.solid.cloud) : 0;
    const double tables = rows ? 2 * n * (vector + 4) + tensor + vector + 24 : 0;
    const double bare = vector + 2 * tensor + verlet + tables;
    EXPECT_NEAR(bytes(""), bare, 1e-9);
    EXPECT_NEAR(bytes("integrator = \"rk3\"\n"), bare - verlet + rk3, 1e-9);
    EXPECT_NEAR(bytes("[jst]\neta4 = 0.01\n"), bare + 3 * vector + 2 * n * 12, 1e-9);
    EXPECT_NEAR(bytes("[jst]\neta4 = 0.01\neta2 = 0.1\n"), bare + 6 * vector + 3 * n * 12, 1e-9);
    // F is stored for it: written, and read by the term
    EXPECT_NEAR(bytes("[hourglass]\nalpha = 2\n"),
                bare + 2 * tensor + 2 * vector + tensor + 2 * n * (vector + 2 * 8 + 4), 1e-9);
    EXPECT_NEAR(bytes("[projection]\n"), bare + 2 * vector + 8 * (5 * 3 + 2 + 6 * d), 1e-9);
  }
}

TEST(Traffic, IsTheSumOfWhatEachTermReadsAndWrites) {
  expect_counts<2>();
  expect_counts<3>();
}

}  // namespace
}  // namespace plumb
