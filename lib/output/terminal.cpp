#include "lib/output/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <sstream>

namespace plumb {
namespace {

constexpr int usual_columns = 80;

bool begins_character(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
}

std::size_t characters(const std::string& text) {
  std::size_t count = 0;
  for (const char c : text) count += begins_character(c) ? 1 : 0;
  return count;
}

}  // namespace

int terminal_columns(int descriptor) {
  winsize size{};
  if (::isatty(descriptor) == 0 || ::ioctl(descriptor, TIOCGWINSZ, &size) != 0 || size.ws_col == 0)
    return usual_columns;
  return size.ws_col;
}

std::string wrapped(const std::string& text, std::size_t columns, std::size_t start, std::size_t indent) {
  std::string result;
  std::size_t column = start;
  bool line_has_words = false;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::size_t length = characters(word);
    if (line_has_words && column + 1 + length > columns) {
      result += "\n" + std::string(indent, ' ');
      column = indent;
      line_has_words = false;
    }
    if (line_has_words) {
      result += ' ';
      ++column;
    }
    result += word;
    column += length;
    line_has_words = true;
  }
  return result;
}

std::string shortened(const std::string& line, std::size_t columns) {
  if (characters(line) <= columns) return line;
  const std::string end = columns > 2 ? ".." : "";
  std::string result;
  std::size_t count = 0;
  for (const char c : line) {
    if (begins_character(c) && ++count > columns - end.size()) break;
    result += c;
  }
  return result + end;
}

}  // namespace plumb
