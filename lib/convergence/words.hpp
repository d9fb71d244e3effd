#pragma once
#include <array>
#include <string_view>

namespace plumb {

/// A word that a command, a table or the report says about an order, a study or a check, explained.
struct VerdictWord {
  std::string_view word;
  std::string_view meaning;  ///< one or two sentences
};

/// All such words. Help, manual page and report show this table.
inline constexpr std::array<VerdictWord, 17> verdict_words{{
    {"pass", "The declared order (or number) is the measured one."},
    {"fail",
     "The measured order is lower than the declared one, a "
     "number is another than the one expected, or a run broke."},
    {"above",
     "The measured order is higher than the declared one. The declaration may be too "
     "low, the norm may see only a part of the error, or the levels may be too coarse "
     "for the term that decides in the end. Neither a pass nor a failure of the scheme."},
    {"not-asymptotic",
     "The slope still changes from level to level, or a signed "
     "error crosses zero: there is no one power law yet."},
    {"noise-floor",
     "Fewer than four levels lie above round-off or the error of the model, so no order is left to see."},
    {"too-few-levels", "Fewer than four levels were given. They make no verdict."},
    {"inconclusive",
     "The interval of the order is too wide to tell one order from another; or, of a whole study, a declared "
     "order neither passes nor fails."},
    {"asymptotic", "No order was declared, and at least four levels lie on one power law."},
    {"stalled", "No order was declared, and the errors stop falling at a size that no floor explains."},
    {"divergent", "No order was declared, and the errors grow under refinement or are not finite."},
    {"undeclared", "Nothing was declared, so nothing is judged: orders are reported only."},
    {"monotone", "The differences between grids shrink with one sign, so an order and a limit exist."},
    {"oscillatory", "The differences between grids change sign. Three grids show no order then."},
    {"converged", "The finest grids agree to round-off, so there is nothing left to extrapolate."},
    {"contradicted", "What was claimed is excluded by the measured interval."},
    {"not-computed", "There is no result to judge, because a run was refused or broke off."},
    {"at-floor", "This level is at the floor of round-off. It is shown, but not fitted."},
}};

/// Explains a word of the table. Empty if it has no such word.
constexpr std::string_view meaning_of(std::string_view word) {
  for (const VerdictWord& entry : verdict_words)
    if (entry.word == word) return entry.meaning;
  return {};
}

}  // namespace plumb
