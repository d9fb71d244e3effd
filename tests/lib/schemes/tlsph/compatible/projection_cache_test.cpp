// Tables that were projected before come back from the disk bit for bit, and only for the same start.
#include "lib/schemes/tlsph/compatible/solver/projection_cache.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "lib/output/sealed.hpp"
#include "lib/schemes/tlsph/compatible/compatible.hpp"
#include "tests/support/solids.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

struct Made {
  Cloud<2> cloud;
  std::vector<std::vector<BondConstants<2>>> bonds;
  CompatibleReport report;
};

Made made(double jitter, const std::filesystem::path& cache, double volume_weight = 1e-7) {
  Made m{testing::block<2>(7, Layout::node, jitter), {}, {}};
  const BondOptions<2> options = testing::options<2>({}, m.cloud.spacing);
  const Neighbours all = find_neighbours<2>(m.cloud, options.kernel.support * options.smoothing_length);
  for (Index i = 0; i < m.cloud.size(); ++i) m.bonds.push_back(bonds_of<2>(m.cloud, all.of(i), i, options));
  CompatibleOptions<2> how;
  how.cache = cache;
  how.volume_weight = volume_weight;
  m.report = make_compatible<2>(m.cloud, m.bonds, options.kernel, options.smoothing_length, how);
  return m;
}

bool same(const Made& a, const Made& b) {
  bool all = a.cloud.V == b.cloud.V;
  for (std::size_t i = 0; i < a.bonds.size(); ++i)
    for (std::size_t n = 0; n < a.bonds[i].size(); ++n)
      all = all && a.bonds[i][n].stencil == b.bonds[i][n].stencil;
  return all;
}

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  return files;
}

TEST(ProjectionCache, GivesTheSameBits) {
  const test::TemporaryFolder folder;
  const Made without = made(0.2, {});
  const Made first = made(0.2, folder.path() / "tables"), second = made(0.2, folder.path() / "tables");
  EXPECT_FALSE(without.report.from_cache);
  EXPECT_FALSE(first.report.from_cache);
  EXPECT_TRUE(second.report.from_cache);
  EXPECT_TRUE(same(without, first));
  EXPECT_TRUE(same(first, second));
  EXPECT_EQ(first.report.residual, second.report.residual);
  EXPECT_NEAR(first.report.largest_change, second.report.largest_change, 1e-14);  // added up another way
  EXPECT_EQ(files_in(folder.path() / "tables").size(), 1U);
}

TEST(ProjectionCache, AnotherStartHasAnotherName) {
  const test::TemporaryFolder folder;
  made(0.2, folder.path());
  EXPECT_FALSE(made(0.1, folder.path()).report.from_cache);
  EXPECT_FALSE(made(0.2, folder.path(), 1e-4).report.from_cache);
  EXPECT_EQ(files_in(folder.path()).size(), 3U);
}

// A file that was cut off, changed, or belongs to something else is made anew.
TEST(ProjectionCache, DamagedFilesAreNotUsed) {
  const test::TemporaryFolder folder;
  const Made first = made(0.2, folder.path());
  const auto file = files_in(folder.path()).front();
  const auto size = std::filesystem::file_size(file);
  for (const auto& damage : {std::string("short"), std::string("bit"), std::string("other")}) {
    SCOPED_TRACE(damage);
    if (damage == "short") std::filesystem::resize_file(file, size - 8);
    if (damage == "bit") {
      std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
      stream.seekp(static_cast<std::streamoff>(size / 2));
      stream.put('\x7f');
    }
    if (damage == "other") {  // whole and of the right size, but the table of another cloud
      AreaTable<2> table;
      table.volume.assign(first.cloud.V.size(), 1.0);
      std::size_t pairs = 0;
      for (const auto& bonds : first.bonds) pairs += bonds.size();
      table.pairs.resize(pairs / 2);
      for (auto& pair : table.pairs) pair.A.setZero();
      std::ifstream in(file, std::ios::binary);
      std::string all(std::istreambuf_iterator<char>(in), {});
      const std::string other = projection_bytes(table);
      std::string whole(unsealed(all));
      whole.replace(whole.size() - other.size(), other.size(), other);
      std::ofstream(file, std::ios::binary) << sealed(whole);
      EXPECT_EQ(std::filesystem::file_size(file), size);
    }
    const Made again = made(0.2, folder.path());
    EXPECT_FALSE(again.report.from_cache);
    EXPECT_TRUE(same(first, again));
    EXPECT_TRUE(made(0.2, folder.path()).report.from_cache);
  }
}

}  // namespace
}  // namespace plumb
