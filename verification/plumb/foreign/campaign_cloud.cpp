#include "verification/plumb/foreign/campaign_cloud.hpp"

#include <fmt/format.h>

#include "lib/core/dimension.hpp"
#include "lib/core/error.hpp"
#include "lib/geometry/shaped_cloud.hpp"
#include "lib/output/particles.hpp"
#include "lib/output/table.hpp"
#include "mms/annulus.hpp"

namespace plumb::app {
namespace {

template <int d>
Cloud<d> filling(const mms::Domain<d>& domain, double spacing, Layout layout, double jitter,
                 std::uint64_t seed) {
  if constexpr (d == 2)
    if (domain.shape == mms::Domain<d>::Shape::annulus)
      return shaped_cloud(mms::annulus_shape(domain.inner, domain.outer),
                          Filling{spacing, layout, false, jitter, seed});
  Cloud<d> cloud = lattice<d>(domain.box, cells_of<d>(domain.box, spacing), layout);
  return jitter > 0 ? jittered<d>(std::move(cloud), jitter, seed, layout) : cloud;
}

/// Refuses what does not fit before any run.
template <int d>
void require_fit(const mms::Domain<d>& domain, double spacing) {
  constexpr double most = 1e7;  // points, a kilobyte each as text and in memory
  const double points = (domain.box.size / spacing).prod();
  if (points > most)
    throw InputError(fmt::format("a cloud of {:.3g} points for the spacing {:g} m", points, spacing),
                     fmt::format("at most {:.0g} are written", most), "use larger spacings");
  if (domain.shape == mms::Domain<d>::Shape::box) cells_of<d>(domain.box, spacing);
}

template <int d>
CampaignCloud cloud_in(const SolutionChoice& choice, double spacing, Layout layout, double jitter,
                       std::uint64_t seed) {
  const mms::Domain<d> domain = choice.fields<d>().domain;
  const Cloud<d> cloud = filling<d>(domain, spacing, layout, jitter, seed);
  CampaignCloud out{d, {}, cloud.V, {}, {}};
  for (const Vec<d>& X : cloud.X)
    for (int a = 0; a < 3; ++a) out.positions.push_back(a < d ? X[a] : 0.0);
  for (int a = 0; a < d; ++a) {
    out.low.push_back(domain.box.origin[a]);
    out.high.push_back(domain.box.origin[a] + domain.box.size[a]);
  }
  return out;
}

/// Displacements and velocities at the beginning, three numbers a point each.
struct Start {
  std::vector<double> displacement, velocity;
};

template <int d>
Start start_of(const CampaignCloud& cloud, const SolutionChoice& choice) {
  const mms::ExactFields<d> exact = choice.fields<d>();
  Start start;
  for (std::size_t k = 0; k < cloud.positions.size(); k += 3) {
    const mms::Motion<d> m = exact.motion(Eigen::Map<const Vec<d>>(cloud.positions.data() + k), 0);
    for (int a = 0; a < 3; ++a) {
      start.displacement.push_back(a < d ? m.displacement[a] : 0.0);
      start.velocity.push_back(a < d ? m.velocity[a] : 0.0);
    }
  }
  return start;
}

std::string table_text(const CampaignCloud& cloud, const Start& start) {
  const auto d = static_cast<std::size_t>(cloud.dimension);
  Table table{{"id"}, {}};
  for (const auto& [key, axes, unit] :
       {std::tuple("", "XYZ", " [m]"), {"u", "xyz", " [m]"}, {"v", "xyz", " [m/s]"}})
    for (std::size_t a = 0; a < d; ++a) table.columns.push_back(fmt::format("{}{}{}", key, axes[a], unit));
  table.columns.push_back(fmt::format("volume [m^{}]", d));
  for (std::size_t k = 0; k < cloud.volumes.size(); ++k) {
    std::vector<Cell> row{static_cast<long long>(k + 1)};
    for (const auto* values : {&cloud.positions, &start.displacement, &start.velocity})
      for (std::size_t a = 0; a < d; ++a) row.emplace_back((*values)[3 * k + a]);
    row.emplace_back(cloud.volumes[k]);
    table.rows.push_back(row);
  }
  return csv_text(table);
}

std::string lammps_text(const CampaignCloud& cloud, const SolutionChoice& choice, const Start& start) {
  std::string text = fmt::format("LAMMPS data file, written by Plumbline: {}\n\n{} atoms\n1 atom types\n\n",
                                 in_words(choice), cloud.volumes.size());
  const double margin = 0.5 * (cloud.high[0] - cloud.low[0]);
  for (std::size_t a = 0; a < 3; ++a) {
    const bool flat = a >= cloud.low.size();
    text += fmt::format("{:.17g} {:.17g} {}lo {}hi\n", flat ? -0.5 : cloud.low[a] - margin,
                        flat ? 0.5 : cloud.high[a] + margin, "xyz"[a], "xyz"[a]);
  }
  double volume = 0;
  for (const double V : cloud.volumes) volume += V;
  text += fmt::format("\nMasses\n\n1 {:.17g}\n\nAtoms # atomic\n\n",
                      choice.elastic.density * volume / static_cast<double>(cloud.volumes.size()));
  for (std::size_t k = 0; k < cloud.volumes.size(); ++k)
    text += fmt::format("{} 1 {:.17g} {:.17g} {:.17g}\n", k + 1,
                        cloud.positions[3 * k] + start.displacement[3 * k],
                        cloud.positions[3 * k + 1] + start.displacement[3 * k + 1],
                        cloud.positions[3 * k + 2] + start.displacement[3 * k + 2]);
  text += "\nVelocities\n\n";
  for (std::size_t k = 0; k < cloud.volumes.size(); ++k)
    text += fmt::format("{} {:.17g} {:.17g} {:.17g}\n", k + 1, start.velocity[3 * k],
                        start.velocity[3 * k + 1], start.velocity[3 * k + 2]);
  return text;
}

std::string vtp_of(const CampaignCloud& cloud, const Start& start) {
  std::vector<double> moved = cloud.positions;
  for (std::size_t k = 0; k < moved.size(); ++k) moved[k] += start.displacement[k];
  const std::vector<PointField> fields{{"displacement [m]", 3, start.displacement},
                                       {"velocity [m/s]", 3, start.velocity},
                                       {"volume", 1, cloud.volumes}};
  return vtp_text({0, 3, moved, fields});
}

}  // namespace

CampaignCloud campaign_cloud(const SolutionChoice& choice, double spacing, Layout layout, double jitter,
                             std::uint64_t seed) {
  return plumb::with_dimension(choice.dimension,
                               [&]<int d>() { return cloud_in<d>(choice, spacing, layout, jitter, seed); });
}

void require_cloud_fits(const SolutionChoice& choice, double spacing) {
  plumb::with_dimension(choice.dimension,
                        [&]<int d>() { require_fit<d>(choice.fields<d>().domain, spacing); });
}

void require_cloud_format(const std::string& name) {
  if (name.find('/') != std::string::npos ||
      !(name.ends_with(".csv") || name.ends_with(".vtp") || name.ends_with(".data")))
    throw InputError(fmt::format("the cloud \"{}\"", name),
                     "it is a file of each run's folder: .csv, .vtp or LAMMPS's .data", "name it cloud.csv");
}

std::string cloud_text(const CampaignCloud& cloud, const SolutionChoice& choice, const std::string& name) {
  const Start start =
      plumb::with_dimension(choice.dimension, [&]<int d>() { return start_of<d>(cloud, choice); });
  if (name.ends_with(".data")) return lammps_text(cloud, choice, start);
  return name.ends_with(".vtp") ? vtp_of(cloud, start) : table_text(cloud, start);
}

}  // namespace plumb::app
