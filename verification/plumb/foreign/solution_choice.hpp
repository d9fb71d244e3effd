#pragma once
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "mms/exact_fields.hpp"

namespace CLI {
class App;
}

namespace plumb {
class Section;
}

namespace plumb::app {

/// A manufactured solution with parameters and material, for what another program computed.
struct SolutionChoice {
  std::string name;
  int dimension = 2;
  std::map<std::string, double> parameters;
  Elastic elastic{};
  LawChoice law{"neo-hookean"};

  template <int d>
  mms::ExactFields<d> fields() const {
    return mms::exact_fields<d>(name, parameters, elastic, law);
  }
};

/// The options of commands that need one.
struct SolutionOptions {
  std::string name;
  int dimension = 0;                   ///< 0: that of the points, or the lowest that the solution has
  std::vector<std::string> overrides;  ///< "parameters.amplitude=0.02", "material.young=17 MPa"
};

/// Adds --dimension and --set.
void add_solution_options(CLI::App& command, SolutionOptions& options);

/// Reads [parameters] and [material], as in scenes, below `root`. Without a material it is the solution's
/// own, neo- Hookean. Throws InputError for what cannot be, such as a dimension that the solution does not
/// have.
SolutionChoice read_solution_choice(const std::string& name, int dimension, const Section& root);

/// The same from options.
SolutionChoice solution_choice(const SolutionOptions& options);

/// The time [s] of a text that is a number or has a unit, such as "5 ms". Throws InputError.
double seconds_of(const std::string& text);

/// "swinging-plate in 2D, neo-hookean, E = 1.7e+07 Pa, nu = 0.3, rho = 1100 kg/m^3, amplitude = 0.01".
std::string in_words(const SolutionChoice& choice);

}  // namespace plumb::app
