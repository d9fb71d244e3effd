#pragma once
#include <string>
#include <utility>
#include <vector>

#include "oned/study.hpp"

namespace plumb::oned {

/// Whether a sentence of the paper is true of the method as it is to be read, measured with this program.
enum class Holds {
  yes,
  no,
  partly  ///< under a condition that the paper does not state; `finding` names it
};
std::string_view name_of(Holds holds);

/// One sentence of paper 000 about the 1D study, and what was measured.
struct Remark {
  std::string where;    ///< "4.1", "2.2", with the figure
  std::string claim;    ///< in our words, close to the print
  Holds holds;          ///< decided from the measured numbers, not by hand
  std::string finding;  ///< one or two plain sentences
  std::vector<std::pair<std::string, double>> measured;
};

/// How R behaves while N grows in Figure 6. The text does not say; only one reading fits its sentences.
enum class Reading {
  fixed_ratio,  ///< R = 4 dx
  fixed_radius  ///< R = 0.5 m, which is 4 dx at the paper's dx = 1/8 m
};

/// The study behind Figure 6: X^3 + 1 and sin(5X); standard with W1, improved with W1 and W0; N = 40 to 5120.
RefinementStudy figure_6_study(Reading reading);

/// The sentences of section 4.1 (and two of section 2.2) with the numbers that decide them. About one CPU
/// second: it runs both readings of Figure 6.
std::vector<Remark> account();

}  // namespace plumb::oned
