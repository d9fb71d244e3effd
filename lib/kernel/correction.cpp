#include "lib/kernel/correction.hpp"

#include <fmt/format.h>

#include <array>

namespace plumb {
namespace {

constexpr std::array<std::pair<Correction, std::string_view>, 4> pair_names = {{{Correction::none, "none"},
                                                                                {Correction::W0raw, "W0raw"},
                                                                                {Correction::W0, "W0"},
                                                                                {Correction::W1, "W1"}}};

/// Kernel moments at the evaluation point and their derivatives with respect to it, in units of h: (2.3),
/// (A.3), (A.6).
template <int d>
struct Moments {
  double m0 = 0;
  Vec<d> m1 = Vec<d>::Zero();
  Mat<d> m2 = Mat<d>::Zero();
  Vec<d> dm0 = Vec<d>::Zero();  // d/dk m0
  Mat<d> dm1 = Mat<d>::Zero();  // column k: d/dk m1
  std::array<Mat<d>, d> dm2;    // d/dk m2
  Moments() { dm2.fill(Mat<d>::Zero()); }
};

template <int d>
Moments<d> moments(Neighbourhood<d> neighbours, const CorrectedKernel<d>& plain, double h) {
  Moments<d> m;
  for (std::size_t j = 0; j < neighbours.size(); ++j) {
    const Vec<d> s = neighbours[j].separation / h;
    const double w = plain.weight[j];
    const Vec<d>& g = plain.gradient[j];
    m.m0 += w;
    m.m1 += w * s;
    m.m2 += w * s * s.transpose();
    m.dm0 += g;
    m.dm1 += s * g.transpose() - w * Mat<d>::Identity();
    for (int k = 0; k < d; ++k) {
      const Vec<d> unit = Vec<d>::Unit(k);
      m.dm2[k] += s * s.transpose() * g[k] - w * (s * unit.transpose() + unit * s.transpose());
    }
  }
  return m;
}

/// V W and V grad W without correction, in units of h.
template <int d>
CorrectedKernel<d> uncorrected(const RadialKernel<d>& kernel, double h, Neighbourhood<d> neighbours) {
  CorrectedKernel<d> plain;
  plain.weight.reserve(neighbours.size());
  plain.gradient.reserve(neighbours.size());
  for (const auto& n : neighbours) {
    const Vec<d> s = n.separation / h;
    const double q = s.norm();
    const double volume = n.volume / std::pow(h, d);
    plain.weight.push_back(volume * kernel.w(q));
    plain.gradient.push_back(q > 0 ? Vec<d>(-volume * kernel.dw(q) / q * s) : Vec<d>(Vec<d>::Zero()));
  }
  return plain;
}

template <int d>
void shepard(CorrectedKernel<d>& k) {
  double sum = 0;
  Vec<d> slope = Vec<d>::Zero();
  for (std::size_t j = 0; j < k.weight.size(); ++j) {
    sum += k.weight[j];
    slope += k.gradient[j];
  }
  const Vec<d> gamma = slope / sum;  // (14)
  for (std::size_t j = 0; j < k.weight.size(); ++j) {
    k.gradient[j] = (k.gradient[j] - k.weight[j] * gamma) / sum;  // (13) as it must read: THEORY (2.5)
    k.weight[j] /= sum;                                           // (10)
  }
  k.alpha = 1 / sum;
}

template <int d>
void first_order(CorrectedKernel<d>& k, Neighbourhood<d> neighbours, double h) {
  const Moments<d> m = moments(neighbours, k, h);
  const Mat<d> inverse = m.m2.inverse();
  const Vec<d> beta = inverse * m.m1;                // (7), (A.2b)
  const double alpha = 1 / (m.m0 - beta.dot(m.m1));  // (8), (A.2a)
  Mat<d> dbeta;                                      // column k: d/dk beta, (A.5b)
  Vec<d> dalpha;                                     // (A.5a)
  for (int i = 0; i < d; ++i) {
    dbeta.col(i) = inverse * (m.dm1.col(i) - m.dm2[i] * beta);
    dalpha[i] = -alpha * alpha * (m.dm0[i] - dbeta.col(i).dot(m.m1) - beta.dot(m.dm1.col(i)));
  }
  for (std::size_t j = 0; j < k.weight.size(); ++j) {
    const Vec<d> s = neighbours[j].separation / h;
    const double w = k.weight[j];
    const double linear = 1 - beta.dot(s);
    k.gradient[j] = alpha * linear * k.gradient[j] + linear * w * dalpha +
                    alpha * w * (beta - dbeta.transpose() * s);  // (A.4)
    k.weight[j] = alpha * linear * w;                            // (6)
  }
  k.alpha = alpha;
  k.beta = beta / h;
}

}  // namespace

std::string_view name_of(Correction pair) {
  return pair_names[static_cast<std::size_t>(pair)].second;
}

Correction pair_named(std::string_view name) {
  std::vector<std::string> valid;
  for (const auto& [pair, text] : pair_names) {
    if (text == name) return pair;
    valid.emplace_back(text);
  }
  throw unknown_name("pair", name, valid);
}

template <int d>
int independent_directions(Neighbourhood<d> neighbours) {
  Mat<d> directions = Mat<d>::Zero();
  int count = 0;
  for (const auto& n : neighbours) {
    const double r = n.separation.norm();
    if (r == 0) continue;
    const Vec<d> e = n.separation / r;
    directions += e * e.transpose();
    ++count;
  }
  if (count == 0) return 0;
  Eigen::FullPivLU<Mat<d>> lu(directions);
  lu.setThreshold(
      1e-12);  // directions closer than 1e-6 rad count as one: the pivot shows the square of the angle
  return static_cast<int>(lu.rank());
}

template <int d>
void normalise_gradient(Neighbourhood<d> neighbours, std::vector<Vec<d>>& gradient) {
  Mat<d> moment = Mat<d>::Zero();
  for (std::size_t j = 0; j < gradient.size(); ++j)
    moment += neighbours[j].separation * gradient[j].transpose();
  const Mat<d> inverse = moment.inverse().transpose();
  for (auto& g : gradient) g = inverse * g;
}

template <int d>
CorrectedKernel<d> correct(Correction pair, const RadialKernel<d>& kernel, double h,
                           Neighbourhood<d> neighbours) {
  CorrectedKernel<d> result = uncorrected<d>(kernel, h, neighbours);
  if (pair == Correction::W1 || pair == Correction::W0) {
    const int directions = independent_directions<d>(neighbours);
    if (directions < d)
      throw InputError(fmt::format("singular neighbourhood: {} neighbours span {} of {} directions",
                                   neighbours.size() - 1, directions, d),
                       fmt::format("the support radius {:.6g} m holds too few particles", kernel.support * h),
                       "increase beta (h over spacing) or --radius");
  }
  if (pair == Correction::W1) first_order<d>(result, neighbours, h);
  if (pair == Correction::W0 || pair == Correction::W0raw) shepard<d>(result);
  for (auto& g : result.gradient) g /= h;
  if (pair == Correction::W0) normalise_gradient<d>(neighbours, result.gradient);
  return result;
}

template int independent_directions<1>(Neighbourhood<1>);
template int independent_directions<2>(Neighbourhood<2>);
template int independent_directions<3>(Neighbourhood<3>);
template void normalise_gradient<1>(Neighbourhood<1>, std::vector<Vec<1>>&);
template void normalise_gradient<2>(Neighbourhood<2>, std::vector<Vec<2>>&);
template void normalise_gradient<3>(Neighbourhood<3>, std::vector<Vec<3>>&);
template CorrectedKernel<1> correct<1>(Correction, const RadialKernel<1>&, double, Neighbourhood<1>);
template CorrectedKernel<2> correct<2>(Correction, const RadialKernel<2>&, double, Neighbourhood<2>);
template CorrectedKernel<3> correct<3>(Correction, const RadialKernel<3>&, double, Neighbourhood<3>);

}  // namespace plumb
