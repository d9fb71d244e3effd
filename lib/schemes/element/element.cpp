#include "lib/schemes/element/element.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "lib/schemes/blocks.hpp"
#include "lib/schemes/implicit/body_motion.hpp"
#include "lib/schemes/tensors.hpp"

namespace plumb {
namespace {

/// Quadratic elements share a traction out as Simpson's rule does, by its values at the nodes with weights of
/// 1 to 4 to 1, where tributary areas are as 1 to 2 to 1.
template <int d>
Actions<d> with_areas_of_elements(Actions<d> actions, const Cloud<d>& cloud, int degree) {
  if (degree == 1) return actions;
  for (SurfaceLoad<d>& load : actions.surface)
    for (LoadedPlace<d>& place : load.places) {
      place.at = cloud.X[place.particle];
      Index normal = 0;
      place.area.cwiseAbs().maxCoeff(&normal);
      for (int k = 0; k < d; ++k)
        if (k != normal)
          place.area *= place.particle / cloud.stride[k] % cloud.count[k] % 2 == 1 ? 4.0 / 3 : 2.0 / 3;
    }
  return actions;
}

/// Nodes that share a cell.
template <int d>
NeighbourCounts count_neighbours(const ElementBody<d>& body) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t n = 0; n < body.mesh.node.size(); ++n)
    entries.emplace_back(static_cast<Index>(n) / body.mesh.nodes, body.mesh.node[n], 1);
  SparseMatrix cells(body.mesh.cells(), body.cloud.size());
  cells.setFromTriplets(entries.begin(), entries.end());
  const SparseMatrix shared = cells.transpose() * cells;
  NeighbourCounts counts{shared.nonZeros() - body.cloud.size(), 0};
  for (Index i = 0; i < shared.cols(); ++i)
    counts.most = std::max<Index>(counts.most, shared.col(i).nonZeros() - 1);
  return counts;
}

/// u -> F - I at every point.
template <int d>
PlaceGradients<d> gradients_at_points(const ElementBody<d>& body) {
  PlaceGradients<d> G(body.cloud.size(), false);
  G.reserve(body.points(), body.slopes.nonZeros() / d);
  std::vector<PlaceShare<d>> place;
  for (Index q = 0; q < body.points(); ++q) {
    place.clear();
    for (typename ElementBody<d>::Rows::InnerIterator it(body.slopes, d * q); it; ++it)
      place.push_back({it.col(), Mat<d>::Zero()});
    for (int b = 0; b < d; ++b) {
      std::size_t n = 0;
      for (typename ElementBody<d>::Rows::InnerIterator it(body.slopes, d * q + b); it; ++it)
        place[n++].slope.col(b).setConstant(it.value());
    }
    G.add(place);
  }
  return G;
}

template <int d>
Eigen::VectorXd identities(Index places) {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(d * d * places);
  for (Index n = 0; n < places; ++n)
    for (int k = 0; k < d; ++k) all[d * d * n + k * (d + 1)] = 1;
  return all;
}

}  // namespace

template <int d>
Element<d>::Element(Specimen<d> specimen, ElementOptions options, Actions<d> actions, double damping)
    : options_(std::move(options)),
      body_(make_element_body(std::move(specimen), options_)),
      actions_(with_areas_of_elements(std::move(actions), body_.cloud, options_.degree())),
      outside_(actions_, body_.cloud, layout(), {body_.elastic.density, damping}),
      neighbours_(count_neighbours(body_)),
      omega_(body_.highest_frequency()),
      rate_(nodal(d)),
      seen_u_(nodal(d)) {}

template <int d>
ElementState Element<d>::start(const InitialMotion<d>& motion) const {
  State state{nodal(d), nodal(d)};
  for (std::size_t i = 0; i < motion.u.size(); ++i)
    set_vector<d>(state.u, static_cast<Index>(i), motion.u[i]);
  for (std::size_t i = 0; i < motion.v.size(); ++i)
    set_vector<d>(state.v, static_cast<Index>(i), motion.v[i]);
  outside_.start(state.u, state.v);
  return state;
}

template <int d>
std::optional<Trouble> Element<d>::evaluate(const Field& u, double time) {
  const Index count = body_.cloud.size();
  if (seen_time_ == time && same_values(u, seen_u_, count)) return std::nullopt;
  seen_time_.reset();
  State state{u, u};
  const Eigen::VectorXd all = motion_of<d>(layout(), state).u;
  F_ = body_.gradients(all);
  if (auto trouble = body_.trouble(F_)) return trouble;
  const Eigen::VectorXd force = body_.residual(all, F_);
  const double per_mass = 1 / body_.elastic.density;
  for (Index i = 0; i < count; ++i)
    for (int k = 0; k < d; ++k) rate_[k][i] = -per_mass / body_.cloud.V[i] * force[d * i + k];
  const Field F = outside_.needs_F() ? body_.nodal_gradients(F_) : Field();
  outside_.add_loads(time, &F, rate_);
  seen_u_ = u;
  seen_time_ = time;
  return std::nullopt;
}

template <int d>
double Element<d>::step_limit(const State& state) {
  const double limit = options_.cfl * 2 / omega_;
  if (evaluate(state.u, state.time)) return limit;  // advance() will say what is wrong
  double least = 1;
#pragma omp parallel for schedule(static) reduction(min : least)
  for (Index q = 0; q < body_.points(); ++q) {
    Mat<d> F;
    for (int m = 0; m < d * d; ++m) F(m / d, m % d) = F_[m][q];
    least = std::min(least, least_stretch<d, double>(F));
  }
  return limit * least;
}

template <int d>
std::optional<Trouble> Element<d>::advance(State& state, double dt) {
  if (auto trouble = evaluate(state.u, state.time)) return trouble;
  const State before = state;
  const Index count = body_.cloud.size();
  Field moved = nodal(d);
  const auto add = [&](double factor, const Field& from, Field& to) {
    for (int k = 0; k < d; ++k)
      for (Index i = 0; i < count; ++i) to[k][i] += factor * from[k][i];
  };
  const auto kick = [&](double time) {
    Field rate = rate_;
    outside_.hold(time, dt / 2, state.v, rate, moved);
    add(dt / 2, rate, state.v);
  };
  outside_.begin_step(dt, state.v, state.outside);
  kick(state.time);
  add(dt, state.v, state.u);
  outside_.impose(state.time + dt, state.u, state.v);
  if (auto trouble = evaluate(state.u, state.time + dt)) {
    state = before;
    return trouble;
  }
  if (body_.memory) {
    body_.commit(F_);
    seen_time_.reset();  // what the law says of the same F may differ in the last bit
  }
  kick(state.time + dt);
  outside_.end_step(state.time + dt, dt, state.u, state.v, state.outside);
  state.time += dt;
  ++state.step;
  return std::nullopt;
}

template <int d>
std::optional<OpenAcceleration> Element<d>::open(const State& state, bool /*still*/) {
  if (evaluate(state.u, state.time)) return std::nullopt;
  return OpenAcceleration{rate_, outside_.loads()};
}

/// F and P at the nodes: P of an elastic law is that of F there, that of a law with history the mean of the points around.
template <int d>
std::vector<WholePoint> nodal_points(const ElementBody<d>& body, const Field& at_points) {
  const Field F = body.nodal_gradients(at_points);
  const MixedState<d> nothing;
  std::vector<WholePoint> nodes(static_cast<std::size_t>(body.cloud.size()),
                                {Mat<3>::Zero(), Mat<3>::Zero()});
  for (Index i = 0; i < body.cloud.size(); ++i) {
    WholePoint& node = nodes[static_cast<std::size_t>(i)];
    if (!body.memory) {
      node = body.law.whole(nothing, F, i);
      continue;
    }
    for (typename ElementBody<d>::Rows::InnerIterator it(body.mean, i); it; ++it) {
      const WholePoint point = body.law.whole(*body.memory, at_points, it.col());
      node.F += it.value() * point.F;
      node.P += it.value() * point.P;
    }
  }
  return nodes;
}

/// The numbers of a law's history at the nodes, as means of the points around them.
template <int d>
std::vector<NamedValues> nodal_history(const ElementBody<d>& body) {
  std::vector<NamedValues> all;
  if (!body.memory) return all;
  const Index points = body.points();
  for (const HistoryValue& value : body.law.history) {
    if (value.tensor) continue;
    const Eigen::VectorXd at_nodes =
        body.mean * Eigen::Map<const Eigen::VectorXd>(body.memory->history[value.first], points);
    all.push_back({value.name, value.unit, {at_nodes.begin(), at_nodes.end()}});
  }
  return all;
}

template <int d>
Snapshot<d> Element<d>::snapshot(const State& state) const {
  const auto nodes = nodal_points(body_, body_.gradients(motion_of<d>(layout(), state).u));
  const Cloud<d>& cloud = body_.cloud;
  Snapshot<d> shown;
  shown.time = state.time;
  shown.step = state.step;
  shown.X = cloud.X;
  for (Index i = 0; i < cloud.size(); ++i) {
    const WholePoint& point = nodes[static_cast<std::size_t>(i)];
    const double J = point.F.determinant();
    shown.u.push_back(vector_at<d>(state.u, i));
    shown.x.push_back(cloud.X[i] + shown.u.back());
    shown.v.push_back(vector_at<d>(state.v, i));
    shown.mass.push_back(body_.elastic.density * cloud.V[i]);
    shown.volume.push_back(J * cloud.V[i]);
    shown.F.push_back(point.F);
    shown.cauchy.push_back(point.P * point.F.transpose() / J);
  }
  shown.more = nodal_history(body_);
  return shown;
}

template <int d>
Energy Element<d>::energy(const State& state) const {
  const BodyMotion motion = motion_of<d>(layout(), state);
  Energy energy;
  for (Index i = 0; i < body_.cloud.size(); ++i)
    energy.kinetic += 0.5 * body_.elastic.density * body_.cloud.V[i] * vector_at<d>(state.v, i).squaredNorm();
  energy.strain = body_.strain_energy(body_.gradients(motion.u));
  if (body_.hourglass_modulus > 0) energy.more.push_back({"hourglass", body_.hourglass_energy(motion.u)});
  if (body_.law.plastic_work)
    energy.more.push_back(
        {"plastic work", Eigen::Map<const Eigen::VectorXd>(body_.mesh.weight.data(), body_.points())
                             .dot(Eigen::Map<const Eigen::VectorXd>(
                                 body_.memory->history[*body_.law.plastic_work], body_.points()))});
  return energy;
}

template <int d>
std::vector<Statement> Element<d>::account() const {
  const ElementMesh<d>& mesh = body_.mesh;
  std::vector<Statement> said;
  said.push_back({"scheme", options_.in_words(), "THEORY (15.7)"});
  said.push_back({"cells",
                  fmt::format("{} of {} nodes, the law is asked at {} point{} of each", mesh.cells(),
                              mesh.nodes, mesh.points, mesh.points == 1 ? "" : "s"),
                  "THEORY (15.7)"});
  if (body_.hourglass_modulus > 0)
    said.push_back(
        {"hourglass",
         fmt::format("what a cell's F does not explain costs energy, alpha = {:g}", options_.alpha),
         "THEORY (15.8)"});
  return said;
}

template <int d>
StoredEnergy<d> Element<d>::stored_energy() const {
  struct Asked {
    ElementBody<d> body;
    std::optional<Trouble> trouble;
  };
  const auto asked = std::make_shared<Asked>(Asked{body_, {}});
  StoredEnergy<d> made;
  EnergyOperators<d> operators{
      identities<d>(body_.points()), gradients_at_points(body_),
      Eigen::Map<const Eigen::VectorXd>(body_.mesh.weight.data(), body_.points()),
      SparseMatrix(SparseMatrix(body_.springs).template triangularView<Eigen::Lower>())};
  if (outside_.needs_F())
    made.at_particles = {identities<d>(body_.cloud.size()),
                         per_component(SparseMatrix(body_.mean), d * d) * operators.gradient.matrix()};
  made.operators = std::make_shared<const EnergyOperators<d>>(std::move(operators));
  made.cloud = body_.cloud;
  made.elastic = body_.elastic;
  made.slots = layout();
  made.energy = [asked](const Eigen::VectorXd& u) {
    return asked->body.potential(asked->body.gradients(u)) + asked->body.hourglass_energy(u);
  };
  made.residual = [asked](const Eigen::VectorXd& u) -> std::optional<Eigen::VectorXd> {
    const Field F = asked->body.gradients(u);
    asked->trouble = asked->body.trouble(F);
    if (asked->trouble) return std::nullopt;
    return asked->body.residual(u, F);
  };
  made.tangent = [asked](const Mat<d>& F, Index point) { return asked->body.tangent_at(F, point); };
  if (body_.memory)
    made.commit = [asked](const Eigen::VectorXd& u) { asked->body.commit(asked->body.gradients(u)); };
  made.trouble = [asked] { return asked->trouble; };
  double volume = 0;
  for (const double V : body_.cloud.V) volume += V;
  constexpr double roundings = 24, unit = 1.1e-16;  // THEORY (8.9)
  made.round_off = roundings * unit * 1.5 * made.elastic.shear_modulus() * volume;
  return made;
}

template class Element<1>;
template class Element<2>;
template class Element<3>;

}  // namespace plumb
