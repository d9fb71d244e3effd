#include "reports/body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>

#include "lib/core/error.hpp"

namespace plumb::reports {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

/// A particle as seen: to the right, upwards, towards the reader [m].
struct Seen {
  double right = 0, up = 0, near = 0;
};

class Camera {
 public:
  Camera(const View& view, bool plane)
      : right_(axis(view.right)), up_(axis(view.up)), near_(axis(view.near)) {
    const bool right_handed = (right_ + 1) % 3 == up_;
    towards_ = right_handed ? 1 : -1;  // right x up points to the reader
    if (plane) return;
    const double degree = std::numbers::pi / 180;
    ca_ = std::cos(view.azimuth * degree), sa_ = std::sin(view.azimuth * degree);
    ce_ = std::cos(view.elevation * degree), se_ = std::sin(view.elevation * degree);
  }
  Seen operator()(const Point& x) const {
    const double near = towards_ * x[near_];
    const double a = ca_ * x[right_] + sa_ * near, b = ca_ * near - sa_ * x[right_];
    return {a, ce_ * x[up_] - se_ * b, se_ * x[up_] + ce_ * b};
  }

 private:
  static std::size_t axis(char name) { return static_cast<std::size_t>(name - 'x'); }
  std::size_t right_, up_, near_;
  double towards_ = 1, ca_ = 1, sa_ = 0, ce_ = 1, se_ = 0;
};

bool is_plane(const BodyState& state) {
  return std::all_of(state.reference.begin(), state.reference.end(),
                     [](const Point& x) { return x[2] == 0; });
}

/// The particles as a full box of n[0] x n[1] x n[2] places, in the reference; `at` is the particle of a
/// place.
struct Lattice {
  std::array<std::size_t, 3> n{1, 1, 1};
  std::vector<std::size_t> at;
  std::size_t operator()(const std::array<std::size_t, 3>& place) const {
    return at[(place[2] * n[1] + place[1]) * n[0] + place[0]];
  }
};

/// Different coordinates along one axis, to a millionth of the spacing.
std::vector<double> levels_of(const std::vector<Point>& points, std::size_t axis, double edge) {
  std::vector<double> all;
  all.reserve(points.size());
  for (const auto& x : points) all.push_back(x[axis]);
  std::sort(all.begin(), all.end());
  std::vector<double> levels;
  for (const double x : all)
    if (levels.empty() || x - levels.back() > 1e-6 * edge) levels.push_back(x);
  return levels;
}

std::optional<Lattice> lattice_of(const BodyState& state, double edge) {
  Lattice lattice;
  std::array<std::vector<double>, 3> levels;
  for (std::size_t k = 0; k < 3; ++k) {
    levels[k] = levels_of(state.reference, k, edge);
    lattice.n[k] = levels[k].size();
  }
  const std::size_t count = lattice.n[0] * lattice.n[1] * lattice.n[2];
  if (count != state.reference.size()) return std::nullopt;
  lattice.at.assign(count, count);
  for (std::size_t p = 0; p < count; ++p) {
    std::array<std::size_t, 3> place{};
    for (std::size_t k = 0; k < 3; ++k)
      place[k] = static_cast<std::size_t>(
          std::lower_bound(levels[k].begin(), levels[k].end(), state.reference[p][k] - 1e-6 * edge) -
          levels[k].begin());
    lattice.at[(place[2] * lattice.n[1] + place[1]) * lattice.n[0] + place[0]] = p;
  }
  if (std::find(lattice.at.begin(), lattice.at.end(), count) != lattice.at.end()) return std::nullopt;
  return lattice;
}

using Quad = std::array<std::size_t, 4>;  ///< particles, counter-clockwise as seen from outside

/// The places along an axis of n that are drawn: all of them, or about 60 of more.
std::vector<std::size_t> places(std::size_t n) {
  const std::size_t step = (n + 58) / 60;
  std::vector<std::size_t> drawn;
  for (std::size_t i = 0; i + 1 < n; i += step) drawn.push_back(i);
  drawn.push_back(n - 1);
  return drawn;
}

/// The quadrilaterals of one face of the box: axis `k` at its first or last level. A plane body has one face.
void add_face(const Lattice& lattice, std::size_t k, bool last, std::vector<Quad>& quads) {
  const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;  // e_a x e_b = e_k
  const auto along = places(lattice.n[a]), across = places(lattice.n[b]);
  std::array<std::size_t, 3> place{};
  place[k] = last ? lattice.n[k] - 1 : 0;
  const auto particle = [&](std::size_t i, std::size_t j) {
    place[a] = along[i];
    place[b] = across[j];
    return lattice(place);
  };
  for (std::size_t i = 0; i + 1 < along.size(); ++i)
    for (std::size_t j = 0; j + 1 < across.size(); ++j) {
      Quad quad{particle(i, j), particle(i + 1, j), particle(i + 1, j + 1), particle(i, j + 1)};
      if (!last) std::swap(quad[1], quad[3]);
      quads.push_back(quad);
    }
}

/// A quadrilateral ready to be drawn.
struct Drawn {
  std::array<Seen, 4> corners;
  double value = 0, near = 0;
};

std::vector<Drawn> surface(const BodyState& state, const Lattice& lattice, const Camera& camera) {
  std::vector<Quad> quads;
  const bool plane = is_plane(state);
  for (std::size_t k = plane ? 2 : 0; k < 3; ++k)
    for (const bool last : {false, true})
      if (!plane || last) add_face(lattice, k, last, quads);
  std::vector<Drawn> drawn;
  for (const auto& quad : quads) {
    Drawn d;
    for (std::size_t c = 0; c < 4; ++c) {
      d.corners[c] = camera(state.position[quad[c]]);
      d.value += state.value[quad[c]] / 4;
      d.near += d.corners[c].near / 4;
    }
    const auto &p = d.corners[0], &q = d.corners[1], &r = d.corners[2], &s = d.corners[3];
    const double area =
        (r.right - p.right) * (s.up - q.up) - (r.up - p.up) * (s.right - q.right);  // twice, by its diagonals
    if (area > 0) drawn.push_back(d);
  }
  return drawn;
}

std::vector<Drawn> particles(const BodyState& state, const Camera& camera, double edge) {
  std::vector<Drawn> drawn;
  for (std::size_t p = 0; p < state.position.size(); ++p) {
    const Seen s = camera(state.position[p]);
    const double h = 0.5 * edge;
    drawn.push_back({{{{s.right - h, s.up - h, s.near},
                       {s.right + h, s.up - h, s.near},
                       {s.right + h, s.up + h, s.near},
                       {s.right - h, s.up + h, s.near}}},
                     state.value[p],
                     s.near});
  }
  return drawn;
}

/// Three rods from one corner: the axes, each as long as a round part of the picture.
std::vector<Rod> axes_of(const Camera& camera, const View& view, bool plane, double left, double bottom,
                         double size) {
  const double decade = std::pow(10.0, std::floor(std::log10(size / 8)));
  const double length = decade * (size / 8 >= 5 * decade ? 5 : size / 8 >= 2 * decade ? 2 : 1);
  std::vector<Rod> rods;
  const Seen origin = camera({0, 0, 0});
  for (const char name : {view.right, view.up, view.near}) {
    if (plane && name == view.near) continue;
    Point tip{};
    tip[static_cast<std::size_t>(name - 'x')] = length;
    const Seen end = camera(tip);
    const std::string label =
        name == view.right ? fmt::format("{}, {:g} m", name, length) : std::string(1, name);
    rods.push_back({left, bottom, left + end.right - origin.right, bottom + end.up - origin.up, label});
  }
  return rods;
}

}  // namespace

Picture body_picture(const std::string& title, const BodyState& state, const View& view,
                     const ColourScale& quantity, double edge, const std::vector<BodyState>& extent) {
  if (state.position.empty())
    throw InputError("the body cannot be drawn", "it has no particles", "Look at the files of the run.");
  const bool plane = is_plane(state);
  const Camera camera(view, plane);
  const auto lattice = lattice_of(state, edge);
  auto drawn = lattice ? surface(state, *lattice, camera) : particles(state, camera, edge);
  std::stable_sort(drawn.begin(), drawn.end(), [](const auto& a, const auto& b) { return a.near < b.near; });
  Patches patches{{}, {}, {}, quantity.label, quantity.unit, quantity.low, quantity.high};
  for (const auto& d : drawn) {
    for (const auto& corner : d.corners) {
      patches.x.push_back(corner.right);
      patches.y.push_back(corner.up);
    }
    patches.z.push_back(quantity.scale * d.value);
  }
  double left = inf, right = -inf, bottom = inf, top = -inf;
  for (const auto& any : extent)
    for (const auto& x : any.position) {
      const Seen s = camera(x);
      left = std::min(left, s.right - edge), right = std::max(right, s.right + edge);
      bottom = std::min(bottom, s.up - edge), top = std::max(top, s.up + edge);
    }
  const double size = std::max(right - left, top - bottom);
  Picture picture{
      title, {"", "", Scale::linear, left, right}, {"", "", Scale::linear, bottom - 0.22 * size, top}};
  patches.rods = axes_of(camera, view, plane, left + 0.02 * size, bottom - 0.2 * size, size);
  picture.map = std::move(patches);
  picture.equal_axes = true;
  return picture;
}

}  // namespace plumb::reports
