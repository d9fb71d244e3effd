// The corpus that the fuzzers have found, with the normal compiler: every file is answered, none crashes,
// none takes a second. Then the files mutated, the same way at every call: a short fuzzing without clang.
#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <random>

#include "places.hpp"
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

/// Words of the readers: the quoted lines of words.dict.
std::vector<std::string> words() {
  std::vector<std::string> all;
  std::istringstream lines(test::content_of(PLUMBLINE_SOURCE_DIR "/tests/fuzz/words.dict"));
  for (std::string line; std::getline(lines, line);)
    if (line.size() > 2 && line.front() == '"') all.push_back(line.substr(1, line.size() - 2));
  return all;
}

/// Changes inputs as a fuzzer would: bytes, ranges, words, and parts of other inputs.
class Mutator {
 public:
  std::string mutated(const std::vector<std::string>& inputs, const std::vector<std::string>& known) {
    std::string text = inputs[below(inputs.size())];
    for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
      const std::size_t at = below(text.size() + 1),
                        length = below(std::min<std::size_t>(text.size() - at, 32) + 1);
      switch (below(5)) {
        case 0:
          text.insert(at, 1, static_cast<char>(below(256)));
          break;
        case 1:
          text.erase(at, length);
          break;
        case 2:
          text.insert(at, text.substr(at, length));
          break;
        case 3:
          text.replace(at, length, known[below(known.size())]);
          break;
        default: {
          const std::string& other = inputs[below(inputs.size())];
          text.replace(at, length, other.substr(below(other.size() + 1), length));
        }
      }
    }
    return text;
  }

 private:
  /// Not std::uniform_int_distribution, whose numbers differ between libraries.
  std::size_t below(std::size_t bound) { return random_() % bound; }
  std::mt19937_64 random_{20261125};
};

/// CPU time rather than the clock's: other tests run beside this one.
template <class Target>
void expect_answer(Target target, const std::string& bytes) {
  const std::clock_t start = std::clock();
  EXPECT_NO_THROW(fuzz::feed(target, bytes)) << testing::PrintToString(bytes);
  EXPECT_LT(std::clock() - start, CLOCKS_PER_SEC) << "a hang: " << testing::PrintToString(bytes);
}

template <class Target>
void replay(const std::string& name, Target target, int mutations) {
  const auto inputs = corpus(name), known = words();
  ASSERT_FALSE(inputs.empty());
  ASSERT_GT(known.size(), 50u);
  for (const auto& input : inputs) expect_answer(target, input);
  Mutator mutator;
  for (int n = 0; n < mutations && !testing::Test::HasFailure(); ++n)
    expect_answer(target, mutator.mutated(inputs, known));
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
TEST(Corpus, Checkpoint) {
  replay("checkpoint", fuzz::checkpoint, 2000);
}

}  // namespace
}  // namespace plumb
