#pragma once
#include <string_view>
#include <vector>

namespace plumb {

/// The verdict on one order or number, as far as the end of a command depends on it.
struct Judged {
  std::string_view verdict;  ///< a word of words.hpp
  bool declared = true;      ///< judged against something that was declared before
};

/// Gives the status of a command from all its verdicts. If something was declared, only that counts: "fail"
/// if one fails or was not computed, "pass" if all pass, else "inconclusive". If nothing was declared:
/// "divergent" if an error grows or is not finite, "too-few-levels" if fewer than four levels were given for
/// one of them, else "undeclared".
std::string_view status_of(const std::vector<Judged>& all);

/// Gives the exit code of a command that judges: 0 for "pass" and "undeclared", 1 for any other status. Bad
/// input (2) is an InputError and has no status.
int exit_code_of(std::string_view status);

}  // namespace plumb
