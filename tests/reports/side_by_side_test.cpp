#include "reports/run/side_by_side.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <barrier>
#include <fstream>
#include <stdexcept>
#include <vector>

#include "reports/report.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

using namespace plumb::reports;
namespace fs = std::filesystem;

TEST(SideBySide, EachPieceOnceAndNoMoreWorkersThanAsked) {
  std::vector<std::atomic<int>> calls(50);
  std::atomic<int> running = 0, most = 0;
  run::side_by_side(calls.size(), 3, [&](std::size_t n) {
    const int now = ++running;
    for (int seen = most; seen < now && !most.compare_exchange_weak(seen, now);) {
    }
    ++calls[n];
    --running;
  });
  for (const auto& count : calls) EXPECT_EQ(count, 1);
  EXPECT_LE(most, 3);
  run::side_by_side(0, 3, [](std::size_t) { FAIL(); });
}

/// Two pieces that wait for each other end only if they run at the same time.
TEST(SideBySide, WorkersRunAtTheSameTime) {
  std::barrier both(2);
  run::side_by_side(2, 2, [&](std::size_t) { both.arrive_and_wait(); });
}

TEST(SideBySide, FirstFailureEndsItAndReachesTheCaller) {
  std::vector<int> done;
  EXPECT_THROW(run::side_by_side(10, 1,
                                 [&](std::size_t n) {
                                   if (n == 3) throw std::runtime_error("piece 3");
                                   done.push_back(static_cast<int>(n));
                                 }),
               std::runtime_error);
  EXPECT_EQ(done, (std::vector<int>{0, 1, 2}));
}

TEST(SideBySide, StopsWhenItIsNotToGoOn) {
  int done = 0;
  run::side_by_side(
      10, 1, [&](std::size_t) { ++done; }, [&] { return done < 4; });
  EXPECT_EQ(done, 4);
}

/// A program in place of plumb that keeps a folder while it runs and writes down whether others had one, and
/// how many threads it was given. Speed is measured by studies that run alone with all cores.
TEST(SideBySide, StudiesThatMeasureSpeedRunAloneOnAllCores) {
  const plumb::test::TemporaryFolder folder;
  std::ofstream(folder / "program") << "#!/bin/sh\n"
                                       "mkdir running-$$; sleep 0.05\n"
                                       "echo \"$1 $(ls -d running-* | wc -l) $*\" >> seen; rmdir running-$$\n"
                                       "while [ $# -gt 0 ]; do [ \"$1\" = --json ] && echo '{}' > \"$2\"; "
                                       "shift; done\n";
  fs::permissions(folder / "program", fs::perms::owner_all);
  ReportOptions options;
  options.out = folder / "out";
  options.program = folder / "program";
  options.root = folder.path();
  options.threads = 4;
  options.only = {"speed", "gradients"};
  make_report(options);
  std::ifstream in(folder / "seen");
  int benches = 0, others = 0;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("bench ")) {
      ++benches;
      EXPECT_TRUE(line.starts_with("bench 1 ")) << line;
      EXPECT_NE(line.find("--threads 4"), std::string::npos) << line;
    } else {
      ++others;
      EXPECT_NE(line.find("--threads 1"), std::string::npos) << line;
    }
  }
  EXPECT_EQ(benches, 2);
  EXPECT_GE(others, 2);
}

}  // namespace
