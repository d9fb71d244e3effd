#pragma once
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace plumb::test {

/// A file of settings with one key that nothing knows, and the line where that stands.
struct Strange {
  std::string section;  ///< header of the section that has it, such as "[[boundary]]"
  long line;
  std::string text;
};

/// The text with such a key behind the header of each of its sections, one at a time.
inline std::vector<Strange> with_strange_keys(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  std::vector<Strange> all;
  for (std::size_t at = 0; at < lines.size(); ++at) {
    if (!lines[at].starts_with("[")) continue;
    Strange one{lines[at].substr(0, lines[at].find_last_of(']') + 1), static_cast<long>(at) + 2, ""};
    for (std::size_t k = 0; k < lines.size(); ++k)
      one.text += lines[k] + (k == at ? "\nstrange_key = 1\n" : "\n");
    all.push_back(one);
  }
  return all;
}

}  // namespace plumb::test
