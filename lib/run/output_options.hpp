#pragma once
#include <optional>
#include <string>
#include <vector>

namespace plumb {

/// [[output.probe]]: follows the particle nearest to a reference point.
struct Probe {
  std::string name;
  std::vector<double> at;  ///< [m], as many as the dimension
};

/// [output]: nothing is written that is not asked for.
struct Output {
  std::optional<double> every;  ///< [s]; nullopt: the first and the last state only
  std::optional<double>
      checkpoint;       ///< [s] between files to resume from; they are also kept at every early end
  bool vtk = false;     ///< particles as .vtp with a .pvd
  bool series = false;  ///< energies, momenta and probes against time as CSV
  bool budget = false;  ///< momenta and energy by the cause that changed them, every step, as CSV
  std::vector<std::string> fields;  ///< names of output_fields.hpp, beside what files always have
  std::vector<Probe> probes;
};

}  // namespace plumb
