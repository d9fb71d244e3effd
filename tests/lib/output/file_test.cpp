#include "lib/output/file.hpp"

#include <gtest/gtest.h>

#include "lib/core/error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

namespace fs = std::filesystem;

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(File, ReplacesTheWholeContent) {
  const test::TemporaryFolder folder;
  replace_file(folder / "a.json", std::string(100000, 'x'));
  replace_file(folder / "a.json", "short");
  EXPECT_EQ(test::content_of(folder / "a.json"), "short");
  EXPECT_EQ(files_in(folder.path()), 1U) << "the temporary file must be gone";
}

/// As runs side by side do with one cache.
TEST(File, ThreadsReplaceOneFileAtOnce) {
  const test::TemporaryFolder folder;
  int failures = 0;
#pragma omp parallel for num_threads(4) schedule(dynamic) reduction(+ : failures)
  for (int n = 0; n < 400; ++n) try {
      replace_file(folder / "cache", std::string(10000, static_cast<char>('a' + n % 4)));
    } catch (const OutputError&) {
      ++failures;
    }
  EXPECT_EQ(failures, 0);
  const std::string content = test::content_of(folder / "cache");
  EXPECT_EQ(content, std::string(10000, content.front())) << "a part of one, a part of another";
  EXPECT_EQ(files_in(folder.path()), 1U);
}

TEST(File, FollowsASymbolicLink) {
  const test::TemporaryFolder folder;
  replace_file(folder / "real", "old");
  fs::create_symlink(folder / "real", folder / "link");
  replace_file(folder / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(test::content_of(folder / "real"), "new");
}

TEST(File, AFullDiskIsAnOutputErrorThatNamesTheFile) {
  try {
    replace_file("/dev/full", "content");
    FAIL() << "no error";
  } catch (const OutputError& error) {
    EXPECT_NE(std::string(error.what()).find("/dev/full"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("No space left"), std::string::npos);
  }
}

TEST(File, AFolderThatVanishedLeavesNothing) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(replace_file(folder / "gone/a.json", "x"), OutputError);
  EXPECT_EQ(files_in(folder.path()), 0U);
}

TEST(File, OnlyUnfinishedFilesOfOurNamesAreRemoved) {
  const test::TemporaryFolder folder;
  for (const char* name :
       {"a.csv.12.tmp", "a.csv.x2.tmp", "a.csv..tmp", "b.csv.12.tmp", "a.csv", "a.csv.tmp"})
    std::ofstream(folder / name) << "x";
  remove_unfinished_files(folder.path(), [](const std::string& name) { return name == "a.csv"; });
  EXPECT_FALSE(fs::exists(folder / "a.csv.12.tmp"));
  EXPECT_EQ(files_in(folder.path()), 5U);
  EXPECT_NO_THROW(remove_unfinished_files(folder / "gone", [](const std::string&) { return true; }));
}

TEST(File, WhatIsLeftToTheSystemIsWholeAndCanBeFlushed) {
  const test::TemporaryFolder folder;
  replace_file(folder / "a", "content", Flush::later);
  EXPECT_EQ(test::content_of(folder / "a"), "content");
  EXPECT_NO_THROW(flush_file(folder / "a"));
  EXPECT_THROW(flush_file(folder / "gone"), OutputError);
}

TEST(File, BadPlacesAreRefusedAtTheDoorAndNothingIsMade) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(require_writable(folder / "gone/a.json", "--json"), InputError);
  EXPECT_THROW(require_writable(folder.path(), "--json"), InputError);
  EXPECT_THROW(require_writable("", "--json"), InputError);
  EXPECT_NO_THROW(require_writable(folder / "a.json", "--json"));
  EXPECT_EQ(files_in(folder.path()), 0U);
}

}  // namespace
}  // namespace plumb
