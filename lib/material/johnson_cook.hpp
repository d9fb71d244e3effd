#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/core/error.hpp"
#include "lib/core/quantity.hpp"
#include "lib/material/law.hpp"
#include "lib/material/return_mapping.hpp"

namespace plumb {

/// J2 plasticity of Johnson and Cook with heating and damage, (22) to (26) of paper 001, for stress by rates.
/// THEORY (4.17), (4.18), (4.19).
///   sigma_y = (A + B ep^n) (1 + C ln(rate/rate_0)) (1 - T*^m),   rate = d ep/dt >= rate_0,   T* in [0, 1]
///   rho c_p dT = eta q d ep,   dD = d ep/eps_f,   failed where D = 1
///   eps_f = (D1 + D2 exp(D3 s)) (1 + D4 ln(rate/rate_0)) (1 + D5 T*),   s = -P/q,   not less than its floor
/// The temperature is that of before the step, the rate that of the step.
struct JohnsonCook {
  static constexpr std::string_view name = "johnson-cook";
  static constexpr Quantity kelvin{"a temperature in K", {0, 0, 0}, "K"};
  static constexpr Quantity capacity{"a heat capacity", {0, 2, -2}, "J/(kg K)"};

  struct Parameters {
    double yield = 0;                           ///< A [Pa]
    double hardening = 0;                       ///< B [Pa]
    double hardening_exponent = 1;              ///< n
    double rate_factor = 0;                     ///< C
    double reference_rate = 1;                  ///< rate_0 [1/s]
    double softening_exponent = 1;              ///< m
    double reference_temperature = 0;           ///< T_ref [K]
    std::optional<double> melting_temperature;  ///< T_melt [K]; none: the stress does not see the temperature
    std::optional<double> temperature;          ///< of the start [K]; none: the reference temperature
    double heat_capacity = 0;                   ///< c_p [J/(kg K)]; 0: the body does not heat
    double heat_share = 0.9;                    ///< eta
    std::optional<double> damage_1;             ///< D1; none: there is no damage
    double damage_2 = 0, damage_3 = 0, damage_4 = 0, damage_5 = 0;
    double fracture_floor = 1e-3;  ///< least eps_f

    template <class Visit>
    void fields(Visit&& visit) {
      constexpr double inf = std::numeric_limits<double>::infinity();
      visit(LawParameter{"yield", quantity::stress, "A: yield stress at first", Sign::positive, inf, true}
                .called("A"),
            yield);
      visit(LawParameter{"hardening", quantity::stress, "B: factor of the power of the plastic strain",
                         Sign::not_negative}
                .called("B"),
            hardening);
      visit(LawParameter{"hardening_exponent", quantity::number, "n: that power", Sign::positive}.called("n"),
            hardening_exponent);
      visit(
          LawParameter{"rate_factor", quantity::number, "C: of the logarithm of the rate", Sign::not_negative}
              .called("C"),
          rate_factor);
      visit(LawParameter{"reference_rate", quantity::rate, "slower flow has the stress of this rate",
                         Sign::positive},
            reference_rate);
      visit(
          LawParameter{"softening_exponent", quantity::number, "m: power of the temperature", Sign::positive}
              .called("m"),
          softening_exponent);
      visit(LawParameter{"reference_temperature", kelvin, "below it nothing softens", Sign::not_negative},
            reference_temperature);
      visit(
          LawParameter{"melting_temperature", kelvin, "from here on nothing yields a stress", Sign::positive},
          melting_temperature);
      visit(LawParameter{"temperature", kelvin, "of the start", Sign::not_negative}, temperature);
      visit(LawParameter{"heat_capacity", capacity, "c_p", Sign::not_negative}, heat_capacity);
      visit(LawParameter{"heat_share", quantity::number, "eta: share of the plastic work that heats",
                         Sign::not_negative, 1}
                .called("eta"),
            heat_share);
      visit(LawParameter{"damage_1", quantity::number, "D1 of the strain at fracture"}, damage_1);
      visit(LawParameter{"damage_2", quantity::number, "D2, times exp(D3 s)"}, damage_2);
      visit(LawParameter{"damage_3", quantity::number, "D3, of the triaxiality s = -P/q"}, damage_3);
      visit(LawParameter{"damage_4", quantity::number, "D4, of the logarithm of the rate"}, damage_4);
      visit(LawParameter{"damage_5", quantity::number, "D5, of the temperature"}, damage_5);
      visit(
          LawParameter{"fracture_floor", quantity::number, "least strain at fracture", Sign::positive}.called(
              "fracture_strain_floor"),
          fracture_floor);
    }
  };

  double shear, density;  ///< mu [Pa], rho_0 [kg/m^3]
  Parameters p;

  JohnsonCook(const Elastic& e, const Parameters& given)
      : shear(e.shear_modulus()), density(e.density), p(given) {
    if (p.melting_temperature && *p.melting_temperature <= p.reference_temperature)
      throw InputError("melting_temperature is not above reference_temperature",
                       "nothing could soften between them", "give a higher melting_temperature");
  }

  /// Triaxiality -P/q from which on the first factor of eps_f is negative, so that the floor holds; nothing:
  /// there is none.
  std::optional<double> triaxiality_of_floor() const {
    const double D1 = p.damage_1.value_or(0);
    if (!(D1 < 0 && p.damage_2 > 0 && p.damage_3 < 0)) return std::nullopt;
    return std::log(-D1 / p.damage_2) / p.damage_3;
  }
  std::vector<std::string> warnings() const {
    std::vector<std::string> found;
    if (p.melting_temperature && temperature_at_start() < p.reference_temperature)
      found.emplace_back(
          "temperature is below reference_temperature: the yield stress is that of the latter");
    if (const auto s = triaxiality_of_floor())
      found.push_back(
          fmt::format("the strain at fracture is negative above a triaxiality of {:.4g}: there it is "
                      "fracture_floor = {:g}",
                      *s, p.fracture_floor));
    return found;
  }

  /// What a point keeps.
  struct History {
    double plastic = 0;      ///< ep
    double temperature = 0;  ///< T [K]
    double damage = 0;       ///< D
  };
  double temperature_at_start() const { return p.temperature.value_or(p.reference_temperature); }
  bool damages() const { return p.damage_1.has_value(); }

  /// T* in [0, 1].
  double warmth(double T) const {
    if (!p.melting_temperature) return 0;
    return std::clamp((T - p.reference_temperature) / (*p.melting_temperature - p.reference_temperature), 0.0,
                      1.0);
  }
  /// sigma_y and its slope by the increment g of the plastic strain in the time dt [s], (23).
  Yield yield_at(const History& before, double g, double dt) const {
    constexpr double least = 1e-12;  // the slope of ep^n has none at 0 where n < 1
    const double ep = std::max(before.plastic + g, least);
    const double hard = p.yield + p.hardening * std::pow(ep, p.hardening_exponent);
    const double slope = p.hardening * p.hardening_exponent * std::pow(ep, p.hardening_exponent - 1);
    const double ratio = g / (dt * p.reference_rate);
    const double rate = ratio > 1 ? 1 + p.rate_factor * std::log(ratio) : 1;
    const double by_rate = ratio > 1 ? p.rate_factor / g : 0;
    const double soft = 1 - std::pow(warmth(before.temperature), p.softening_exponent);
    return {hard * rate * soft, (slope * rate + hard * by_rate) * soft};
  }
  /// eps_f, (26) with its floor; s = -P/q.
  double strain_at_fracture(double s, double rate, double T) const {
    const double ratio = rate / p.reference_rate;
    return std::max(p.fracture_floor, (p.damage_1.value_or(0) + p.damage_2 * std::exp(p.damage_3 * s)) *
                                          (1 + (ratio > 1 ? p.damage_4 * std::log(ratio) : 0)) *
                                          (1 + p.damage_5 * warmth(T)));
  }

  /// What a return leaves of the trial stress q [Pa] in the time dt [s].
  struct Return {
    double q;        ///< [Pa]
    double strain;   ///< of the plastic increment
    int iterations;  ///< 0: elastic
  };
  /// Moves the history on. P [Pa] and rho [kg/m^3]: pressure and density at the end of the step.
  Return give_back(double q_trial, double dt, double P, double rho, History& h) const {
    if (!(q_trial > yield_at(h, 0, dt).value)) return {q_trial, 0, 0};
    const PlasticIncrement more = plastic_increment(
        q_trial, shear, [&](double g) { return yield_at(h, g, dt); }, Start::upper);
    const double q = q_trial - 3 * shear * more.strain;
    h.plastic += more.strain;
    if (p.heat_capacity > 0) h.temperature += p.heat_share * q * more.strain / (rho * p.heat_capacity);
    if (damages() && q > 0)
      h.damage += more.strain / strain_at_fracture(-P / q, more.strain / dt, h.temperature);
    return {q, more.strain, more.iterations};
  }
};

}  // namespace plumb
