#include "verification/plumb/foreign/suspicion.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>

namespace plumb::app {
namespace {

/// An explanation leaves at most this share of the error.
constexpr double explained = 0.2;

/// The displacement of a file beside the exact one, with the sums that explanations need.
template <int d>
class Comparison {
 public:
  Comparison(const ForeignField<d>& field, const mms::ExactFields<d>& exact, double time)
      : field_(field), exact_(exact), time_(time), error_(distance(1, 0)) {}

  /// L2 norm of u_h - factor u(t + shift).
  double distance(double factor, double shift) const {
    return sum(
        [&](std::size_t k, const mms::Motion<d>& m) {
          return Vec<d>(field_.displacement[k] - factor * m.displacement);
        },
        shift);
  }
  /// The same of the velocities.
  double velocity_distance(double factor, double shift) const {
    return sum([&](std::size_t k,
                   const mms::Motion<d>& m) { return Vec<d>(field_.velocity[k] - factor * m.velocity); },
               shift);
  }
  double exchanged() const {
    return sum(
        [&](std::size_t k, const mms::Motion<d>& m) {
          return Vec<d>(field_.displacement[k] - m.displacement.reverse());
        },
        0);
  }
  /// The factor that leaves the least.
  double best_factor() const {
    double both = 0, square = 0;
    for (std::size_t k = 0; k < field_.X.size(); ++k) {
      const Vec<d> u = exact_.motion(field_.X[k], time_).displacement;
      both += field_.volume[k] * field_.displacement[k].dot(u);
      square += field_.volume[k] * u.squaredNorm();
    }
    return square > 0 ? both / square : 1;
  }
  /// The shift within an eighth of the period that leaves the least.
  double best_shift() const {
    const double reach = exact_.period / 8;
    double best = 0, least = error_;
    for (double step = reach / 10; step > 1e-7 * reach; step /= 4) {
      const double around = best;
      for (int k = -10; k <= 10; ++k) {
        const double shift = around + k * step, left = distance(1, shift);
        if (left < least) best = shift, least = left;
      }
    }
    return best;
  }
  double error() const { return error_; }

 private:
  double sum(const std::function<Vec<d>(std::size_t, const mms::Motion<d>&)>& difference,
             double shift) const {
    double all = 0;
    for (std::size_t k = 0; k < field_.X.size(); ++k)
      all += field_.volume[k] * difference(k, exact_.motion(field_.X[k], time_ + shift)).squaredNorm();
    return std::sqrt(all);
  }

  const ForeignField<d>& field_;
  const mms::ExactFields<d>& exact_;
  double time_, error_;
};

std::string factor_text(double factor) {
  const double power = std::log10(std::abs(factor));
  const bool units = factor != 0 && std::abs(power) > 0.5 && std::abs(power - std::round(power)) < 0.01;
  return fmt::format("It is {:.4g} times the exact displacement{}.", factor,
                     units        ? ", a power of ten: a slip of units"
                     : factor < 0 ? ": a wrong sign"
                                  : ": an amplitude, a modulus or a load is off by a factor");
}

}  // namespace

template <int d>
std::vector<std::string> suspicion(const ForeignField<d>& field, const mms::ExactFields<d>& exact,
                                   double time) {
  std::vector<std::string> found;
  const Comparison<d> compare(field, exact, time);
  const double limit = explained * compare.error();
  if (!(compare.error() > 0)) return found;
  const double factor = compare.best_factor(), shift = compare.best_shift();
  const bool by_factor = compare.distance(factor, 0) <= limit, by_time = compare.distance(1, shift) <= limit;
  bool time_first = by_time && !by_factor;
  if (by_factor && by_time && !field.velocity.empty())
    time_first = compare.velocity_distance(1, shift) < compare.velocity_distance(factor, 0);
  const std::string late = fmt::format("It is the exact displacement of {:.4g} s {}: a wrong time level.",
                                       std::abs(shift), shift > 0 ? "later" : "earlier");
  if (by_time && time_first) found.push_back(late);
  if (by_factor) found.push_back(factor_text(factor));
  if (by_time && !time_first) found.push_back(late);
  if (compare.exchanged() <= limit) found.emplace_back("Its components are exchanged.");
  return found;
}

template <int d>
std::string region(const ForeignField<d>& field, const mms::ExactFields<d>& exact, double time) {
  double edge = 0, all = 0, edge_volume = 0, volume = 0;
  for (std::size_t k = 0; k < field.X.size(); ++k) {
    const double V = field.volume[k];
    const double square =
        V * (field.displacement[k] - exact.motion(field.X[k], time).displacement).squaredNorm();
    all += square;
    volume += V;
    if (exact.domain.depth(field.X[k]) > 2 * field.spacing) continue;
    edge += square;
    edge_volume += V;
  }
  if (!(all > 0)) return "There is no error.";
  return fmt::format(
      "{:.0f} % of the squared error lies within two spacings "
      "of the boundary, which are {:.0f} % of the volume: {}.",
      100 * edge / all, 100 * edge_volume / volume,
      edge / all > 0.5 && edge / all > 1.5 * edge_volume / volume
          ? "look at boundary values and supports"
          : "look at the load, the law and its constants inside");
}

template std::vector<std::string> suspicion<1>(const ForeignField<1>&, const mms::ExactFields<1>&, double);
template std::vector<std::string> suspicion<2>(const ForeignField<2>&, const mms::ExactFields<2>&, double);
template std::vector<std::string> suspicion<3>(const ForeignField<3>&, const mms::ExactFields<3>&, double);

template std::string region<1>(const ForeignField<1>&, const mms::ExactFields<1>&, double);
template std::string region<2>(const ForeignField<2>&, const mms::ExactFields<2>&, double);
template std::string region<3>(const ForeignField<3>&, const mms::ExactFields<3>&, double);

}  // namespace plumb::app
