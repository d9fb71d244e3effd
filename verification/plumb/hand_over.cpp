#include "verification/plumb/hand_over.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "lib/core/error.hpp"
#include "verification/plumb/house_words.hpp"
#include "verification/plumb/program.hpp"

namespace plumb::app {

std::vector<std::string> house_words() {
  return {std::begin(words_of_house), std::end(words_of_house)};
}

void hand_over(const std::vector<std::string>& words, char** arguments) {
  const std::size_t at = !words.empty() && words.front() == "help" ? 1 : 0;
  const auto house = house_words();
  if (words.size() <= at || std::find(house.begin(), house.end(), words[at]) == house.end()) return;
  const auto program = program_beside("plumb-house");
  if (program) ::execv(program->c_str(), arguments);  // returns only if it fails
  throw InputError(fmt::format("\"{}\" is a command of plumb-house", words[at]),
                   program ? "it cannot be started" : "that program is not beside this one",
                   "install the package plumbline-house, or build the target plumb-house");
}

}  // namespace plumb::app
