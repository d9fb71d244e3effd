#pragma once
#include <string>
#include <vector>

namespace plumb::app {

/// Lists the commands of plumb-house, which were those of plumb: calls of them are handed over.
std::vector<std::string> house_words();

/// Becomes plumb-house, which stands beside this program, if the words call one of its commands. Otherwise
/// returns. Throws InputError if it is not there.
void hand_over(const std::vector<std::string>& words, char** arguments);

}  // namespace plumb::app
