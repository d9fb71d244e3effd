// Campaign files with bytes and words exchanged: each is answered by an exit code, none crashes or hangs.
// Nothing is started (--judge). PLUMB_FUZZ_SECONDS lengthens it.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "places.hpp"
#include "tests/fuzz/mutator.hpp"
#include "tests/support/program.hpp"

namespace plumb {
namespace {

TEST(CampaignLong, AnyFileIsAnswered) {
  std::vector<std::string> files;
  for (const char* name : {"finite_elements", "calculix", "lammps"})
    files.push_back(
        test::content_of(PLUMBLINE_SOURCE_DIR "/verification/campaigns/" + std::string(name) + ".toml"));
  const auto words = fuzz::known_words();
  const char* seconds = std::getenv("PLUMB_FUZZ_SECONDS");
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const test::TemporaryFolder folder;
  for (const char* input : {"finite_elements.json.in", "lammps.in"})
    std::filesystem::copy_file(PLUMBLINE_SOURCE_DIR "/verification/campaigns/" + std::string(input),
                               folder / input);
  fuzz::Mutator mutator;
  int n = 0, judged = 0;
  for (; !testing::Test::HasFailure(); ++n) {
    if (seconds ? std::chrono::duration<double>(Clock::now() - start).count() > std::atof(seconds) : n == 300)
      break;
    const std::string text = mutator.mutated(files, words);
    std::ofstream(folder / "campaign.toml") << text;
    const auto outcome =
        test::run_shell("cd '" + folder.path().string() +
                        "' && ulimit -t 20 && " PLUMB_EXECUTABLE " campaign campaign.toml --judge --out out");
    EXPECT_TRUE(outcome.code == 1 || outcome.code == 2) << outcome.code << '\n'
                                                        << text;  // nothing has been run: never 0
    EXPECT_FALSE(outcome.error.empty() && outcome.out.empty()) << text;
    judged += outcome.code == 1;
  }
  EXPECT_GT(judged, 10);  // some are campaigns still
  if (seconds) std::printf("%d files in %s s, %d of them campaigns\n", n, seconds, judged);
}

}  // namespace
}  // namespace plumb
