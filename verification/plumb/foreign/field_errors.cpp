#include "verification/plumb/foreign/field_errors.hpp"

#include <cmath>

#include "lib/core/dimension.hpp"
#include "verification/plumb/foreign/suspicion.hpp"

namespace plumb::app {
namespace {

/// Distance from the boundary, over the domain's length, that parts it in two.
constexpr double boundary_share = 0.1;

template <class Values, class Exact>
double l2_of(const std::vector<double>& volume, const Values& values, const Exact& exact) {
  double sum = 0;
  for (std::size_t k = 0; k < values.size(); ++k) sum += volume[k] * (values[k] - exact(k)).squaredNorm();
  return std::sqrt(sum);
}

template <int d>
ForeignErrors errors_in(const PointFile& points, const std::string& file, const SolutionChoice& choice,
                        double time, const PointOptions& options) {
  const mms::ExactFields<d> exact = choice.fields<d>();
  const ForeignField<d> field = foreign_field<d>(points, file, exact.domain, options);
  ForeignErrors out{file, field.X.size(), field.spacing, 0, field.estimated_volumes, {}, {}, {}, {}};
  double inside = 0, boundary = 0, size = 0, largest = -1;
  for (std::size_t k = 0; k < field.X.size(); ++k) {
    const Vec<d> u = exact.motion(field.X[k], time).displacement;
    const double error = (field.displacement[k] - u).squaredNorm(), V = field.volume[k];
    const bool deep = exact.domain.depth(field.X[k]) > boundary_share * exact.domain.length();
    (deep ? inside : boundary) += V * error;
    size += V * u.squaredNorm();
    out.volume += V;
    if (std::sqrt(error) <= largest) continue;
    largest = std::sqrt(error);
    out.worst.assign(field.X[k].data(), field.X[k].data() + d);
  }
  out.norms["l2"] = std::sqrt(inside + boundary);
  out.norms["l2_inside"] = std::sqrt(inside);
  out.norms["l2_boundary"] = std::sqrt(boundary);
  out.norms["linf"] = largest;
  if (size > 0) out.norms["relative_l2"] = std::sqrt((inside + boundary) / size);
  const auto motion = [&](std::size_t k) { return exact.motion(field.X[k], time); };
  if (!field.velocity.empty())
    out.norms["velocity_l2"] =
        l2_of(field.volume, field.velocity, [&](std::size_t k) { return motion(k).velocity; });
  if (!field.F.empty())
    out.norms["h1"] = l2_of(field.volume, field.F, [&](std::size_t k) { return motion(k).F; });
  if (!field.P.empty())
    out.norms["stress_l2"] =
        l2_of(field.volume, field.P, [&](std::size_t k) { return exact.first_piola(field.X[k], time); });
  if (!field.cauchy.empty())
    out.norms["cauchy_l2"] =
        l2_of(field.volume, field.cauchy, [&](std::size_t k) { return exact.cauchy(field.X[k], time); });
  out.suspicion = suspicion<d>(field, exact, time);
  out.region = region<d>(field, exact, time);
  return out;
}

}  // namespace

ForeignErrors errors_of(const std::string& file, const SolutionChoice& choice, double time,
                        const PointOptions& options) {
  const PointFile points = read_points(file);
  return plumb::with_dimension(choice.dimension,
                               [&]<int d>() { return errors_in<d>(points, file, choice, time, options); });
}

}  // namespace plumb::app
