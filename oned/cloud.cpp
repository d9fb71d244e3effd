#include "oned/cloud.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "lib/core/error.hpp"

namespace plumb::oned {
namespace {

void require_positive(double x, std::string_view what, std::string_view suggestion) {
  if (!(x > 0) || !std::isfinite(x))
    throw InputError(fmt::format("{} is {}", what, x), "it must be positive and finite",
                     std::string(suggestion));
}

void check(const Discretisation& d) {
  require_positive(d.length, "the length L", "Give --length in metres.");
  if (d.n < 2)
    throw InputError(fmt::format("n is {}", d.n), "a gradient needs at least 2 cells",
                     "Give --n 40, for example.");
  if (d.n > 100'000'000)
    throw InputError(fmt::format("n is {}", d.n), "the largest is 100000000", "Use fewer cells.");
  if (!(d.jitter >= 0 && d.jitter < 0.5))
    throw InputError(fmt::format("jitter is {}", d.jitter), "particles would change places",
                     "Give a fraction of dx in [0, 0.5).");
  require_positive(d.radius.value, d.radius.fixed ? "the support radius" : "the radius over dx",
                   "Give --radius-over-dx 4, for example.");
}

Box<1> body(double length) {
  return {Vec<1>(0.0), Vec<1>(length)};
}

}  // namespace

Layout layout_named(std::string_view name) {
  if (name == "cell") return Layout::cell;
  if (name == "node") return Layout::node;
  throw unknown_name("layout", name, {"cell", "node"});
}

Cloud<1> make_cloud(const Discretisation& d) {
  check(d);
  Cloud<1> cloud = lattice<1>(body(d.length), {d.n}, d.layout);
  if (d.jitter > 0) cloud = jittered<1>(std::move(cloud), d.jitter, d.seed, d.layout);
  return cloud;
}

Cloud<1> voronoi_cloud(double length, const std::vector<double>& positions) {
  require_positive(length, "the length L", "");
  if (positions.size() < 2)
    throw InputError(fmt::format("the cloud has {} particles", positions.size()), "a gradient needs 2", "");
  std::vector<std::size_t> order(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    order[i] = i;
    if (!(positions[i] >= 0 && positions[i] <= length))
      throw InputError(fmt::format("particle {} is at X = {} m", i, positions[i]),
                       fmt::format("the body is [0, {}] m", length), "");
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return positions[a] < positions[b]; });
  Cloud<1> cloud;
  cloud.spacing = length / static_cast<double>(positions.size());
  cloud.box = body(length);
  for (std::size_t k = 0; k < order.size(); ++k) {
    const double X = positions[order[k]];
    if (k > 0 &&
        X - cloud.X.back()[0] < 1e-8 * cloud.spacing)  // the bond quotient would keep half its digits
      throw InputError(fmt::format("particles {} and {} coincide at X = {:.9g} m",
                                   std::min(order[k - 1], order[k]), std::max(order[k - 1], order[k]), X),
                       "the slope between them is lost in rounding", "Remove one of the two.");
    cloud.X.emplace_back(X);
  }
  cloud.V = voronoi_volumes<1>(cloud.X, cloud.box);
  return cloud;
}

double inner_radius(double R) {
  return R * (1 - 1e-12);
}

Window window_at(const Cloud<1>& cloud, double R, double x) {
  const double reach = inner_radius(R);
  const auto& X = cloud.X;
  const auto first =
      std::partition_point(X.begin(), X.end(), [&](const Vec<1>& y) { return x - y[0] >= reach; });
  const auto last = std::partition_point(first, X.end(), [&](const Vec<1>& y) { return y[0] - x < reach; });
  return {first - X.begin(), last - X.begin()};
}

Window support_of(const Cloud<1>& cloud, double R, double length, double x) {
  if (!(x >= 0 && x <= length))
    throw InputError(fmt::format("the evaluation point x = {} lies outside the body", x),
                     fmt::format("the body is [0, {}]", length), "Give --at inside it.");
  const Window window = window_at(cloud, R, x);
  if (window.count() < 2)
    throw InputError(fmt::format("the point x = {:.6g} m has {} particles in its support", x, window.count()),
                     fmt::format("R = {:.6g} m, spacing {:.6g} m; a gradient needs 2", R, cloud.spacing),
                     "Increase --radius or --radius-over-dx.");
  return window;
}

std::vector<Window> windows(const Cloud<1>& cloud, double R) {
  const double reach = inner_radius(R);
  const auto& X = cloud.X;
  const auto count = static_cast<Index>(X.size());
  std::vector<Window> all(X.size());
  Index first = 0, last = 0;
  for (Index i = 0; i < count; ++i) {
    while (X[i][0] - X[first][0] >= reach) ++first;
    last = std::max(last, i);
    while (last < count && X[last][0] - X[i][0] < reach) ++last;
    all[i] = {first, last};
    if (all[i].count() < 2)
      throw InputError(
          fmt::format("particle {} at X = {:.6g} m has {} neighbours", i, X[i][0], all[i].count() - 1),
          fmt::format("the support radius R = {:.6g} m does not reach beyond the spacing {:.6g} m", R,
                      cloud.spacing),
          "Increase --radius or --radius-over-dx above 1.");
  }
  return all;
}

std::vector<std::string> warnings(const Discretisation& d, const std::vector<TestField>& fields) {
  std::vector<std::string> all;
  const double ratio = d.support() / d.dx();
  const double nearest = std::round(ratio);
  if (d.jitter == 0 && nearest == 1 && std::abs(ratio - nearest) < 1e-9)
    all.push_back(
        fmt::format("R/dx = {:.12g}: R is the spacing itself, rounding picks the neighbours", ratio));
  for (const TestField& field : fields)
    if (const auto* sine = std::get_if<Sine>(&field.form))
      if (std::abs(sine->wave_number) * d.dx() > std::numbers::pi)
        all.push_back(fmt::format("field \"{}\" is aliased at n = {}: k dx = {:.4g} > pi", field.text, d.n,
                                  std::abs(sine->wave_number) * d.dx()));
  return all;
}

}  // namespace plumb::oned
