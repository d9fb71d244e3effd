// Results with many rows: the same text as before they were written one by one, in little memory.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "lib/output/json.hpp"
#include "lib/output/table.hpp"
#include "tests/support/program.hpp"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;
using test::run_plumb;

/// The text shows methods side by side where they are several, and of waves what they mean.
TEST(Rows, JsonAndCsvAreThoseOfTheWholeTable) {
  for (const char* command :
       {"oned gradient --field sin:5 --field poly:1,2 --estimator standard,improved --pair W0,W1 --n 30",
        "oned gradient --field sin:5 --n 5000 --estimator improved", "oned kernels --at 0.1 --n 50",
        "oned response --points 7"}) {
    SCOPED_TRACE(command);
    const test::TemporaryFolder folder;
    const std::string json = (folder / "a.json").string(), csv = (folder / "a.csv").string();
    const auto outcome = run_plumb(std::string(command) + " --json " + json + " --csv " + csv);
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    const std::string text = test::content_of(folder / "a.json");
    const Json whole = Json::parse(text);
    EXPECT_EQ(json_text(whole), text);
    const Table table = table_of(whole["rows"]);
    ASSERT_GT(table.rows.size(), 1u);
    EXPECT_EQ(csv_text(table), test::content_of(folder / "a.csv"));
    if (std::string(command).find("kernels") == std::string::npos) continue;
    const std::string plain = plain_text(table);
    EXPECT_EQ(outcome.out.substr(outcome.out.size() - plain.size()), plain);
  }
}

/// Largest resident memory of a call [bytes].
double peak_of(const std::string& arguments) {
  const std::string command = "exec " PLUMB_EXECUTABLE " " + arguments;
  const pid_t child = ::fork();
  if (child == 0) {
    ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    ::_exit(127);
  }
  int status = 0;
  rusage usage{};
  EXPECT_EQ(::wait4(child, &status, 0, &usage), child);
  EXPECT_EQ(status, 0) << command;
  return 1024.0 * static_cast<double>(usage.ru_maxrss);  // Linux counts in KiB
}

/// A row took 5 kB when all were held as JSON. Held are 8 bytes for each estimate; beside them the cloud, the
/// supports and the exact values: some 30 numbers for the two rows of a particle.
TEST(Rows, ManyRowsTakeLittleMemory) {
  const test::TemporaryFolder folder;
  const std::string call =
      "oned gradient --field sin:5 --quiet --json " + (folder / "a.json").string() + " --n ";
  const double few = peak_of(call + "100"), many = peak_of(call + "50000");
  constexpr double rows = 2 * 50000;
  EXPECT_LT((many - few) / rows, 500);
}

}  // namespace
}  // namespace plumb
