// libplumbline_c with arguments that no one should give: null pointers, numbers that are none, names of
// nothing. Each call is answered, what fails says why and leaves the results alone. PLUMB_FUZZ_SECONDS
// lengthens it.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <limits>
#include <random>
#include <string>

#include "plumbline.h"

namespace plumb {
namespace {

/// The size of every array that is handed in; counts of points and levels go up to that what fits.
constexpr std::size_t room = 64;

class Caller {
 public:
  explicit Caller(std::uint64_t seed) : random_(seed) {}
  ~Caller() { plumb_free(solution_); }
  Caller(const Caller&) = delete;
  Caller& operator=(const Caller&) = delete;

  /// One call, its function and arguments by chance.
  void call() {
    switch (below(16)) {
      case 0: {
        plumb_solution* made = nullptr;
        const plumb_status status = plumb_new(name(), integer(), below(20) ? &made : nullptr);
        answered(status);
        if (status != PLUMB_OK) {
          EXPECT_EQ(made, nullptr);
          return;
        }
        plumb_free(solution_);
        solution_ = made;
        return;
      }
      case 1:
        return answered(plumb_set(solution(), name(), number()));
      case 2:
        return answered(plumb_set_law(solution(), name(), number(), number(), number()));
      case 3:
        return answered(plumb_set_law_parameter(solution(), name(), number()));
      case 4:
        return answered(plumb_set_plane_stress(solution(), integer()));
      case 5:
        return answered(plumb_set_increments(solution(), integer()));
      case 6:
        return evaluate();
      case 7: {
        const auto X = numbers(), N = numbers();
        return kept([&](double* out) {
          return plumb_traction(solution(), points(), pointer(X), pointer(N), number(), out);
        });
      }
      case 8:
        return compare();
      case 9: {
        const auto a = numbers(), b = numbers(), c = numbers();
        plumb_norms norms;
        // components * points numbers are read: both are small together
        return answered(
            plumb_field_error(below(8), below(8), pointer(a), pointer(b), pointer(c), maybe(&norms)));
      }
      case 10:
        return fit();
      case 11:
        return extrapolate();
      case 12: {
        const auto h = numbers(), v = numbers();
        plumb_grid_fit result;
        std::array<double, room> out;
        return answered(
            plumb_fit_grids(below(10), pointer(h), pointer(v), maybe(&result), maybe(out.data())));
      }
      case 13:
        return box();
      default:
        return catalogue();
    }
  }

 private:
  std::size_t below(std::size_t bound) { return random_() % bound; }
  template <class T>
  T* maybe(T* pointer) {
    return below(20) ? pointer : nullptr;
  }
  plumb_solution* solution() { return maybe(solution_); }
  std::size_t points() { return below(room / 9); }
  int integer() {
    const std::array<int, 8> all{2, 3, 0, 1, -1, 7, 100, std::numeric_limits<int>::min()};
    return all[below(all.size())];
  }
  double number() {
    const std::array<double, 14> all{0,
                                     1,
                                     -1,
                                     0.3,
                                     1e6,
                                     1000,
                                     0.02,
                                     1e300,
                                     -1e300,
                                     1e-300,
                                     0.4999999,
                                     std::numeric_limits<double>::infinity(),
                                     std::nan(""),
                                     5e-324};
    return below(3) ? all[below(all.size())] : 2 * static_cast<double>(below(1000)) / 1000 - 1;
  }
  std::array<double, room> numbers() {
    std::array<double, room> all;
    const bool tame = below(2) == 0;
    for (double& x : all) x = tame ? static_cast<double>(below(1000)) / 1000 + 1e-3 : number();
    return all;
  }
  const double* pointer(const std::array<double, room>& values) {
    return below(12) ? values.data() : nullptr;
  }
  const char* name() {
    static const std::array<const char*, 8> odd{"",     "neo-hookean", "amplitude", "standing",
                                                "%s%n", "j2",          "\xff\xfe",  "period"};
    if (below(25) == 0) return nullptr;
    switch (below(4)) {
      case 0:
        return plumb_solution_name(below(plumb_solution_count()));
      case 1:
        return plumb_law_name(below(plumb_law_count()));
      case 2: {
        plumb_parameter parameter;
        const std::size_t s = below(plumb_solution_count());
        const std::size_t count = plumb_solution_parameter_count(s);
        if (count == 0 || plumb_solution_parameter(s, below(count), &parameter) != PLUMB_OK) return "none";
        return parameter.name;
      }
      default:
        return odd[below(odd.size())];
    }
  }

  static void answered(plumb_status status) {
    EXPECT_TRUE(status == PLUMB_OK || status == PLUMB_BAD_INPUT) << status << ": " << plumb_message();
    if (status != PLUMB_OK) {
      EXPECT_GT(std::strlen(plumb_message()), 5u);
    }
  }
  /// Results of a call that fails stay as they were; those of one that does not are written where there is
  /// room.
  template <class Call>
  void kept(Call&& call) {
    constexpr double before = -12345.5;
    std::array<double, room> out;
    out.fill(before);
    double* place = maybe(out.data());
    const plumb_status status = call(place);
    answered(status);
    if (status == PLUMB_OK) return;
    for (const double value : out) EXPECT_EQ(value, before) << plumb_message();
  }
  void evaluate() {
    const auto X = numbers();
    const auto quantity = static_cast<plumb_quantity>(below(8) ? below(9) : below(1000));
    kept([&](double* out) {
      return plumb_evaluate(solution(), quantity, points(), pointer(X), number(), out);
    });
  }
  void compare() {
    const auto X = numbers(), values = numbers(), weights = numbers();
    plumb_norms norms;
    answered(plumb_error(solution(), static_cast<plumb_quantity>(below(10)), points(), pointer(X), number(),
                         pointer(values), pointer(weights), maybe(&norms)));
  }
  void fit() {
    const auto h = numbers(), e = numbers();
    const double declared = number();
    plumb_fit result;
    std::array<double, room> pairwise;
    const plumb_status status =
        plumb_fit_order(below(room), pointer(h), pointer(e), number(), below(2) ? &declared : nullptr,
                        maybe(&result), maybe(pairwise.data()));
    answered(status);
  }
  void extrapolate() {
    const auto h = numbers(), v = numbers();
    const double declared = number();
    plumb_extrapolation result;
    std::array<double, room> gci, absolute;
    answered(plumb_extrapolate(below(room), pointer(h), pointer(v), number(), below(2) ? &declared : nullptr,
                               maybe(&result), maybe(gci.data()), maybe(absolute.data())));
  }
  void box() {
    std::array<double, 3> origin, size;
    std::array<int, room> inside;
    double period = 0;
    const auto X = numbers();
    answered(plumb_box(solution(), maybe(origin.data()), maybe(size.data())));
    answered(plumb_period(solution(), maybe(&period)));
    answered(plumb_contains(solution(), points(), pointer(X), maybe(inside.data())));
    plumb_dimension(solution());
    plumb_components(solution(), static_cast<plumb_quantity>(below(12)));
  }
  void catalogue() {
    const std::size_t far = below(3) ? below(100) : ~std::size_t{0};
    plumb_parameter parameter;
    EXPECT_EQ(plumb_solution_name(far) == nullptr, far >= plumb_solution_count());
    EXPECT_EQ(plumb_law_name(far) == nullptr, far >= plumb_law_count());
    plumb_solution_summary(far);
    plumb_solution_exists_in(far, integer());
    plumb_law_has_history(far);
    answered(plumb_solution_parameter(far, below(5), maybe(&parameter)));
    answered(plumb_law_parameter(far, below(5), maybe(&parameter)));
    plumb_solution_parameter_count(far);
    plumb_law_parameter_count(far);
    EXPECT_NE(plumb_meaning(name()), nullptr);
  }

  std::mt19937_64 random_;
  plumb_solution* solution_ = nullptr;
};

// Found by the test below: a quotient of spacings that overflows.
TEST(CInterface, ExtrapolatesOverAnyRatioOfSpacings) {
  const std::array<double, 3> spacings{1e300, 1, 5e-324}, values{3, 1.5, 1};
  plumb_extrapolation result;
  ASSERT_EQ(plumb_extrapolate(3, spacings.data(), values.data(), 1.25, nullptr, &result, nullptr, nullptr),
            PLUMB_OK)
      << plumb_message();
  // (e^(p s) - 1)/(1 - e^(-p r)) = 3 with s = ln 1e300 = 690.8, r = -ln 5e-324 = 744.4: p = 1.86e-3
  EXPECT_STREQ(result.behaviour, "monotone");
  const double s = 300 * std::log(10.0), r = -std::log(5e-324);
  EXPECT_NEAR(std::expm1(result.order * s) / -std::expm1(-result.order * r), 3, 1e-9);
}

TEST(CInterface, AnswersAnyArguments) {
  const char* seconds = std::getenv("PLUMB_FUZZ_SECONDS");
  const double limit = seconds ? std::atof(seconds) : 0;
  const std::clock_t start = std::clock();
  long calls = 0;
  for (std::uint64_t seed = 1; !testing::Test::HasFailure(); ++seed) {
    Caller caller(seed);
    for (int n = 0; n < 200 && !testing::Test::HasFailure(); ++n, ++calls) caller.call();
    EXPECT_FALSE(testing::Test::HasFailure()) << "seed " << seed;
    const bool enough =
        seconds ? static_cast<double>(std::clock() - start) > limit * CLOCKS_PER_SEC : seed >= 100;
    if (enough) break;
  }
  if (seconds) std::printf("%ld calls in %g s of CPU time\n", calls, limit);
}

}  // namespace
}  // namespace plumb
