#pragma once
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "lib/core/sentences.hpp"

namespace plumb {

/// Something that the user gave cannot be used. The message is made of problem, why and suggestion by
/// sentences(). The program ends with exit code 2; nothing has been computed or written.
class InputError : public std::runtime_error {
 public:
  InputError(std::string problem, std::string why, std::string suggestion)
      : std::runtime_error(sentences(problem, why, suggestion)),
        problem_(std::move(problem)),
        why_(std::move(why)),
        suggestion_(std::move(suggestion)) {}

  const std::string& problem() const { return problem_; }
  const std::string& why() const { return why_; }
  const std::string& suggestion() const { return suggestion_; }

 private:
  std::string problem_, why_, suggestion_;
};

/// The one of `names` nearest to `name` by edit distance, for "did you mean"; empty if none is near.
std::string nearest_name(std::string_view name, const std::vector<std::string>& names);

/// "a, b, c" for messages.
std::string join(const std::vector<std::string>& names, std::string_view separator = ", ");

/// The error for an unknown name: what was asked for, the nearest valid one, and all of them.
InputError unknown_name(std::string_view what, std::string_view name, const std::vector<std::string>& valid);

}  // namespace plumb
