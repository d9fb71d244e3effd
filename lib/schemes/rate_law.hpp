#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/core/error.hpp"
#include "lib/core/field.hpp"
#include "lib/material/johnson_cook.hpp"
#include "lib/material/laws.hpp"
#include "lib/material/models/j2_logarithmic.hpp"
#include "lib/material/return_mapping.hpp"

namespace plumb {

/// exp(dt Omega) of a skew tensor: Rodrigues' formula, (38) of paper 002, by its series where the turn is
/// small, so that a body without spin needs no case of its own.
template <int d>
Mat<d> rotation_of(const Mat<d>& spin, double dt) {
  const double omega = std::sqrt(0.5) * spin.norm(), angle = omega * dt, square = angle * angle;
  const bool small = square < 1e-6;  // the next terms, angle^6/5040 and angle^6/20160, are below rounding
  const double first = small ? 1 - square / 6 * (1 - square / 20) : std::sin(angle) / angle;
  const double second = small ? 0.5 * (1 - square / 12 * (1 - square / 30)) : (1 - std::cos(angle)) / square;
  const Mat<d> turn = dt * spin;
  return Mat<d>::Identity() + first * turn + second * turn * turn;
}

/// The turn (I - W/2)^-1 (I + W/2) of a skew increment W of displacements with respect to the middle of a
/// step: it is exact where the step is a turn, Hughes and Winget (1980).
template <int d>
Mat<d> turn_of(const Mat<d>& W) {
  const Mat<d> I = Mat<d>::Identity();
  return (I - 0.5 * W).inverse() * (I + 0.5 * W);
}

/// The time [s] of a step that is made so slowly that rates do not count.
inline constexpr double slowly = std::numeric_limits<double>::infinity();

/// Stress by rates, (4), (8) and (14) of paper 002 and (12) to (14) of paper 001: linear pressure of the
/// density, a deviator that turns with the body, and radial return of its elastic trial to a yield stress. The
/// elastic laws of the catalogue give their bulk and shear modulus, with which they agree for small strains.
template <int d>
class RateLaw {
 public:
  RateLaw(const LawChoice& choice, const Elastic& elastic, bool plane_strain, bool jaumann,
          std::optional<double> tension_limit, std::string_view scheme = "updated")
      : bulk(elastic.bulk_modulus()),
        shear(elastic.shear_modulus()),
        density(elastic.density),
        plane_strain_(plane_strain),
        jaumann_(jaumann),
        least_pressure_(tension_limit ? -*tension_limit : -std::numeric_limits<double>::infinity()) {
    if (choice.plane == Plane::stress)
      throw InputError(fmt::format("scheme = \"{}\" under plane stress", scheme),
                       "its rates are those of plane strain", "leave out [material] plane");
    require_law(choice, elastic);
    if (choice.name == J2Logarithmic::name) {
      yield_.emplace(make_law<J2Logarithmic>(elastic, choice));
    } else if (choice.name == JohnsonCook::name) {
      cook_.emplace(make_law<JohnsonCook>(elastic, choice));
    } else if (has_history(choice.name) || !parameters_of_law(choice.name).empty()) {
      throw InputError(fmt::format("scheme = \"{}\" with a body of \"{}\"", scheme, choice.name),
                       "its stress follows rates with one bulk and one shear modulus",
                       "use model = \"linear-elastic\", \"j2-logarithmic\" or \"johnson-cook\"");
    }
  }

  double bulk, shear;  ///< K, G [Pa]
  double density;      ///< rho_0 [kg/m^3]

  bool yields() const { return yield_.has_value() || cook_.has_value(); }
  const std::optional<JohnsonCook>& johnson_cook() const { return cook_; }
  std::vector<std::string> warnings() const { return cook_ ? cook_->warnings() : std::vector<std::string>{}; }
  double sound_speed() const { return std::sqrt(bulk / density); }  ///< c_0 [m/s]: of the bulk modulus
  /// p [Pa] at that density (4), or the tension limit.
  double pressure(double rho) const { return std::max(bulk * (rho / density - 1), least_pressure_); }
  /// Returns the energy of compression per mass [J/kg]: the integral of p drho/rho^2. Without the tension limit.
  double compression_energy(double rho) const {
    return bulk / density * (std::log(rho / density) + density / rho - 1);
  }
  /// s : s with the part out of the plane, or across the bar, where both directions have half of it.
  static double square(const Mat<d>& s) {
    const double out = s.trace();
    if constexpr (d == 1) return s.squaredNorm() + 0.5 * out * out;
    return s.squaredNorm() + (d == 2 ? out * out : 0);
  }
  /// Deviator of a rate of deformation (8): that of three dimensions, or of d.
  Mat<d> deviator(const Mat<d>& rate) const {
    return rate - rate.trace() / (plane_strain_ ? 3 : d) * Mat<d>::Identity();
  }

  /// What one particle keeps of its stress.
  struct Point {
    Mat<d> s;                ///< deviator [Pa]
    double plastic = 0;      ///< alpha
    double work = 0;         ///< plastic, per volume [Pa]
    double yield_ratio = 1;  ///< of the stress that the last step left to what it tried
    double temperature = 0;  ///< [K]; of Johnson and Cook's law
    double damage = 0;       ///< likewise; 1: failed
    int iterations = 0;      ///< of the last return
  };
  /// A point without stress; with the law's own temperature if none is given [K].
  Point at_rest(std::optional<double> temperature = std::nullopt) const {
    Point point{Mat<d>::Zero()};
    if (cook_) point.temperature = temperature.value_or(cook_->temperature_at_start());
    return point;
  }
  bool failed(double damage) const { return cook_ && cook_->damages() && damage >= 1; }
  /// p [Pa] of a particle with that damage: a failed one bears no tension.
  double pressure(double rho, double damage) const {
    const double p = pressure(rho);
    return failed(damage) ? std::max(p, 0.0) : p;
  }

  /// What is kept of a point beside its stress: names and units of the components of a field.
  std::vector<std::pair<std::string, std::string>> kept() const {
    std::vector<std::pair<std::string, std::string>> names;
    if (yields()) names = {{"plastic strain", ""}, {"plastic work", "J/m^3"}};
    if (cook_) names.insert(names.end(), {{"temperature", "K"}, {"damage", ""}});
    return names;
  }
  void keep(const Point& point, Field& to, Index i) const {
    const std::array<double, 4> values{point.plastic, point.work, point.temperature, point.damage};
    for (int k = 0; k < to.components(); ++k) to[k][i] = values[static_cast<std::size_t>(k)];
  }
  Point recall(const Mat<d>& s, const Field& from, Index i) const {
    Point point{s};
    const std::array<double*, 4> values{&point.plastic, &point.work, &point.temperature, &point.damage};
    for (int k = 0; k < from.components(); ++k) *values[static_cast<std::size_t>(k)] = from[k][i];
    return point;
  }
  /// Moves a point on by dt with that velocity gradient [1/s], to the density rho.
  void advance(Point& point, const Mat<d>& L, double dt, double rho) const {
    const Mat<d> spin = 0.5 * (L - L.transpose());
    if (jaumann_) {
      const Mat<d> turned = spin * point.s;
      point.s += dt * (turned + turned.transpose());
    } else {
      const Mat<d> R = rotation_of<d>(spin, dt);
      point.s = R * point.s * R.transpose();
    }
    point.s += 2 * shear * dt * deviator(0.5 * (L + L.transpose()));
    give_back(point, dt, rho);
  }
  /// Moves a point on by an increment of displacements with respect to the middle of a step. Half of the
  /// strain acts before its turn and half after it: order 2 where strain and turn go together. Returns the
  /// deviator of before, turned.
  Mat<d> advance_by(Point& point, const Mat<d>& increment, double dt, double rho) const {
    const Mat<d> half = shear * deviator(0.5 * (increment + increment.transpose()));
    const Mat<d> R = turn_of<d>(0.5 * (increment - increment.transpose()));
    const Mat<d> before = point.s, turned = R * before * R.transpose();
    point.s = turned + R * half * R.transpose() + half;
    give_back(point, dt, rho);
    return turned;
  }
  /// The deviator of Hencky's law [Pa] at a deformation F, without yielding.
  Mat<d> deviator_of(const Mat<d>& F) const {
    Mat<3> whole = Mat<3>::Identity();
    whole.template topLeftCorner<d, d>() = F;
    const LogarithmicStrain strain(whole * whole.transpose());
    const Mat<3> e = strain.tensor(strain.strain);
    return 2 * shear * deviator(e.template topLeftCorner<d, d>());
  }
  /// Radial return (14) of an elastic trial, made in the time dt [s], which comes to the density rho.
  void give_back(Point& point, double dt, double rho) const {
    point.yield_ratio = 1;
    if (!yields()) return;
    const double trial = std::sqrt(1.5 * square(point.s));
    if (cook_) return give_back_by_rate(point, trial, dt, rho);
    if (!(trial > yield_->yield_at(point.plastic).value)) return;
    const double more =
        plastic_increment(trial, shear, [&](double g) { return yield_->yield_at(point.plastic + g); }).strain;
    const double left = trial - 3 * shear * more;
    point.yield_ratio = left / trial;
    point.s *= point.yield_ratio;
    point.plastic += more;
    point.work += left * more;
  }

 private:
  void give_back_by_rate(Point& point, double trial, double dt, double rho) const {
    if (failed(point.damage)) {
      point.s = Mat<d>::Zero();
      point.yield_ratio = 0;
      return;
    }
    JohnsonCook::History history{point.plastic, point.temperature, point.damage};
    const JohnsonCook::Return left = cook_->give_back(trial, dt, pressure(rho), rho, history);
    point.iterations = left.iterations;
    point.plastic = history.plastic;
    point.temperature = history.temperature;
    point.damage = history.damage;
    if (!(left.strain > 0)) return;
    point.yield_ratio = failed(point.damage) ? 0 : left.q / trial;
    point.s *= point.yield_ratio;
    point.work += left.q * left.strain;
  }

  bool plane_strain_, jaumann_;
  double least_pressure_;
  std::optional<J2Logarithmic> yield_;
  std::optional<JohnsonCook> cook_;
};

}  // namespace plumb
