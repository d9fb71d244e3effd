#include "mms/exact_fields.hpp"

#include <memory>

#include "lib/material/point.hpp"
#include "mms/central_difference.hpp"

namespace plumb::mms {
namespace {

/// P at the end of the motion of one point, for a law that remembers.
template <int d>
Mat<d> stress_of_path(const ExactFields<d>& fields, const LawChoice& law, const Elastic& elastic,
                      int increments, const Vec<d>& X, double t) {
  const MaterialPoint point = make_point(law, elastic);
  PointState state;
  Mat<3> F = Mat<3>::Identity();
  for (int k = 0; k <= increments; ++k) {
    F.topLeftCorner<d, d>() = fields.motion(X, t * k / increments).F;
    state = point(F);
  }
  const Mat<3> P = F.determinant() * state.cauchy * F.inverse().transpose();
  return P.topLeftCorner<d, d>();
}

template <int d>
void with_history(ExactFields<d>& fields, const LawChoice& law, const Elastic& elastic, int increments) {
  make_point(law, elastic);  // refuses what cannot be
  const auto base = std::make_shared<const ExactFields<d>>(fields);
  fields.first_piola = [=](const Vec<d>& X, double t) {
    return stress_of_path<d>(*base, law, elastic, increments, X, t);
  };
  const double step = 0.00125 * fields.domain.length();
  fields.stress_divergence = [=, stress = fields.first_piola](const Vec<d>& X, double t) {
    Vec<d> divergence = Vec<d>::Zero();
    for (int A = 0; A < d; ++A)
      divergence +=
          central_difference([&](double by) -> Mat<d> { return stress(X + by * Vec<d>::Unit(A), t); }, step)
              .col(A);
    return divergence;
  };
}

}  // namespace

template <int d>
ExactFields<d> exact_fields(std::string_view name, const std::map<std::string, double>& parameters,
                            const Elastic& elastic, const LawChoice& law, int increments) {
  if (increments < 1)
    throw InputError("no increments", "the path of a law with history has at least one", "");
  require_law(law, elastic);
  const bool remembers = has_history(law.name);
  const auto exact = std::make_shared<const Manufactured<d>>(
      manufactured<d>(name, parameters, elastic, remembers ? LawChoice("neo-hookean", {}, law.plane) : law));
  ExactFields<d> fields;
  fields.density = exact->density;
  fields.period = exact->period;
  fields.domain = exact->domain;
  fields.motion = exact->motion;
  fields.first_piola = [exact](const Vec<d>& X, double t) {
    return exact->first_piola(exact->motion(X, t).F);
  };
  fields.stress_divergence = [exact](const Vec<d>& X, double t) {
    return exact->stress_divergence(exact->motion(X, t));
  };
  if (remembers) with_history(fields, law, elastic, increments);
  return fields;
}

template ExactFields<1> exact_fields<1>(std::string_view, const std::map<std::string, double>&,
                                        const Elastic&, const LawChoice&, int);
template ExactFields<2> exact_fields<2>(std::string_view, const std::map<std::string, double>&,
                                        const Elastic&, const LawChoice&, int);
template ExactFields<3> exact_fields<3>(std::string_view, const std::map<std::string, double>&,
                                        const Elastic&, const LawChoice&, int);

}  // namespace plumb::mms
