#pragma once
#include <vector>

#include "lib/output/particles.hpp"
#include "lib/output/table.hpp"
#include "lib/particles/snapshot.hpp"
#include "lib/run/output_fields.hpp"

namespace plumb {

/// What the particle files show of one state: positions, displacement, velocity, J = det F, the pressure
/// -tr(sigma)/3 and the von Mises stress of the Cauchy stress sigma, and whatever else the scheme shows. In
/// 2D sigma_33 counts, and under plane stress F_33; in 1D sigma_22 and sigma_33 count.
template <int d>
class Frame {
 public:
  /// `fields`: names of output_fields.hpp, shown beside the rest. Throws InputError if the scheme lacks one.
  explicit Frame(const Snapshot<d>& shown, const std::vector<std::string>& fields = {});

  /// Writes it as the next file of the series.
  void write(ParticleSeries& series) const;
  /// Returns its numbers as a table, one row a particle.
  Table table() const;

 private:
  double time_;
  std::vector<double> position_, displacement_, velocity_, determinant_, pressure_, von_mises_;
  std::vector<NamedValues> more_;
  std::vector<ShownField> fields_;
};

}  // namespace plumb
