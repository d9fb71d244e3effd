// libplumbline_c against the library that it is made of, and its refusals.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <thread>

#include "lib/convergence/verdict.hpp"
#include "lib/material/laws.hpp"
#include "mms/exact_fields.hpp"
#include "mms/manufactured.hpp"
#include "plumbline.h"

namespace plumb {
namespace {

using Handle = std::unique_ptr<plumb_solution, void (*)(plumb_solution*)>;

Handle solution(const char* name, int dimension) {
  plumb_solution* made = nullptr;
  EXPECT_EQ(plumb_new(name, dimension, &made), PLUMB_OK) << plumb_message();
  return {made, plumb_free};
}

/// Values that a law needs: those that it requires are given.
std::map<std::string, double> needed_of(const std::string& law) {
  std::map<std::string, double> values;
  for (const LawParameter& about : parameters_of_law(law))
    if (about.required) values[std::string(about.name)] = 1e4;
  return values;
}

constexpr std::array quantities{
    PLUMB_DISPLACEMENT, PLUMB_VELOCITY,   PLUMB_ACCELERATION,        PLUMB_F,          PLUMB_P,
    PLUMB_CAUCHY,       PLUMB_BODY_FORCE, PLUMB_BODY_FORCE_PER_MASS, PLUMB_STATIC_LOAD};

template <int d>
std::vector<double> expected(const mms::ExactFields<d>& f, plumb_quantity quantity, const Vec<d>& X,
                             double t) {
  const auto rows = [](const Mat<d>& M) {
    const Eigen::Matrix<double, d, d, Eigen::RowMajor> R = M;
    return std::vector<double>(R.data(), R.data() + d * d);
  };
  const auto entries = [](const Vec<d>& v) { return std::vector<double>(v.data(), v.data() + d); };
  const mms::Motion<d> m = f.motion(X, t);
  switch (quantity) {
    case PLUMB_DISPLACEMENT:
      return entries(m.displacement);
    case PLUMB_VELOCITY:
      return entries(m.velocity);
    case PLUMB_ACCELERATION:
      return entries(m.acceleration);
    case PLUMB_F:
      return rows(m.F);
    case PLUMB_P:
      return rows(f.first_piola(X, t));
    case PLUMB_CAUCHY:
      return rows(f.first_piola(X, t) * m.F.transpose() / m.F.determinant());
    case PLUMB_BODY_FORCE:
      return entries(f.density * m.acceleration - f.stress_divergence(X, t));
    case PLUMB_BODY_FORCE_PER_MASS:
      return entries(m.acceleration - f.stress_divergence(X, t) / f.density);
    case PLUMB_STATIC_LOAD:
      break;
  }
  return entries(-f.stress_divergence(X, t));
}

template <int d>
void compare(const std::string& name, const std::string& law) {
  const Elastic elastic{2e6, 0.3, 1200};
  const auto handle = solution(name.c_str(), d);
  ASSERT_EQ(plumb_set_law(handle.get(), law.c_str(), elastic.young, elastic.poisson, elastic.density),
            PLUMB_OK);
  for (const auto& [key, value] : needed_of(law))
    ASSERT_EQ(plumb_set_law_parameter(handle.get(), key.c_str(), value), PLUMB_OK) << plumb_message();
  ASSERT_EQ(plumb_set_increments(handle.get(), 20), PLUMB_OK);
  const auto fields = mms::exact_fields<d>(name, {}, elastic, LawChoice(law, needed_of(law)), 20);
  const Vec<d> A = fields.domain.box.origin + 0.9 * fields.domain.box.size;
  const std::array<Vec<d>, 2> X{A, Vec<d>(A + 0.01 * Vec<d>::Ones())};
  const double t = 0.3 * fields.period;
  for (const plumb_quantity quantity : quantities) {
    const std::size_t n = plumb_components(handle.get(), quantity);
    std::vector<double> values(2 * n);
    ASSERT_EQ(plumb_evaluate(handle.get(), quantity, 2, X[0].data(), t, values.data()), PLUMB_OK)
        << plumb_message();
    std::vector<double> right = expected<d>(fields, quantity, X[0], t);
    for (const double value : expected<d>(fields, quantity, X[1], t)) right.push_back(value);
    // what cancels to nothing is small against the modulus over a metre
    double size = quantity < PLUMB_P                      ? 1
                  : quantity == PLUMB_BODY_FORCE_PER_MASS ? 1e7 / elastic.density
                                                          : 1e7;
    for (const double value : right) size = std::max(size, std::abs(value));
    for (std::size_t k = 0; k < right.size();
         ++k)  // the test is compiled with other contractions: some units in the last place
      EXPECT_NEAR(values[k], right[k], 1e-13 * size) << name << ' ' << law << " quantity " << quantity;
  }
}

TEST(CInterface, AllQuantitiesOfAllSolutionsAndLaws) {
  for (std::size_t s = 0; s < plumb_solution_count(); ++s)
    for (std::size_t l = 0; l < plumb_law_count(); ++l) {
      if (plumb_solution_exists_in(s, 1)) compare<1>(plumb_solution_name(s), plumb_law_name(l));
      if (plumb_solution_exists_in(s, 2)) compare<2>(plumb_solution_name(s), plumb_law_name(l));
      if (plumb_solution_exists_in(s, 3)) compare<3>(plumb_solution_name(s), plumb_law_name(l));
    }
  EXPECT_EQ(plumb_solution_count(), mms::solution_list().size());
  EXPECT_EQ(plumb_law_count(), names_of(MaterialCatalogue{}).size());
}

// Below its yield stress the law is Hencky's, whose stress in one direction is known: tau = (lambda + 2 mu)
// ln(stretch), P = tau/stretch.
TEST(CInterface, ALawWithHistoryIsHenckysBelowItsYieldStress) {
  const auto wave = solution("standing-wave", 2);
  const double E = 1e6, nu = 0.3, modulus = E * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
  ASSERT_EQ(plumb_set_law(wave.get(), "j2-logarithmic", E, nu, 1000), PLUMB_OK);
  ASSERT_EQ(plumb_set_law_parameter(wave.get(), "yield", 1e9), PLUMB_OK);
  const double X[2] = {0.3, 0.5};
  double F[4], P[4], force[2], u[2];
  ASSERT_EQ(plumb_evaluate(wave.get(), PLUMB_F, 1, X, 0, F), PLUMB_OK);
  ASSERT_EQ(plumb_evaluate(wave.get(), PLUMB_P, 1, X, 0, P), PLUMB_OK);
  ASSERT_EQ(plumb_evaluate(wave.get(), PLUMB_STATIC_LOAD, 1, X, 0, force), PLUMB_OK);
  ASSERT_EQ(plumb_evaluate(wave.get(), PLUMB_DISPLACEMENT, 1, X, 0, u), PLUMB_OK);
  EXPECT_NEAR(P[0], modulus * std::log(F[0]) / F[0], 1e-9 * modulus);
  const double bend = -std::pow(M_PI, 2) * u[0];  // u_xx of a sine
  const double divergence = modulus * (1 - std::log(F[0])) / (F[0] * F[0]) * bend;
  EXPECT_NEAR(-force[0], divergence,
              1e-9 * modulus);  // differences over 1/800 of the box: round-off 1e-13 of the modulus
}

// Above it the plastic deviator is bounded: sqrt(3/2) |dev sigma| J = yield.
TEST(CInterface, ALawWithHistoryYields) {
  const auto wave = solution("standing-wave", 3);
  ASSERT_EQ(plumb_set_law(wave.get(), "j2-logarithmic", 1e6, 0.3, 1000), PLUMB_OK);
  ASSERT_EQ(plumb_set_law_parameter(wave.get(), "yield", 1e3), PLUMB_OK);
  const double X[3] = {0.1, 0.5, 0.5};
  double s[9], F[9];
  ASSERT_EQ(plumb_evaluate(wave.get(), PLUMB_CAUCHY, 1, X, 0, s), PLUMB_OK);
  ASSERT_EQ(plumb_evaluate(wave.get(), PLUMB_F, 1, X, 0, F), PLUMB_OK);
  EXPECT_NEAR(std::abs(s[0] - s[4]) * F[0], 1e3, 1e-6);
}

TEST(CInterface, RefusalsHaveCodesAndMessages) {
  plumb_solution* none = nullptr;
  EXPECT_EQ(plumb_new("swinging-plat", 2, &none), PLUMB_BAD_INPUT);
  EXPECT_NE(std::string(plumb_message()).find("Did you mean \"swinging-plate\""), std::string::npos)
      << plumb_message();
  EXPECT_EQ(plumb_new("swinging-plate", 3, &none), PLUMB_BAD_INPUT);
  EXPECT_EQ(plumb_new(nullptr, 2, &none), PLUMB_BAD_INPUT);
  EXPECT_EQ(none, nullptr);
  const auto plate = solution("swinging-plate", 2);
  EXPECT_EQ(plumb_set(plate.get(), "amplitude", NAN), PLUMB_BAD_INPUT);
  EXPECT_EQ(plumb_set(nullptr, "amplitude", 0.1), PLUMB_BAD_INPUT);
  EXPECT_EQ(plumb_set_law(plate.get(), "neo-hookean", -1, 0.3, 1), PLUMB_BAD_INPUT);
  EXPECT_EQ(plumb_set_law(plate.get(), "neo-hookean", 1, 0.5, 1), PLUMB_BAD_INPUT);
  EXPECT_EQ(plumb_set_law(plate.get(), "neohookean", 1, 0.3, 1), PLUMB_BAD_INPUT);
  EXPECT_EQ(plumb_set_law_parameter(plate.get(), "yield", 1), PLUMB_BAD_INPUT);
  const double X[2] = {0.5, 0.5}, far[2] = {INFINITY, 0};
  double u[2] = {-7, -7};
  EXPECT_EQ(plumb_evaluate(plate.get(), PLUMB_DISPLACEMENT, 1, far, 0, u), PLUMB_BAD_INPUT);
  EXPECT_EQ(plumb_evaluate(plate.get(), PLUMB_DISPLACEMENT, 1, X, NAN, u), PLUMB_BAD_INPUT);
  EXPECT_EQ(plumb_evaluate(plate.get(), static_cast<plumb_quantity>(12), 1, X, 0, u), PLUMB_BAD_INPUT);
  EXPECT_EQ(plumb_evaluate(plate.get(), PLUMB_DISPLACEMENT, 1, nullptr, 0, u), PLUMB_BAD_INPUT);
  EXPECT_EQ(u[0], -7);  // a refusal writes nothing
  ASSERT_EQ(plumb_set_law(plate.get(), "j2-logarithmic", 1e6, 0.3, 1e3), PLUMB_OK);
  EXPECT_EQ(plumb_evaluate(plate.get(), PLUMB_P, 1, X, 0, u), PLUMB_BAD_INPUT);  // yield is missing
  EXPECT_NE(std::string(plumb_message()).find("without yield"), std::string::npos) << plumb_message();
  EXPECT_EQ(plumb_solution_name(999), nullptr);
  plumb_parameter parameter;
  EXPECT_EQ(plumb_solution_parameter(0, 999, &parameter), PLUMB_BAD_INPUT);
  plumb_free(nullptr);
}

TEST(CInterface, NormsWeighErrorAndExactField) {
  const double values[4] = {3, 4, 1, 1}, exact[4] = {0, 0, 1, 3}, weights[2] = {0.25, 2};
  plumb_norms norms;
  ASSERT_EQ(plumb_field_error(2, 2, values, exact, weights, &norms), PLUMB_OK);
  EXPECT_DOUBLE_EQ(norms.l2, std::sqrt(0.25 * 25 + 2 * 4));
  EXPECT_DOUBLE_EQ(norms.exact_l2, std::sqrt(2 * 10.0));
  EXPECT_DOUBLE_EQ(norms.relative_l2, norms.l2 / norms.exact_l2);
  EXPECT_EQ(norms.linf, 5);
  EXPECT_EQ(norms.worst, 0u);
  ASSERT_EQ(plumb_field_error(2, 2, values, nullptr, nullptr, &norms), PLUMB_OK);
  EXPECT_DOUBLE_EQ(norms.l2, std::sqrt((25 + 2) / 2.0));
  EXPECT_TRUE(std::isnan(norms.relative_l2));
  const double negative[2] = {1, -1};
  EXPECT_EQ(plumb_field_error(2, 2, values, exact, negative, &norms), PLUMB_BAD_INPUT);
  EXPECT_EQ(plumb_field_error(0, 2, values, exact, weights, &norms), PLUMB_BAD_INPUT);
}

TEST(CInterface, OrdersAreThoseOfTheLibrary) {
  const double h[5] = {0.4, 0.2, 0.1, 0.05, 0.025}, e[5] = {0.33, 0.081, 0.0199, 0.00502, 0.00124}, two = 2;
  std::vector<Level> levels;
  for (int k = 0; k < 5; ++k) levels.push_back({h[k], e[k]});
  FitOptions options;
  options.round_off = 0;
  const OrderFit right = fit_order(levels, options);
  plumb_fit fit;
  double pairwise[4];
  ASSERT_EQ(plumb_fit_order(5, h, e, 0, &two, &fit, pairwise), PLUMB_OK);
  EXPECT_EQ(fit.order, right.order);
  EXPECT_EQ(fit.lower, right.lower);
  EXPECT_EQ(fit.upper, right.upper);
  EXPECT_EQ(fit.drift, right.drift);
  EXPECT_EQ(fit.levels, 5u);
  EXPECT_EQ(fit.verdict, name_of(judge(right, 2)));
  EXPECT_EQ(pairwise[3], right.pairwise[3]);
  ASSERT_EQ(plumb_fit_order(5, h, e, 0, nullptr, &fit, nullptr), PLUMB_OK);
  EXPECT_EQ(fit.verdict, name_of(classify(right)));
  EXPECT_EQ(plumb_fit_order(5, h, e, -1, &two, &fit, nullptr), PLUMB_BAD_INPUT);
  const double same[2] = {0.1, 0.1};
  EXPECT_EQ(plumb_fit_order(2, same, e, 0, &two, &fit, nullptr), PLUMB_BAD_INPUT);
}

TEST(CInterface, OscillatingValuesHaveNoIndex) {
  const double h[3] = {0.4, 0.2, 0.1}, v[3] = {1, 1.2, 1.1};
  plumb_extrapolation found;
  double gci[2] = {0, 0};
  ASSERT_EQ(plumb_extrapolate(3, h, v, 1.25, nullptr, &found, gci, nullptr), PLUMB_OK);
  EXPECT_STREQ(found.behaviour, "oscillatory");
  EXPECT_TRUE(std::isnan(found.limit) && std::isnan(gci[0]) && std::isnan(gci[1]));
  EXPECT_EQ(plumb_extrapolate(2, h, v, 1.25, nullptr, &found, nullptr, nullptr), PLUMB_BAD_INPUT);
}

TEST(CInterface, SeveralThreadsMayAskOneSolution) {
  const auto plate = solution("swinging-plate", 2);
  const double X[2] = {0.3, 0.7};
  double right[2];
  std::array<std::array<double, 2>, 8> values{};
  std::vector<std::thread> threads;
  for (auto& value : values)
    threads.emplace_back([&] { plumb_evaluate(plate.get(), PLUMB_BODY_FORCE, 1, X, 0.001, value.data()); });
  for (std::thread& thread : threads) thread.join();
  plumb_evaluate(plate.get(), PLUMB_BODY_FORCE, 1, X, 0.001, right);
  for (const auto& value : values) EXPECT_EQ(value[0], right[0]);
}

/// The catalogue as C sees it, number by number, is the library's; beyond its ends there is nothing.
TEST(CInterface, NamesTheParametersOfTheLibrary) {
  const auto& all = mms::solution_list();
  ASSERT_EQ(plumb_solution_count(), all.size());
  for (std::size_t at = 0; at < all.size(); ++at) {
    SCOPED_TRACE(all[at].name);
    EXPECT_EQ(plumb_solution_name(at), all[at].name);
    const auto parameters = all[at].parameters.all();
    ASSERT_EQ(plumb_solution_parameter_count(at), parameters.size());
    plumb_parameter seen;
    for (std::size_t k = 0; k < parameters.size(); ++k) {
      ASSERT_EQ(plumb_solution_parameter(at, k, &seen), PLUMB_OK) << plumb_message();
      EXPECT_EQ(seen.name, parameters[k].name);
      EXPECT_EQ(seen.meaning, parameters[k].meaning);
      EXPECT_EQ(seen.value, parameters[k].value);
      EXPECT_EQ(seen.least, parameters[k].least);
      EXPECT_EQ(seen.most, parameters[k].most);
    }
    EXPECT_EQ(plumb_solution_parameter(at, parameters.size(), &seen), PLUMB_BAD_INPUT);
  }
  plumb_parameter seen;
  EXPECT_EQ(plumb_solution_parameter(all.size(), 0, &seen), PLUMB_BAD_INPUT);
  for (std::size_t at = 0; at < plumb_law_count(); ++at) {
    const auto parameters = parameters_of_law(plumb_law_name(at));
    SCOPED_TRACE(plumb_law_name(at));
    ASSERT_EQ(plumb_law_parameter_count(at), parameters.size());
    for (std::size_t k = 0; k < parameters.size(); ++k) {
      ASSERT_EQ(plumb_law_parameter(at, k, &seen), PLUMB_OK) << plumb_message();
      EXPECT_EQ(seen.name, parameters[k].name);
      EXPECT_EQ(seen.meaning, parameters[k].meaning);
    }
    EXPECT_EQ(plumb_law_parameter(at, parameters.size(), &seen), PLUMB_BAD_INPUT);
  }
}

}  // namespace
}  // namespace plumb
