#include "oned/explorer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

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
  const double R = discretisation.support();
  const double h = R / kernel.support;
  const Window window = support_of(cloud, R, discretisation.length, x);
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

KernelCurves kernel_curves(const Discretisation& discretisation, const KernelView& view, Index count) {
  const RadialKernel<1> kernel = kernel_named<1>(discretisation.kernel);
  const double from = std::max(0.0, view.at - view.R), to = std::min(discretisation.length, view.at + view.R);
  double whole = 0;
  for (const auto& [name, sum] : view.sums)
    if (name == "VW") whole = sum;
  KernelCurves curves;
  for (Index k = 0; k < count; ++k) {
    const double s = from + (to - from) * static_cast<double>(k) / static_cast<double>(count - 1);
    const double W = kernel.w(std::abs(s - view.at) / view.h) / view.h;
    curves.s.push_back(s);
    curves.W.push_back(W);
    curves.W0.push_back(W / whole);
    curves.W1.push_back(view.alpha * (1 - view.beta * (s - view.at)) * W);
  }
  return curves;
}

}  // namespace plumb::oned
