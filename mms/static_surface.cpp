#include "mms/static_surface.hpp"

#include <set>

#include "lib/geometry/facets.hpp"
#include "mms/level.hpp"

namespace plumb::mms {
namespace {

/// Sides on which a particle lies: face 2 k is the lower one of axis k.
template <int d, class Use>
void for_faces_at(const Box<d>& box, const Vec<d>& X, Use&& use) {
  for (int k = 0; k < d; ++k) {
    const double below = X[k] - box.origin[k], above = box.size[k] - below, slack = 1e-9 * box.size[k];
    if (below < slack) use(k, 2 * k);
    if (above < slack) use(k, 2 * k + 1);
  }
}

/// A piece of the surface as a part of the solution's boundary: what is known there, and where.
template <int d>
struct Piece {
  Index owner;
  FaceCondition condition;
  Vec<d> at, normal;  ///< on the boundary itself; outward
  double area;
};

/// Pieces of a polygon around an annulus belong to the nearest points of its circles.
template <int d>
Piece<d> piece_of(const Facet<d>& facet, const Domain<d>& domain) {
  Piece<d> piece{facet.owner, {}, facet.centroid, facet.area.normalized(), facet.area.norm()};
  if (domain.shape == Domain<d>::Shape::annulus) {
    const bool outer = 2 * facet.centroid.norm() > domain.inner + domain.outer;
    const Vec<d> outwards = facet.centroid.normalized();
    piece.at = (outer ? domain.outer : domain.inner) * outwards;
    piece.normal = outer ? outwards : Vec<d>(-outwards);
    piece.condition = domain.faces[outer ? 1 : 0];
    return piece;
  }
  Index axis = 0;
  facet.area.cwiseAbs().maxCoeff(&axis);
  piece.condition = domain.faces[static_cast<std::size_t>(2 * axis + (facet.area[axis] > 0 ? 1 : 0))];
  return piece;
}

/// Whether the traction of the solution acts there. Solutions that move are followed with exact displacements
/// on the whole surface.
template <int d>
bool is_pulled(const FaceCondition& condition, const Manufactured<d>& solution) {
  return solution.still && condition.normal == Known::traction && condition.tangential == Known::traction;
}

/// Conditions of a solution at rest: its own, on the faces of a box or on two circles.
template <int d>
std::vector<char> displaced_at_rest(const Study& study, const Manufactured<d>& solution,
                                    const Cloud<d>& cloud, double time, Eigen::VectorXd& load) {
  const Domain<d>& domain = solution.domain;
  std::vector<char> displaced(static_cast<std::size_t>(cloud.size()), 0);
  if (domain.shape == Domain<d>::Shape::box)
    for (Index i = 0; i < cloud.size(); ++i)
      for_faces_at(cloud.box, cloud.X[i], [&](int, int face) {
        if (!is_pulled(domain.faces[static_cast<std::size_t>(face)], solution))
          displaced[static_cast<std::size_t>(i)] = 1;
      });
  for (const Facet<d>& facet : surface_of<d>(study, solution, cloud).facets) {
    const Piece<d> piece = piece_of<d>(facet, domain);
    if (is_pulled(piece.condition, solution))
      load.template segment<d>(d * piece.owner) +=
          piece.area * solution.traction(piece.at, time, piece.normal);
    else
      displaced[static_cast<std::size_t>(piece.owner)] = 1;
  }
  return displaced;
}

}  // namespace

template <int d>
std::vector<Prescribed> surface_conditions(const Study& study, const Manufactured<d>& solution,
                                           const Solid<d>& solid, double time, const Eigen::VectorXd& u,
                                           Eigen::VectorXd& load) {
  const Cloud<d>& cloud = solid.cloud;
  std::vector<char> displaced(static_cast<std::size_t>(cloud.size()), 0);
  if (solution.still) {
    displaced = displaced_at_rest<d>(study, solution, cloud, time, load);
  } else {
    const CurvedSurface<d> surface = whole_surface<d>(study, solution, solid);
    for (const Index i : surface.displaced) displaced[static_cast<std::size_t>(i)] = 1;
    for (const LoadedPlace<d>& place : surface.pulled)
      load.template segment<d>(d * place.particle) +=
          place.size() * solution.traction(place.at, time, place.normal());
  }
  std::vector<Prescribed> prescribed;
  for (Index i = 0; i < cloud.size(); ++i)
    for (int k = 0; displaced[static_cast<std::size_t>(i)] && k < d; ++k)
      prescribed.push_back({d * i + k, u[d * i + k]});
  return prescribed;
}

template <int d>
CurvedSurface<d> whole_surface(const Study& study, const Manufactured<d>& solution, const Solid<d>& solid) {
  const Cloud<d>& cloud = solid.cloud;
  CurvedSurface<d> surface;
  std::set<Index> follows;
  if (has_curved_surface(study)) {
    surface = curved_surface<d>(study, solution, solid);
    if (study.body.shape != "box" && surface.displaced.empty()) hold_half(cloud, surface);
  } else if (solution.domain.shape != Domain<d>::Shape::box) {
    for (const Facet<d>& facet : surface_of<d>(study, solution, cloud).facets) follows.insert(facet.owner);
  }
  if (solution.domain.shape == Domain<d>::Shape::box && study.body.shape == "box")
    for (Index i = 0; i < cloud.size(); ++i)
      for_faces_at(cloud.box, cloud.X[i], [&](int, int) { follows.insert(i); });
  follows.insert(surface.displaced.begin(), surface.displaced.end());
  surface.displaced.assign(follows.begin(), follows.end());
  std::erase_if(surface.pulled,
                [&](const LoadedPlace<d>& place) { return follows.contains(place.particle); });
  return surface;
}

template <int d>
std::vector<Index> held_unknowns(const Cloud<d>& cloud, const Domain<d>& domain) {
  std::vector<Index> still;
  for (Index i = 0; i < cloud.size(); ++i)
    for_faces_at(cloud.box, cloud.X[i], [&](int axis, int face) {
      for (int k = 0; k < d; ++k) {
        const FaceCondition& condition = domain.faces[static_cast<std::size_t>(face)];
        if ((k == axis ? condition.normal : condition.tangential) == Known::displacement)
          still.push_back(d * i + k);
      }
    });
  return still;
}

#define PLUMBLINE_INSTANTIATE(d)                                                                          \
  template std::vector<Prescribed> surface_conditions<d>(const Study&, const Manufactured<d>&,            \
                                                         const Solid<d>&, double, const Eigen::VectorXd&, \
                                                         Eigen::VectorXd&);                               \
  template CurvedSurface<d> whole_surface<d>(const Study&, const Manufactured<d>&, const Solid<d>&);      \
  template std::vector<Index> held_unknowns<d>(const Cloud<d>&, const Domain<d>&);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb::mms
