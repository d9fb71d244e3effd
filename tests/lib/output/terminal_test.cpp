#include "lib/output/terminal.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <unistd.h>

#include <sstream>

#include "lib/output/bar_line.hpp"
#include "lib/output/progress.hpp"

namespace plumb {
namespace {

/// Both ends of a terminal of that width.
struct Terminal {
  int master = -1, slave = -1;
  explicit Terminal(unsigned short columns) {
    winsize size{24, columns, 0, 0};
    EXPECT_EQ(::openpty(&master, &slave, nullptr, nullptr, &size), 0);
  }
  ~Terminal() {
    ::close(master);
    ::close(slave);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
};

TEST(TerminalColumns, AreThoseOfTheWindowAnd80IfItDoesNotSay) {
  EXPECT_EQ(terminal_columns(Terminal(57).slave), 57);
  EXPECT_EQ(terminal_columns(Terminal(0).slave), 80);
  const int file = ::open("/dev/null", O_RDONLY);
  EXPECT_EQ(terminal_columns(file), 80);
  ::close(file);
}

TEST(Wrapped, LinesAreAsLongAsTheyMayBe) {
  EXPECT_EQ(wrapped("one two three four", 9, 0, 2), "one two\n  three\n  four");
  EXPECT_EQ(wrapped("one two", 7, 0, 0), "one two");
  EXPECT_EQ(wrapped("one two", 7, 1, 3), "one\n   two") << "the first line begins at column 1";
  EXPECT_EQ(wrapped("abcdefgh ij", 4, 0, 0), "abcdefgh\nij") << "a word is not broken";
  EXPECT_EQ(wrapped("\u00b5\u00b5 \u00b5\u00b5", 5, 0, 0), "\u00b5\u00b5 \u00b5\u00b5")
      << "characters, not bytes";
  EXPECT_EQ(wrapped("", 5, 0, 0), "");
}

TEST(Shortened, KeepsTheWidth) {
  EXPECT_EQ(shortened("abcdef", 6), "abcdef");
  EXPECT_EQ(shortened("abcdefg", 6), "abcd..");
  EXPECT_EQ(shortened("\u00b5\u00b5\u00b5\u00b5", 3), "\u00b5..");
  EXPECT_EQ(shortened("abc", 1), "a");
}

TEST(BarLine, NeverExceedsTheWidth) {
  const std::string left = rate_text(0.1, 0.5, 0) + ", 12 min 20 s left", note = "t = 0.1234 s, step 123456";
  for (std::size_t columns = 1; columns <= 140; ++columns)
    for (const double fraction : {0.0, 0.123, 1.0}) {
      const std::string line = bar_line("bending column", fraction, left, note, columns);
      EXPECT_LE(line.size(), columns) << line;
    }
  EXPECT_EQ(bar_line("run", 0.5, "5 %/s, 10 s left", "", 80),
            "run [###############...............]  50 %, 5 %/s, 10 s left");
  EXPECT_EQ(bar_line("run", 0.5, "5 %/s, 10 s left", "", 41), "run [#####......]  50 %, 5 %/s, 10 s left");
}

/// What the program draws on a terminal of 60 columns, read at its other end.
TEST(Progress, FitsTheTerminalThatItIsDrawnOn) {
  const Terminal terminal(60);
  std::FILE* stream = ::fdopen(::dup(terminal.slave), "w");
  {
    Progress progress("a scene with a rather long name", Progress::Style::bar, stream);
    ::usleep(250000);  // the bar begins after 0.2 s
    progress.update(0.25, "t = 0.123456 s, step 123456, 1.23e+04 steps/s");
  }
  std::fclose(stream);
  char text[4096];
  const ssize_t count = ::read(terminal.master, text, sizeof text);
  ASSERT_GT(count, 0);
  const std::string drawn(text, static_cast<std::size_t>(count));
  const std::string line = drawn.substr(1, drawn.find('\x1b') - 1);  // between the return and the erasing
  EXPECT_LT(line.size(), 60u) << line;
  EXPECT_NE(line.find(" 25 %"), std::string::npos) << line;
}

}  // namespace
}  // namespace plumb
