// The arrays that `plumb explain` lists, against the memory that the process really holds.
#include <gtest/gtest.h>
#include <malloc.h>
#include <omp.h>

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#include <sanitizer/allocator_interface.h>
#define PLUMB_SANITIZED
#endif
#endif

#include "lib/scene/read_scene.hpp"
#include "lib/scene/tlsph.hpp"

namespace plumb {
namespace {

/// Bytes that are allocated at this moment [bytes]. Sanitizers have an allocator of their own.
#ifdef PLUMB_SANITIZED
std::size_t allocated() {
  return __sanitizer_get_current_allocated_bytes();
}
#else
std::size_t allocated() {
  const auto info = mallinfo2();
  return info.uordblks + info.hblkhd;
}
#endif

struct Wanted {
  std::string name;
  std::string sections;                ///< behind a bare scene
  std::vector<std::string> arrays;     ///< beside those of a bare scene
  std::vector<std::string> overrides;  ///< "method.integrator=rk3"
};

void PrintTo(const Wanted& wanted, std::ostream* out) {
  *out << wanted.name;
}

const std::string bare =
    "[scene]\ndimension = 3\nmax_steps = 2\n[body]\nsize = [1, 1, 1]\nspacing = 0.03125\nlayout = \"cell\"\n"
    "[material]\nyoung = 1e7\npoisson = 0.3\ndensity = 1000\n";

class Arrays : public ::testing::TestWithParam<Wanted> {};

std::vector<std::string> expected_names(const Wanted& wanted) {
  std::vector<std::string> names = {
      "reference positions and volumes",       "volumes per slot", "bond table", "displacement", "velocity",
      "first Piola-Kirchhoff stress, a window"};
  names.insert(names.end(), wanted.arrays.begin(), wanted.arrays.end());
  std::sort(names.begin(), names.end());
  return names;
}

TEST_P(Arrays, AreTheOnesThatTheSceneNeedsAndNoMemoryIsKeptBeside) {
  const Wanted& wanted = GetParam();
  const Scene scene = parse_scene(bare + wanted.sections, "test.toml", wanted.overrides);
  make_tlsph<3>(scene);  // whatever is allocated once for all
  const std::size_t before = allocated();
  TlsphBody<3> simulation = make_tlsph<3>(scene);
  std::size_t listed = 0;
  std::vector<std::string> names;
  for (const auto& array : arrays_of(simulation)) {
    listed += array.bytes;
    names.push_back(array.name);
  }
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, expected_names(wanted));
  std::size_t held = 0;  // while it runs: the time step has its arrays, too
  ASSERT_TRUE(run<3>(simulation.solid, simulation.state, simulation.integrator, simulation.control,
                     [&](const Solid<3>&, const State<3>& state) {
                       if (state.step == 1) held = allocated() - before;
                       return true;
                     })
                  .completed());
  // an array of one number per particle is 3 % of the least of these; names, functions and the like are less
  EXPECT_NEAR(static_cast<double>(held), static_cast<double>(listed), 0.015 * static_cast<double>(listed));
}

const std::string loops = "bond table, in the order of the loops",
                  closest = "closest pairs, for the time step";

INSTANTIATE_TEST_SUITE_P(
    Scenes, Arrays,
    ::testing::Values(
        Wanted{"Bare", "", {"integrator verlet", loops, closest}, {}},
        Wanted{"Rk3", "", {"integrator rk3", loops, closest}, {"method.integrator=rk3"}},
        Wanted{"FixedStep", "", {"integrator verlet", loops}, {"method.time_step=1e-6"}},
        Wanted{"Jst", "[jst]\neta4 = 0.01\n", {"integrator verlet", loops, closest, "jst"}, {}},
        Wanted{"JstSecondOrder", "[jst]\neta2 = 0.01\n", {"integrator verlet", loops, closest, "jst"}, {}},
        Wanted{"Hourglass",
               "[hourglass]\nalpha = 0.5\n",
               {"integrator verlet", loops, closest, "hourglass", "deformation gradient"},
               {}},
        Wanted{"Clamped",
               "[[boundary]]\nface = \"x-\"\nkind = \"clamped\"\n",
               {"integrator verlet", loops, closest, "supports", "prescribed velocities"},
               {}},
        Wanted{
            "Projection", "[projection]\n", {"integrator verlet", loops, closest, "force", "projection"}, {}},
        Wanted{"Jittered", "", {"integrator verlet", closest}, {"body.jitter=0.2"}}),
    [](const auto& scene) { return scene.param.name; });

/// eta2 = 0 keeps one array of JST, not two.
TEST(Arrays, OfAPartThatIsOffAreNotThere) {
  const auto bytes_of_jst = [](const std::string& section) {
    for (const auto& array : arrays_of(make_tlsph<3>(parse_scene(bare + section, "test.toml"))))
      if (array.name == "jst") return array.bytes;
    return std::size_t{0};
  };
  const std::size_t one = bytes_of_jst("[jst]\neta4 = 0.01\n");
  EXPECT_GT(one, 0U);
  EXPECT_EQ(bytes_of_jst("[jst]\neta4 = 0.01\neta2 = 0.01\n"), 2 * one);
  EXPECT_EQ(bytes_of_jst(""), 0U);
}

/// The limit for a lattice, adjoint force and Verlet, everything included.
TEST(Arrays, Take250BytesAParticleAtMost) {
  const auto simulation = make_tlsph<3>(parse_scene(bare, "test.toml", {"body.spacing=0.025"}));
  std::size_t bytes = 0;
  for (const auto& array : arrays_of(simulation)) bytes += array.bytes;
  EXPECT_EQ(simulation.solid.cloud.size(), 64000);
  EXPECT_LE(bytes, 250U * 64000U);
}

}  // namespace
}  // namespace plumb
