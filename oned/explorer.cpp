#include "oned/explorer.hpp"

#include <fmt/format.h>

#include <array>

#include "oned/gradient.hpp"

namespace plumb::oned {
namespace {

/// The sums of (5a), (5b), (9a), (9b) for every kernel and gradient.
std::vector<std::pair<std::string, double>> sums(const std::vector<KernelRow>& rows,
                                                 const std::vector<Neighbour<1>>& seen) {
  struct Column {
    const char* name;
    double KernelRow::*member;
  };
  constexpr std::array<Column, 8> columns = {{{"W", &KernelRow::W},
                                              {"W0", &KernelRow::W0},
                                              {"W1", &KernelRow::W1},
                                              {"gradW", &KernelRow::gradW},
                                              {"LgradW", &KernelRow::LgradW},
                                              {"gradW0", &KernelRow::gradW0},
                                              {"LgradW0", &KernelRow::LgradW0},
                                              {"gradW1", &KernelRow::gradW1}}};
  std::vector<std::pair<std::string, double>> all;
  for (const Column& column : columns) {
    double zeroth = 0, first = 0;
    for (std::size_t j = 0; j < rows.size(); ++j) {
      const double share = seen[j].volume * (rows[j].*column.member);
      zeroth += share;
      first += share * seen[j].separation[0];
    }
    all.emplace_back(fmt::format("V{}", column.name), zeroth);
    all.emplace_back(fmt::format("VX{}", column.name), first);
  }
  return all;
}

}  // namespace

KernelView explore(const Discretisation& discretisation, double x) {
  const Cloud<1> cloud = make_cloud(discretisation);
  const RadialKernel<1> kernel = kernel_named<1>(discretisation.kernel);
  if (!(x >= 0 && x <= discretisation.length))
    throw InputError(fmt::format("the evaluation point x = {} lies outside the body", x),
                     fmt::format("the body is [0, {}]", discretisation.length), "Give --at inside it.");
  const double R = discretisation.support();
  const double h = R / kernel.support;
  const Window window = window_at(cloud, R, x);
  if (window.count() < 2)
    throw InputError(fmt::format("the point x = {:.6g} m has {} particles in its support", x, window.count()),
                     fmt::format("R = {:.6g} m, spacing {:.6g} m; a gradient needs 2", R, cloud.spacing),
                     "Increase --radius or --radius-over-dx.");
  std::vector<Neighbour<1>> seen;
  see(cloud, window, x, seen);
  const auto plain = correct<1>(Correction::none, kernel, h, seen);
  const auto shepard = correct<1>(Correction::W0raw, kernel, h, seen);
  const auto normalised = correct<1>(Correction::W0, kernel, h, seen);
  const auto first_order = correct<1>(Correction::W1, kernel, h, seen);
  std::vector<Vec<1>> plain_normalised = plain.gradient;
  normalise_gradient<1>(seen, plain_normalised);

  KernelView view{x, discretisation.dx(), R, h, first_order.alpha, first_order.beta[0], {}, {}};
  for (std::size_t j = 0; j < seen.size(); ++j) {
    const double V = seen[j].volume;
    view.rows.push_back({cloud.X[static_cast<std::size_t>(window.first) + j][0], plain.weight[j] / V,
                         shepard.weight[j] / V, first_order.weight[j] / V, plain.gradient[j][0] / V,
                         plain_normalised[j][0] / V, shepard.gradient[j][0] / V,
                         normalised.gradient[j][0] / V, first_order.gradient[j][0] / V});
  }
  view.sums = sums(view.rows, seen);
  return view;
}

}  // namespace plumb::oned
