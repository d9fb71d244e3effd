#pragma once
#include <string>
#include <string_view>

namespace plumb {

/// What the user is told: "problem. Why. Suggestion.", each part a sentence that ends in a stop. Parts that
/// are empty are left out. The problem keeps its first letter, since a place or a command stands in front of
/// it.
std::string sentences(std::string_view problem, std::string_view why, std::string_view suggestion);

}  // namespace plumb
