#pragma once
#include <limits>
#include <optional>
#include <string_view>

#include "lib/core/error.hpp"
#include "lib/material/history.hpp"
#include "lib/material/logarithmic_strain.hpp"
#include "lib/material/return_mapping.hpp"

namespace plumb {

/// J2 plasticity in logarithmic strain (Hencky) with linear and saturating hardening: (32) of paper 003.
/// THEORY (4.12), (4.13), (4.14), (4.15), (4.16).
///   W = kappa/2 (ln J)^2 + mu dev e : dev e,  e = ln(b_e)/2,  b_e = F Cp^-1 F^T,  P = tau F^-T
///   q = sqrt(3/2) |dev tau| <= tau_y(a) = tau_0 + (tau_inf - tau_0)(1 - exp(-delta a)) + H a
/// Below the yield stress it is Hencky's elastic law. (ln J)^2 is convex for J < e only. Plane strain in 2D.
struct J2Logarithmic {
  static constexpr std::string_view name = "j2-logarithmic";

  struct Parameters {
    double yield = 0;                  ///< tau_0 [Pa]
    double hardening = 0;              ///< H [Pa]
    std::optional<double> saturation;  ///< tau_inf [Pa]; none: there is linear hardening only
    double saturation_exponent = 0;    ///< delta

    template <class Visit>
    void fields(Visit&& visit) {
      visit(LawParameter{"yield", quantity::stress, "yield stress at first", Sign::positive,
                         std::numeric_limits<double>::infinity(), true},
            yield);
      visit(LawParameter{"hardening", quantity::stress, "slope of the yield stress by the plastic strain",
                         Sign::not_negative},
            hardening);
      visit(LawParameter{"saturation", quantity::stress, "yield stress that exponential hardening reaches",
                         Sign::positive},
            saturation);
      visit(LawParameter{"saturation_exponent", quantity::number, "rate of exponential hardening",
                         Sign::not_negative},
            saturation_exponent);
    }
  };

  /// Committed once an increment. Referred to the reference configuration, so a rotation leaves it alone.
  struct History {
    Mat<3> Cp_inverse = Mat<3>::Identity();  ///< inverse of the plastic right Cauchy-Green tensor
    double plastic_strain = 0;               ///< accumulated

    template <class Visit>
    void fields(Visit&& visit) {
      visit("inverse plastic metric", "", Cp_inverse);
      visit("plastic strain", "", plastic_strain);
    }
  };

  double shear, bulk;  ///< mu, kappa [Pa]
  Parameters hardening;

  J2Logarithmic(const Elastic& e, const Parameters& p)
      : shear(e.shear_modulus()), bulk(e.bulk_modulus()), hardening(p) {
    if (p.saturation && *p.saturation < p.yield)
      throw InputError("saturation is below yield", "a yield stress that falls has no unique answer",
                       "give a saturation above yield");
  }

  /// tau_y and its slope at that plastic strain.
  Yield yield_at(double plastic_strain) const {
    Yield y{hardening.yield + hardening.hardening * plastic_strain, hardening.hardening};
    if (hardening.saturation) {
      const double rise = *hardening.saturation - hardening.yield, delta = hardening.saturation_exponent;
      y.value -= rise * std::expm1(-delta * plastic_strain);
      y.slope += rise * delta * std::exp(-delta * plastic_strain);
    }
    return y;
  }

  /// Elastic energy per reference volume [Pa] of a state whose history is committed.
  double energy(const Mat<3>& F, const History& history) const {
    const LogarithmicStrain e(F * history.Cp_inverse * F.transpose());
    const double volume = std::log(F.determinant());
    return 0.5 * bulk * volume * volume + shear * e.deviator().squaredNorm();
  }

  /// Energy per reference volume [Pa] that an increment from that history to F has stored and dissipated: stress() is its
  /// derivative by F. THEORY (4.21).
  double potential(const Mat<3>& F, const History& before) const {
    const LogarithmicStrain e(F * before.Cp_inverse * F.transpose());
    const Return back = mapped(e, before);
    const double volume = std::log(F.determinant());
    return 0.5 * bulk * volume * volume + shear * (back.scale * e.deviator()).squaredNorm() +
           flow_work(before.plastic_strain, back.increment.strain);
  }

  Response stress(const Mat<3>& F, History& history) const {
    const LogarithmicStrain e(F * history.Cp_inverse * F.transpose());
    const Return back = mapped(e, history);
    const Mat<3> F_inverse = F.inverse();
    if (back.increment.iterations > 0) {
      const Vec<3> elastic = e.strain.array() - (1 - back.scale) * e.deviator().array();
      history.Cp_inverse = F_inverse * e.tensor((2 * elastic).array().exp()) * F_inverse.transpose();
      history.plastic_strain += back.increment.strain;
    }
    const Vec<3> tau = (2 * shear * back.scale * e.deviator()).array() + bulk * std::log(F.determinant());
    return {e.tensor(tau) * F_inverse.transpose(), back.q, back.q * back.increment.strain,
            back.increment.iterations};
  }

  /// Returns the tangent of the algorithm: the derivative of what stress() returns, with the history of before the increment.
  Mat<9> tangent(const Mat<3>& F, const History& before) const {
    const LogarithmicStrain e(F * before.Cp_inverse * F.transpose());
    const Return back = mapped(e, before);
    const Mat<3> slopes = principal_slopes(e, back, before);
    const Vec<3> tau = (2 * shear * back.scale * e.deviator()).array() + bulk * std::log(F.determinant());
    const Mat<3> F_inverse = F.inverse(), P = e.tensor(tau) * F_inverse.transpose();
    Mat<9> all;
    for (int n = 0; n < 9; ++n) {
      Mat<3> dF = Mat<3>::Zero();
      dF(n / 3, n % 3) = 1;
      const Mat<3> half = dF * before.Cp_inverse * F.transpose();
      const Mat<3> db = e.directions.transpose() * (half + half.transpose()) * e.directions;
      Mat<3> dtau;  // in the principal directions
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) dtau(a, b) = 2 * shear * back.scale * e.slope(a, b) * db(a, b);
      dtau.diagonal() = slopes * (db.diagonal().array() / (2 * e.square.array())).matrix();
      const Mat<3> dP = e.directions * dtau * e.directions.transpose() * F_inverse.transpose() -
                        P * dF.transpose() * F_inverse.transpose();
      for (int m = 0; m < 9; ++m) all(m, n) = dP(m / 3, m % 3);
    }
    return all;
  }

 private:
  struct Return {
    double scale;  ///< of the deviator: q/q_trial
    double q;      ///< [Pa]
    PlasticIncrement increment;
  };

  /// Integral of tau_y from that plastic strain on [Pa].
  double flow_work(double from, double more) const {
    double work = hardening.yield * more + hardening.hardening * more * (from + more / 2);
    if (hardening.saturation && hardening.saturation_exponent > 0) {
      const double rise = *hardening.saturation - hardening.yield, delta = hardening.saturation_exponent;
      work += rise * (more + std::exp(-delta * from) * std::expm1(-delta * more) / delta);
    }
    return work;
  }

  Return mapped(const LogarithmicStrain& e, const History& before) const {
    const double q_trial = std::sqrt(6.0) * shear * e.deviator().norm();
    if (!(q_trial > yield_at(before.plastic_strain).value)) return {1, q_trial, {0, 0}};
    const PlasticIncrement increment = plastic_increment(
        q_trial, shear, [&](double more) { return yield_at(before.plastic_strain + more); });
    const double q = q_trial - 3 * shear * increment.strain;
    return {q / q_trial, q, increment};
  }

  /// d tau_a / d e_b of the principal values.
  Mat<3> principal_slopes(const LogarithmicStrain& e, const Return& back, const History& before) const {
    Mat<3> slopes = Mat<3>::Constant(bulk - 2.0 / 3 * shear * back.scale);
    slopes.diagonal().array() += 2 * shear * back.scale;
    if (back.increment.iterations > 0) {
      const double rise = yield_at(before.plastic_strain + back.increment.strain).slope;
      const Vec<3> n = e.deviator().normalized();
      slopes += 2 * shear * (rise / (3 * shear + rise) - back.scale) * n * n.transpose();
    }
    return slopes;
  }
};

}  // namespace plumb
