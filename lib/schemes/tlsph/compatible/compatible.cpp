#include "lib/schemes/tlsph/compatible/compatible.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>

#include "lib/geometry/position_text.hpp"
#include "lib/output/file.hpp"
#include "lib/output/result_store.hpp"
#include "lib/schemes/tlsph/compatible/solver/least_change.hpp"
#include "lib/schemes/tlsph/compatible/solver/projection_cache.hpp"

namespace plumb {
namespace {

/// What is promised of the constraints, relative to areas and volumes of order 1.
constexpr double tolerance = 1e-12;
/// What a surface may miss of the divergence theorem: without one of the faces of a box it misses 1.
constexpr double most_defect = 0.5;

/// V_i <- V_i (1 + a + b . X_i) with the body's volume and centroid: what fixed volumes must have, THEORY
/// (11.6).
template <int d>
void match_moments(AreaTable<d>& table, const Cloud<d>& cloud, const Surface<d>& surface) {
  using Moments = Eigen::Matrix<double, d + 1, 1>;
  const double volume = surface.volume / std::pow(table.spacing, d);
  const double size = std::pow(surface.volume, 1.0 / d);
  const auto moments_at = [&](Index i) {
    Moments m;
    m[0] = 1;
    m.template tail<d>() = (cloud.X[i] - surface.centroid) / size;
    return m;
  };
  for (int pass = 0; pass < 2; ++pass) {  // the second one removes the rounding of the first
    Moments wrong = Moments::Unit(0) * volume;
    Eigen::Matrix<double, d + 1, d + 1> gram = Eigen::Matrix<double, d + 1, d + 1>::Zero();
    for (Index i = 0; i < table.particles(); ++i) {
      const Moments m = moments_at(i);
      wrong -= table.volume[i] * m;
      gram += table.volume[i] * m * m.transpose();
    }
    const Moments change = gram.ldlt().solve(wrong);
    for (Index i = 0; i < table.particles(); ++i) table.volume[i] *= 1 + change.dot(moments_at(i));
  }
}

template <int d>
void check(const AreaTable<d>& table, const Cloud<d>& cloud, const CompatibleReport& report) {
  if (!(report.divergence_defect < most_defect))
    throw InputError(fmt::format("the surface violates the divergence theorem by {:.3g} of the volume",
                                 report.divergence_defect),
                     "it is not closed, or too coarse for its particles", "use a smaller spacing");
  if (!(report.divergence_remainder < tolerance))
    throw InputError(fmt::format("the surface violates the divergence theorem by {:.3g} of the volume",
                                 report.divergence_remainder),
                     "too few particles lie on it to correct that", "use a smaller spacing");
  if (!(report.residual < tolerance))
    throw InputError(fmt::format("compatible area vectors violate a constraint by {:.3g}", report.residual),
                     "the neighbours of some particle do not allow closedness and exactness together",
                     "use a larger beta");
  for (Index i = 0; i < table.particles(); ++i)
    if (!(table.volume[i] > 0))
      throw InputError(fmt::format("particle {} at {} m gets the volume {:.3g} spacings^{}", i,
                                   position_text<d>(cloud.X[i]), table.volume[i], d),
                       "compatible volumes must be positive, and the cloud is too irregular there",
                       "move the particle, use a larger beta, or volumes = \"fixed\"");
}

/// The table from the cache if it meets the constraints, otherwise the least change, which the cache then
/// keeps.
template <int d>
LeastChange project(AreaTable<d>& table, const Cloud<d>& cloud, const CompatibleOptions<d>& options,
                    CompatibleReport& report) {
  if (options.cache.empty()) return least_change(table, cloud.X, options.volume_weight, options.solver);
  require_folder(options.cache, "[compatible] cache");  // before the work, not after it
  const ResultStore store(options.cache);
  const std::string text = projection_text(table, options.volume_weight);
  AreaTable<d> kept = table;
  if (const auto bytes = store.find(text); bytes && read_projection<d>(*bytes, kept)) {
    LeastChange found{};
    found.start_residual = largest<d>(missing(table));
    found.residual = largest<d>(missing(kept));
    for (std::size_t n = 0; n < table.pairs.size(); ++n)
      found.largest_change = std::max(found.largest_change, (kept.pairs[n].A - table.pairs[n].A).norm());
    if (found.residual < tolerance) {
      table = std::move(kept);
      report.from_cache = true;
      return found;
    }
  }
  const LeastChange found = least_change(table, cloud.X, options.volume_weight, options.solver);
  if (found.residual < tolerance) store.keep(text, projection_bytes(table), "[compatible] cache");
  return found;
}

}  // namespace

template <int d>
CompatibleReport make_compatible(Cloud<d>& cloud, std::vector<std::vector<BondConstants<d>>>& bonds,
                                 const RadialKernel<d>& kernel, double h,
                                 const CompatibleOptions<d>& options) {
  CompatibleReport report;
  const Surface<d> surface = options.surface(cloud);
  const BoundaryVectors<d> boundary = boundary_vectors<d>(cloud, kernel, h, surface);
  report.divergence_defect = boundary.defect;
  report.divergence_remainder = boundary.remainder;
  AreaTable<d> table = area_table<d>(cloud, bonds, kernel, h, boundary.B);
  const std::vector<double> start = table.volume;
  if (options.volume_weight == 0) match_moments(table, cloud, surface);
  const LeastChange found = project(table, cloud, options, report);
  report.start_residual = found.start_residual;
  report.residual = found.residual;
  report.refinements = found.refinements;
  report.iterations = found.iterations;
  report.levels = found.levels;
  report.unknowns = found.unknowns;
  report.largest_change = found.largest_change;
  for (Index i = 0; i < cloud.size(); ++i)
    report.largest_volume_change =
        std::max(report.largest_volume_change, std::abs(table.volume[i] / start[i] - 1));
  check(table, cloud, report);
  write_back(table, cloud, bonds);
  return report;
}

template <int d>
void project_compatible(BondOptions<d>& options, const CompatibleOptions<d>& how,
                        const std::shared_ptr<CompatibleReport>& report) {
  const auto kernel = options.kernel;
  const double h = options.smoothing_length;
  options.project = [=](Cloud<d>& cloud, const Neighbours&,
                        std::vector<std::vector<BondConstants<d>>>& bonds) {
    CompatibleReport found = make_compatible<d>(cloud, bonds, kernel, h, how);
    if (!report) return;
    found.why_projected = report->why_projected;
    *report = found;
  };
}

template CompatibleReport make_compatible<1>(Cloud<1>&, std::vector<std::vector<BondConstants<1>>>&,
                                             const RadialKernel<1>&, double, const CompatibleOptions<1>&);
template CompatibleReport make_compatible<2>(Cloud<2>&, std::vector<std::vector<BondConstants<2>>>&,
                                             const RadialKernel<2>&, double, const CompatibleOptions<2>&);
template CompatibleReport make_compatible<3>(Cloud<3>&, std::vector<std::vector<BondConstants<3>>>&,
                                             const RadialKernel<3>&, double, const CompatibleOptions<3>&);
template void project_compatible<1>(BondOptions<1>&, const CompatibleOptions<1>&,
                                    const std::shared_ptr<CompatibleReport>&);
template void project_compatible<2>(BondOptions<2>&, const CompatibleOptions<2>&,
                                    const std::shared_ptr<CompatibleReport>&);
template void project_compatible<3>(BondOptions<3>&, const CompatibleOptions<3>&,
                                    const std::shared_ptr<CompatibleReport>&);

}  // namespace plumb
