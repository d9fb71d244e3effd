// The corpus that the fuzzers have found, with the normal compiler: every file is answered, none crashes.
#include <gtest/gtest.h>

#include "places.hpp"
#include "tests/fuzz/targets.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

template <class Target>
void replay(const std::string& name, Target target) {
  int files = 0;
  for (const auto& file : std::filesystem::directory_iterator(PLUMBLINE_SOURCE_DIR "/tests/fuzz/corpus/" + name)) {
    SCOPED_TRACE(file.path().string());
    EXPECT_NO_THROW(fuzz::feed(target, test::content_of(file.path())));
    ++files;
  }
  EXPECT_GT(files, 0);
}

TEST(Corpus, Scene) {
  replay("scene", fuzz::scene);
}
TEST(Corpus, Study) {
  replay("study", fuzz::study);
}
TEST(Corpus, Expression) {
  replay("expression", fuzz::expression);
}
TEST(Corpus, Field) {
  replay("field", fuzz::field);
}
TEST(Corpus, Checkpoint) {
  replay("checkpoint", fuzz::checkpoint);
}

}  // namespace
}  // namespace plumb
