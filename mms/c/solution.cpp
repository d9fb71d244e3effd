// One solution: how it is chosen, and its fields at points.
#include <algorithm>
#include <cmath>
#include <vector>

#include "lib/core/error.hpp"
#include "mms/c/chosen.hpp"
#include "mms/c/guard.hpp"
#include "mms/c/values.hpp"

namespace plumb::c {
namespace {

void require_finite(double value, const char* what) {
  if (!std::isfinite(value))
    throw InputError(std::string(what) + " is not finite", "it must be a number", "");
}

template <int d>
Vec<d> point_at(const double* X, std::size_t k) {
  return Eigen::Map<const Vec<d>>(X + k * d);
}

/// A vector, or a tensor row by row, behind the others.
template <class Value>
void put(const Value& value, std::vector<double>& out) {
  for (Eigen::Index i = 0; i < value.rows(); ++i)
    for (Eigen::Index A = 0; A < value.cols(); ++A) out.push_back(value(i, A));
}

template <int d>
void put_quantity(const mms::ExactFields<d>& fields, plumb_quantity quantity, const Vec<d>& X, double t,
                  std::vector<double>& out) {
  switch (quantity) {
    case PLUMB_DISPLACEMENT:
      return put(fields.motion(X, t).displacement, out);
    case PLUMB_VELOCITY:
      return put(fields.motion(X, t).velocity, out);
    case PLUMB_ACCELERATION:
      return put(fields.motion(X, t).acceleration, out);
    case PLUMB_F:
      return put(fields.motion(X, t).F, out);
    case PLUMB_P:
      return put(fields.first_piola(X, t), out);
    case PLUMB_CAUCHY:
      return put(fields.cauchy(X, t), out);
    case PLUMB_BODY_FORCE:
      return put(fields.body_force(X, t), out);
    case PLUMB_BODY_FORCE_PER_MASS:
      return put(Vec<d>(fields.body_force(X, t) / fields.density), out);
    case PLUMB_STATIC_LOAD:
      return put(Vec<d>(-fields.stress_divergence(X, t)), out);
  }
  throw InputError("there is no such quantity", "plumb_quantity lists them", "");
}

void require_points(const double* X, std::size_t count) {
  require(X, "X");
  for (std::size_t k = 0; k < count; ++k) require_finite(X[k], "a position");
}

void require_all_finite(const std::vector<double>& values) {
  for (const double value : values)
    if (!std::isfinite(value))
      throw InputError("the solution is not finite at one of the points",
                       "the law has no stress there, or the point is far outside of the domain", "");
}

/// Changes a copy, so that a refusal leaves the solution as it was.
template <class Change>
plumb_status change(plumb_solution* solution, Change&& what) {
  return guarded([&] {
    require(solution, "solution");
    what(*solution);
    solution->changed();
  });
}

}  // namespace

std::vector<double> values_of(const plumb_solution& solution, plumb_quantity quantity, std::size_t points,
                              const double* X, double time) {
  std::vector<double> all;
  const auto d = static_cast<std::size_t>(solution.dimension);
  require_points(X, points * d);
  require_finite(time, "time");
  all.reserve(points * plumb_components(&solution, quantity));
  solution.with_fields([&]<int dim>(const mms::ExactFields<dim>& fields) {
    for (std::size_t k = 0; k < points; ++k)
      put_quantity<dim>(fields, quantity, point_at<dim>(X, k), time, all);
  });
  require_all_finite(all);
  return all;
}

}  // namespace plumb::c

using namespace plumb;
using namespace plumb::c;

extern "C" {
plumb_status plumb_new(const char* name, int dimension, plumb_solution** solution) {
  return guarded([&] {
    require(name, "name");
    require(solution, "solution");
    const mms::SolutionEntry entry = mms::solution_entry(name);
    if (std::find(entry.dimensions.begin(), entry.dimensions.end(), dimension) == entry.dimensions.end())
      throw InputError("the solution " + entry.name + " does not exist in " + std::to_string(dimension) + "D",
                       "", "see plumb_solution_exists_in()");
    *solution = new plumb_solution(entry, dimension);
  });
}
void plumb_free(plumb_solution* solution) {
  delete solution;  // NOLINT: what plumb_new() made
}
plumb_status plumb_set(plumb_solution* solution, const char* parameter, double value) {
  return change(solution, [&](plumb_solution& s) {
    require(parameter, "parameter");
    s.parameters.set(parameter, value);
  });
}
plumb_status plumb_set_law(plumb_solution* solution, const char* law, double young, double poisson,
                           double density) {
  return change(solution, [&](plumb_solution& s) {
    require(law, "law");
    if (!(young > 0) || !std::isfinite(young)) throw InputError("young is not positive and finite", "", "");
    if (!(density > 0) || !std::isfinite(density))
      throw InputError("density is not positive and finite", "", "");
    if (!(poisson > -1 && poisson < 0.5))
      throw InputError("poisson is not between -1 and 0.5", "at 0.5 the bulk modulus is infinite", "");
    parameters_of_law(law);  // refuses an unknown name
    s.elastic = {young, poisson, density};
    s.law = LawChoice(law, {}, s.law.plane);
  });
}
plumb_status plumb_set_law_parameter(plumb_solution* solution, const char* parameter, double value) {
  return change(solution, [&](plumb_solution& s) {
    require(parameter, "parameter");
    std::vector<std::string> known;
    for (const LawParameter& about : parameters_of_law(s.law.name)) {
      known.emplace_back(about.name);
      if (about.name == parameter) {
        s.law.parameters[parameter] = allowed(about, value);
        return;
      }
    }
    throw unknown_name("parameter of " + s.law.name, parameter, known);
  });
}
plumb_status plumb_set_plane_stress(plumb_solution* solution, int yes) {
  return change(solution, [&](plumb_solution& s) {
    if (s.dimension != 2)
      throw InputError("plane stress in " + std::to_string(s.dimension) + "D", "it is for bodies in 2D", "");
    s.law.plane = yes != 0 ? Plane::stress : Plane::strain;
  });
}
plumb_status plumb_set_increments(plumb_solution* solution, int increments) {
  return change(solution, [&](plumb_solution& s) {
    if (increments < 1) throw InputError("no increments", "a path has at least one", "");
    s.increments = increments;
  });
}

int plumb_dimension(const plumb_solution* solution) {
  return solution != nullptr ? solution->dimension : 0;
}
plumb_status plumb_period(const plumb_solution* solution, double* seconds) {
  return guarded([&] {
    require(solution, "solution");
    require(seconds, "seconds");
    solution->with_fields([&](const auto& fields) { *seconds = fields.period; });
  });
}
plumb_status plumb_box(const plumb_solution* solution, double* origin, double* size) {
  return guarded([&] {
    require(solution, "solution");
    require(origin, "origin");
    require(size, "size");
    solution->with_fields([&]<int d>(const mms::ExactFields<d>& fields) {
      Eigen::Map<Vec<d>>(origin, d) = fields.domain.box.origin;
      Eigen::Map<Vec<d>>(size, d) = fields.domain.box.size;
    });
  });
}
plumb_status plumb_contains(const plumb_solution* solution, size_t points, const double* X, int* inside) {
  return guarded([&] {
    require(solution, "solution");
    require(inside, "inside");
    require_points(X, points * static_cast<std::size_t>(solution->dimension));
    solution->with_fields([&]<int d>(const mms::ExactFields<d>& fields) {
      for (std::size_t k = 0; k < points; ++k) inside[k] = fields.domain.contains(point_at<d>(X, k)) ? 1 : 0;
    });
  });
}

size_t plumb_components(const plumb_solution* solution, plumb_quantity quantity) {
  if (solution == nullptr || quantity < PLUMB_DISPLACEMENT || quantity > PLUMB_STATIC_LOAD) return 0;
  const auto d = static_cast<std::size_t>(solution->dimension);
  return quantity == PLUMB_F || quantity == PLUMB_P || quantity == PLUMB_CAUCHY ? d * d : d;
}
plumb_status plumb_evaluate(const plumb_solution* solution, plumb_quantity quantity, size_t points,
                            const double* X, double time, double* values) {
  return guarded([&] {
    require(solution, "solution");
    require(values, "values");
    const std::vector<double> all = values_of(*solution, quantity, points, X, time);
    std::copy(all.begin(), all.end(), values);
  });
}
plumb_status plumb_traction(const plumb_solution* solution, size_t points, const double* X, const double* N,
                            double time, double* values) {
  return guarded([&] {
    require(solution, "solution");
    require(values, "values");
    require_points(X, points * static_cast<std::size_t>(solution->dimension));
    require_points(N, points * static_cast<std::size_t>(solution->dimension));
    require_finite(time, "time");
    std::vector<double> all;
    solution->with_fields([&]<int d>(const mms::ExactFields<d>& fields) {
      for (std::size_t k = 0; k < points; ++k) {
        const Vec<d> normal = point_at<d>(N, k);
        if (std::abs(normal.norm() - 1) > 1e-6)  // normals of single precision are units to 1e-7
          throw InputError("a normal has the length " + std::to_string(normal.norm()), "it must be 1", "");
        put(Vec<d>(fields.first_piola(point_at<d>(X, k), time) * normal), all);
      }
    });
    require_all_finite(all);
    std::copy(all.begin(), all.end(), values);
  });
}
}
