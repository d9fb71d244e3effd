#include "mms/operators.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lib/convergence/status.hpp"
#include "lib/core/dimension.hpp"
#include "lib/schemes/tlsph/bonds/each_bond.hpp"
#include "lib/schemes/tlsph/compatible/boundary_vectors.hpp"
#include "lib/schemes/tlsph/loops/evaluate.hpp"
#include "lib/schemes/tlsph/measures/solid_measures.hpp"
#include "mms/level.hpp"

namespace plumb::mms {
namespace {

enum Operator { gradient, divergence, laplacian };
enum Part { inside, boundary };

/// The share of the body's least extent that is counted as boundary at most.
constexpr double rim = 0.25;

/// Force per unit volume at every particle.
template <int d>
std::vector<Vec<d>> forces(const Solid<d>& solid, State<d>& state) {
  std::vector<Vec<d>> by_slot(static_cast<std::size_t>(solid.bonds.slots.count()), Vec<d>::Zero()), f;
  Workspace<d> workspace;
  const Outcome outcome =
      evaluate(solid, workspace, state, 0.0, [&](const Block& block, BlockForce<d>& force) {
        for (Index i = block.begin(); i < block.end(); ++i)
          for (int k = 0; k < d; ++k) by_slot[static_cast<std::size_t>(i)][k] = force(k, i);
      });
  if (!outcome)
    throw InputError("the estimate of F turns a particle inside out",
                     "the exact field is too steep for this spacing", "Use finer spacings.");
  for (Index i = 0; i < solid.cloud.size(); ++i)
    f.push_back(by_slot[static_cast<std::size_t>(solid.bonds.slots.of(i))]);
  return f;
}

/// sum_j V_j w_ij (u_j - u_i), THEORY (6.3).
template <int d>
Vec<d> laplacian_at(const Solid<d>& solid, const State<d>& state, Index particle) {
  const BondTable<d>& t = solid.bonds;
  const Index i = t.slots.of(particle);
  Vec<d> sum = Vec<d>::Zero();
  for_each_bond(t, i, [&](const BondEntry<d>& bond, const Vec<d>&) {
    sum += bond.value(t.laplacian) * (vector_at<d>(state.u, bond.other) - vector_at<d>(state.u, i));
  });
  return sum;
}

template <int d>
Vec<d> exact_laplacian(const Motion<d>& motion) {
  Vec<d> sum = Vec<d>::Zero();
  for (int B = 0; B < d; ++B) sum += motion.dF[static_cast<std::size_t>(B)].col(B);
  return sum;
}

/// The study's body at rest, with the weights of the Laplacian and no dissipation made of them.
template <int d>
TlsphBody<d> operator_body_of(Study study, const Manufactured<d>& solution, double spacing) {
  if (!study.method.jst) study.method.jst = JstOptions{};
  study.method.jst->eta2 = study.method.jst->eta4 = 0;
  return driven_simulation<d>(study, solution, spacing);
}

/// Outward boundary area over volume, B_i/V_i [1/m]: a stress P leaves the force -P B_i/V_i of the surface.
template <int d>
std::vector<Vec<d>> areas_per_volume(const Study& study, const Manufactured<d>& solution,
                                     const Solid<d>& solid) {
  auto areas = boundary_vectors<d>(solid.cloud, kernel_named<d>(study.method.kernel), solid.smoothing_length,
                                   surface_of<d>(study, solution, solid.cloud))
                   .B;
  for (Index i = 0; i < solid.cloud.size(); ++i) areas[static_cast<std::size_t>(i)] /= solid.cloud.V[i];
  return areas;
}

template <int d>
void measure_errors(Solid<d>& solid, State<d>& state, const Manufactured<d>& solution, double time,
                    double reach, const std::vector<Vec<d>>& area, OperatorLevel& level) {
  for (Index i = 0; i < solid.cloud.size(); ++i)
    set_vector<d>(state.u, solid.bonds.slots.of(i), solution.displacement(solid.cloud.X[i], time));
  const auto force = forces<d>(solid, state);
  std::array<std::array<double, 2>, 3> error{};
  std::array<double, 3> size{};
  std::array<double, 2> volume{};
  double whole = 0;
  for (Index i = 0; i < solid.cloud.size(); ++i) {
    const double V = solid.cloud.V[i], depth = solution.domain.depth(solid.cloud.X[i]);
    const Motion<d> motion = solution.motion(solid.cloud.X[i], time);
    const Vec<d> div = solution.stress_divergence(motion), lap = exact_laplacian<d>(motion);
    whole += V;
    size[gradient] += V * (motion.F - Mat<d>::Identity()).squaredNorm();
    size[divergence] += V * div.squaredNorm();
    size[laplacian] += V * lap.squaredNorm();
    if (depth > reach && depth < rim * solution.domain.length()) continue;
    const Part part = depth > reach ? inside : boundary;
    // a weight that grows smoothly from the rim of the inside: counted fully, the particles on the rim would
    // make it wider by a share of d, and orders with it
    const double w = part == boundary ? V : V * std::pow(depth / solution.domain.length() - rim, 2);
    volume[part] += w;
    error[gradient][part] += w * (deformation_gradient_of(solid, state, i) - motion.F).squaredNorm();
    const Vec<d> traction = -solution.first_piola(motion.F) * area[static_cast<std::size_t>(i)];
    error[divergence][part] += w * (force[static_cast<std::size_t>(i)] - div - traction).squaredNorm();
    error[laplacian][part] += w * (laplacian_at<d>(solid, state, i) - lap).squaredNorm();
  }
  for (int k = 0; k < 3; ++k)
    for (int part = 0; part < 2; ++part)
      level.error[k][part] = std::sqrt(error[k][part] / volume[part] / (size[k] / whole));
}

/// The force that a uniform stress leaves: a last term overwrites the material's stress by I.
template <int d>
double constraint_defect(Solid<d>& solid, State<d>& state, const Domain<d>& domain) {
  Term<d> uniform;
  uniform.name = "uniform stress";
  uniform.stress = [](const Solid<d>&, const Block& block, const Instant<d>&, StressWindow& P) {
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b)
        std::fill_n(P[a * d + b] + P.place(block.begin()), block.end() - block.begin(), a == b ? 1.0 : 0.0);
  };
  add_term(solid, uniform);
  const auto force = forces<d>(solid, state);
  double sum = 0;
  Index count = 0;
  for (Index i = 0; i < solid.cloud.size(); ++i)
    if (domain.depth(solid.cloud.X[i]) >= rim * domain.length())
      sum += force[static_cast<std::size_t>(i)].squaredNorm(), ++count;
  return std::sqrt(sum / static_cast<double>(count)) * solid.cloud.spacing;
}

template <int d>
OperatorLevel level_of(const Study& study, const Manufactured<d>& solution, double spacing) {
  TlsphBody<d> simulation = operator_body_of<d>(study, solution, spacing);
  Solid<d>& solid = simulation.solid;
  const double support = kernel_named<d>(study.method.kernel).support * solid.smoothing_length;
  if (2 * support > rim * solution.domain.length())
    throw InputError(fmt::format("a spacing of {:g} m leaves no inside", spacing),
                     fmt::format("two support radii are {:g} m, a quarter of the body {:g} m", 2 * support,
                                 rim * solution.domain.length()),
                     "Use finer spacings.");
  OperatorLevel level;
  level.n = solid.cloud.size();
  level.spacing = spacing;
  measure_errors<d>(solid, simulation.state, solution, end_time(study), 2 * support,
                    areas_per_volume<d>(study, solution, solid), level);
  level.constraint = constraint_defect<d>(solid, simulation.state, solution.domain);
  return level;
}

OperatorFit fit_of(std::string_view name, std::string_view part, const std::vector<OperatorLevel>& levels,
                   const std::function<double(const OperatorLevel&)>& value) {
  OperatorFit out{std::string(name), std::string(part), {}, {}};
  std::vector<Level> errors;
  errors.reserve(levels.size());
  for (const OperatorLevel& level : levels) errors.push_back({level.spacing, value(level)});
  out.fit = fit_order(errors);
  out.verdict = name_of(classify(out.fit));
  return out;
}

template <int d>
OperatorResult run_operators_in(const Study& study, const StudyProgress& progress) {
  const Manufactured<d> solution = solution_of<d>(study);
  OperatorResult result;
  double work = 0, done = 0;  // in particles
  for (const double spacing : study.spacings) work += std::pow(spacing, -d);
  for (const double spacing : study.spacings) {
    result.levels.push_back(level_of<d>(study, solution, spacing));
    done += std::pow(spacing, -d);
    if (progress) progress(done / work, fmt::format("d = {:g} m", spacing));
  }
  for (std::size_t k = 0; k < operator_names.size(); ++k)
    for (std::size_t part = 0; part < part_names.size(); ++part)
      result.fits.push_back(fit_of(operator_names[k], part_names[part], result.levels,
                                   [=](const OperatorLevel& level) { return level.error[k][part]; }));
  result.fits.push_back(fit_of("constraint", part_names[inside], result.levels,
                               [](const OperatorLevel& level) { return level.constraint; }));
  std::vector<Judged> judged;
  for (const OperatorFit& fit : result.fits)
    if (fit.part == part_names[inside]) judged.push_back({fit.verdict, false});
  result.status = plumb::status_of(judged);
  return result;
}

}  // namespace

OperatorResult run_operators(const Study& study, const StudyProgress& progress) {
  return with_dimension(study.dimension(), [&]<int d>() { return run_operators_in<d>(study, progress); });
}

}  // namespace plumb::mms
