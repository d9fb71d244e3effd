// The corpus that the fuzzers have found, with the normal compiler: every file is answered, none crashes,
// none takes a second. Then the files mutated, the same way at every call: a short fuzzing without clang,
// which PLUMB_FUZZ_SECONDS lengthens.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "places.hpp"
#include "tests/fuzz/mutator.hpp"
#include "tests/fuzz/targets.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

std::vector<std::string> corpus(const std::string& name) {
  std::vector<std::filesystem::path> files;
  for (const auto& file :
       std::filesystem::directory_iterator(PLUMBLINE_SOURCE_DIR "/tests/fuzz/corpus/" + name))
    files.push_back(file.path());
  std::sort(files.begin(), files.end());  // the folder's own order differs from machine to machine
  std::vector<std::string> texts;
  texts.reserve(files.size());
  for (const auto& file : files) texts.push_back(test::content_of(file));
  return texts;
}

/// CPU time rather than the clock's: other tests run beside this one.
template <class Target>
void expect_answer(Target target, const std::string& bytes) {
  const std::clock_t start = std::clock();
  EXPECT_NO_THROW(fuzz::feed(target, bytes)) << testing::PrintToString(bytes);
  EXPECT_LT(std::clock() - start, CLOCKS_PER_SEC) << "a hang: " << testing::PrintToString(bytes);
}

template <class Target>
void replay(const std::string& name, Target target, int mutations) {
  const auto inputs = corpus(name), known = fuzz::known_words();
  ASSERT_FALSE(inputs.empty());
  ASSERT_GT(known.size(), 50u);
  for (const auto& input : inputs) expect_answer(target, input);
  fuzz::Mutator mutator;
  const char* seconds = std::getenv("PLUMB_FUZZ_SECONDS");  // of CPU time, instead of the number
  const std::clock_t start = std::clock();
  int n = 0;
  for (; !testing::Test::HasFailure(); ++n) {
    if (seconds ? static_cast<double>(std::clock() - start) > std::atof(seconds) * CLOCKS_PER_SEC
                : n == mutations)
      break;
    expect_answer(target, mutator.mutated(inputs, known));
  }
  if (seconds) std::printf("%s: %d inputs in %s s of CPU time\n", name.c_str(), n, seconds);
}

TEST(Corpus, Scene) {
  replay("scene", fuzz::scene, 4000);
}
TEST(Corpus, Study) {
  replay("study", fuzz::study, 4000);
}
TEST(Corpus, Expression) {
  replay("expression", fuzz::expression, 10000);
}
TEST(Corpus, Field) {
  replay("field", fuzz::field, 20000);
}
TEST(Corpus, Table) {
  replay("table", fuzz::table, 20000);
}
TEST(Corpus, Points) {
  replay("points", fuzz::points, 10000);
}
TEST(Corpus, Surface) {
  replay("surface", fuzz::surface, 10000);
}
TEST(Corpus, Hdf5) {
  replay("hdf5", fuzz::hdf5, 2000);
}
TEST(Corpus, Checkpoint) {
  replay("checkpoint", fuzz::checkpoint, 2000);
}

}  // namespace
}  // namespace plumb
