#pragma once
#include <algorithm>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "places.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb::fuzz {

/// Words of the readers: the quoted lines of words.dict.
inline std::vector<std::string> known_words() {
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

}  // namespace plumb::fuzz
