#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "lib/geometry/layout.hpp"
#include "verification/plumb/foreign/solution_choice.hpp"

namespace plumb::app {

/// Points that fill a solution's domain.
struct CampaignCloud {
  int dimension = 2;
  std::vector<double> positions;  ///< three a point [m], z = 0 in 2D
  std::vector<double> volumes;    ///< [m^d]
  std::vector<double> low, high;  ///< of the box around them [m]
};

/// A lattice of that spacing over the solution's domain (an annulus: what it leaves of one), its inner points
/// moved by `jitter` spacings at random. Throws InputError for a spacing that does not fit.
CampaignCloud campaign_cloud(const SolutionChoice& choice, double spacing, Layout layout, double jitter,
                             std::uint64_t seed);

/// Throws InputError for a spacing that does not fit into the domain, or gives more points than are written.
void require_cloud_fits(const SolutionChoice& choice, double spacing);

/// Throws InputError for a name that ends in none of .csv, .vtp and .data.
void require_cloud_format(const std::string& name);

/// The cloud as a file: a table (.csv) or VTK (.vtp) with id, volume and the solution's displacement and
/// velocity at t = 0, or LAMMPS data (.data, atom_style atomic, masses of the points, velocities).
std::string cloud_text(const CampaignCloud& cloud, const SolutionChoice& choice, const std::string& name);

}  // namespace plumb::app
