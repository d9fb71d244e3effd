// What happens in a process of its own does not happen here.
#include "lib/input/own_process.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <stdexcept>
#include <vector>

namespace plumb {
namespace {

constexpr ProcessLimits limits{64 << 20, 2};

TEST(OwnProcess, ReturnsWhatWasMade) {
  const std::string long_text(1 << 20, 'x');  // more than a pipe holds
  EXPECT_EQ(made_in_own_process([&] { return long_text + "y"; }, limits), long_text + "y");
  EXPECT_EQ(made_in_own_process([] { return std::string(); }, limits), "");
}

TEST(OwnProcess, ReturnsNothingWhereItBreaks) {
  EXPECT_FALSE(made_in_own_process([]() -> std::string { throw std::runtime_error("no"); }, limits));
  EXPECT_FALSE(made_in_own_process(
      []() -> std::string {
        std::signal(SIGSEGV, SIG_DFL);  // sanitizers would say something
        std::raise(SIGSEGV);
        return "";
      },
      limits));
}

TEST(OwnProcess, ReturnsNothingWhereItTakesTooMuch) {
  EXPECT_FALSE(made_in_own_process(
      [] {
        std::string text;
        volatile bool over = false;  // never: until its CPU time is over
        while (!over) {
        }
        return text;
      },
      {64 << 20, 1}));
#ifndef __SANITIZE_ADDRESS__
  EXPECT_FALSE(made_in_own_process([] { return std::string(std::size_t{1} << 32, 'x'); }, limits));
#endif
}

}  // namespace
}  // namespace plumb
