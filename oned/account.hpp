#pragma once
#include <string>
#include <utility>
#include <vector>

#include "oned/study.hpp"

namespace plumb::oned {

/// Whether a sentence of the paper is true of the method as read in method.md, measured with this program.
enum class Holds {
  yes,
  no,
  partly  ///< under a condition that the paper does not state; `finding` names it
};
std::string_view name_of(Holds holds);

/// One sentence of paper 000 about the 1D study, and what was measured.
struct Sentence {
  std::string where;    ///< "4.1", "2.2", with the figure
  std::string claim;    ///< in our words, close to the print
  Holds holds;          ///< decided from the measured numbers, not by hand
  std::string finding;  ///< one or two plain sentences
  std::vector<std::pair<std::string, double>> measured;
};

/// The sentences of section 4.1 (and two of section 2.2) with the numbers that decide them. Takes some CPU
/// seconds: it runs both readings of Figure 6.
std::vector<Sentence> account();
/// The same from the studies of figure_6_study(), where they exist already.
std::vector<Sentence> account(const Study& fixed_ratio, const Study& fixed_radius);

}  // namespace plumb::oned
