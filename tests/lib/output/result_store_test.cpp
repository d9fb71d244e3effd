// Results come back bit for bit under the text that decides them, and under no other.
#include "lib/output/result_store.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "lib/core/error.hpp"
#include "lib/output/sealed.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

namespace fs = std::filesystem;

/// Bytes of every value, with ends of lines and zeros.
std::string all_bytes() {
  std::string bytes;
  for (int k = 0; k < 512; ++k) bytes.push_back(static_cast<char>(k % 256));
  return bytes;
}

class Results : public testing::Test {
 protected:
  void SetUp() override { store_.keep("a text", all_bytes(), "--cache"); }
  test::TemporaryFolder folder_;
  ResultStore store_{folder_ / "kept"};
};

TEST_F(Results, ComeBackBitForBit) {
  EXPECT_EQ(store_.find("a text"), all_bytes());
  EXPECT_EQ(ResultStore(folder_ / "kept").find("a text"), all_bytes());
  store_.keep("a text", "", "--cache");
  EXPECT_EQ(store_.find("a text"), "");
}

TEST_F(Results, OfAnotherTextAreNotTaken) {
  for (const char* other : {"", "a text ", "a tex", "another text"})
    EXPECT_EQ(store_.find(other), std::nullopt);
  // two texts of one name: the file says to which text it belongs
  fs::rename(store_.file_of("a text"), store_.file_of("another text"));
  EXPECT_EQ(store_.find("another text"), std::nullopt);
}

TEST_F(Results, ThatAreDamagedAreNotThere) {
  const auto file = store_.file_of("a text");
  const auto size = fs::file_size(file);
  for (const std::uintmax_t at : {std::uintmax_t{3}, size / 2, size - 1}) {
    store_.keep("a text", all_bytes(), "--cache");
    std::fstream(file, std::ios::in | std::ios::out | std::ios::binary)
        .seekp(static_cast<std::streamoff>(at))
        .put('\x7e');
    EXPECT_EQ(store_.find("a text"), std::nullopt) << at;
    store_.keep("a text", all_bytes(), "--cache");
    fs::resize_file(file, at);
    EXPECT_EQ(store_.find("a text"), std::nullopt) << at;
  }
}

TEST_F(Results, AreRemovedWithTheFolderThatTheyLeaveEmpty) {
  store_.keep("another", "bytes", "--cache");
  store_.remove("a text");
  EXPECT_EQ(store_.find("a text"), std::nullopt);
  EXPECT_EQ(store_.find("another"), "bytes");
  store_.remove("another");
  EXPECT_FALSE(fs::exists(folder_ / "kept"));
}

TEST_F(Results, OfAStoreWithoutFolderAreNotKept) {
  const ResultStore none;
  none.keep("a text", "bytes", "--cache");
  EXPECT_FALSE(none.keeps());
  EXPECT_EQ(none.find("a text"), std::nullopt);
}

TEST_F(Results, WhereNoFolderCanBeAreRefused) {
  std::ofstream(folder_ / "file") << "a file";
  EXPECT_THROW(ResultStore(folder_ / "file").keep("a text", "bytes", "--cache"), InputError);
}

TEST(NameOfContent, IsTheUuidOfTheText) {
  // uuid.uuid5(uuid.NAMESPACE_OID, "plumbline") of Python's standard library
  EXPECT_EQ(name_of_content("plumbline"), "f24c39c4-066f-5cb9-9609-313a46d7a989");
}

}  // namespace
}  // namespace plumb
