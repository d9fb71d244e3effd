// Solutions as source text: compiled or run as they stand, and compared with the derivations that the studies
// use.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <random>
#include <sstream>

#include "lib/core/dimension.hpp"
#include "lib/material/laws.hpp"
#include "mms/exact_fields.hpp"
#include "mms/export/formulas_of.hpp"
#include "mms/export/source_text.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb::mms {
namespace {

const Elastic elastic{2e6, 0.3, 1200};

struct Case {
  std::string solution, law;
  int dimension;
  std::string function;  ///< of its own: case_17
};

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  for (const SolutionEntry& entry : solution_list())
    for (const std::string& law : names_of(ElasticLaws{}))
      for (const int d : entry.dimensions)
        cases.push_back({entry.name, law, d, "case_" + std::to_string(cases.size())});
  return cases;
}

/// The text of a case, its function renamed.
std::string text_of(const Case& one, const std::string& language) {
  std::string text = source_text(language, one.solution, one.dimension, {}, elastic, LawChoice(one.law));
  std::string name = one.solution;
  std::replace(name.begin(), name.end(), '-', '_');
  const std::size_t at = text.find(" " + name + "(");
  EXPECT_NE(at, std::string::npos);
  return text.replace(at + 1, name.size(), one.function);
}

/// u, v, a, F, P, b at a point, one after the other.
using Function = void (*)(const double* X, const double* t, double* u, double* v, double* a, double* F,
                          double* P, double* b);

template <int d>
void compare(const Case& one, const std::function<void(const double*, double, double*)>& function) {
  const ExactFields<d> exact = exact_fields<d>(one.solution, {}, elastic, LawChoice(one.law));
  std::mt19937_64 random(7);
  for (int n = 0; n < 5; ++n) {
    Vec<d> X;
    do
      for (int a = 0; a < d; ++a)
        X[a] = exact.domain.box.origin[a] +
               std::uniform_real_distribution(0.0, 1.0)(random) * exact.domain.box.size[a];
    while (!exact.domain.contains(X));
    const double t = std::uniform_real_distribution(0.0, 2.0)(random) * exact.period;
    std::vector<double> all(4 * d + 2 * d * d, NAN);
    function(X.data(), t, all.data());
    const double* at = all.data();
    const Motion<d> m = exact.motion(X, t);
    const auto expect = [&](const auto& right, double scale, const char* what) {
      for (int i = 0; i < right.rows(); ++i)
        for (int A = 0; A < right.cols();
             ++A, ++at)  // three derivations: round-off of some hundred operations
          EXPECT_NEAR(*at, right(i, A), 1e-12 * scale)
              << one.solution << ' ' << one.law << ' ' << d << "D " << what;
    };
    double bend = 0;
    for (const Mat<d>& part : m.dF) bend += part.norm();
    expect(m.displacement, 1, "u");
    expect(m.velocity, 10 / exact.period, "v");
    expect(m.acceleration, 100 / (exact.period * exact.period), "a");
    expect(m.F, 1, "F");
    const Mat<d> P = exact.first_piola(X, t);
    expect(P, elastic.young, "P");
    expect(exact.body_force(X, t), elastic.young * (10 + bend) + elastic.density * m.acceleration.norm(),
           "b");
  }
}

void compare(const Case& one, const std::function<void(const double*, double, double*)>& function) {
  with_dimension(one.dimension, [&]<int d>() { compare<d>(one, function); });
}

/// Compiles all cases into one shared library and compares each; `mark` is what the compiler adds to names.
void compiled(const std::string& language, const std::string& ending, const std::string& compiler,
              const std::string& mark, bool by_reference) {
  const test::TemporaryFolder folder;
  const std::string source = (folder / ("all" + ending)).string(), library = (folder / "all.so").string();
  {
    std::ofstream file(source);
    for (const Case& one : all_cases()) file << text_of(one, language) << '\n';
  }
  ASSERT_EQ(std::system((compiler + " -O0 -shared -fPIC -o " + library + " " + source + " -lm").c_str()), 0);
  void* loaded = dlopen(library.c_str(), RTLD_NOW);
  ASSERT_NE(loaded, nullptr) << dlerror();
  for (const Case& one : all_cases()) {
    void* symbol = dlsym(loaded, (one.function + mark).c_str());
    ASSERT_NE(symbol, nullptr) << one.function;
    compare(one, [&](const double* X, double t, double* out) {
      const int d = one.dimension;
      double* const places[] = {
          out, out + d, out + 2 * d, out + 3 * d, out + 3 * d + d * d, out + 3 * d + 2 * d * d};
      if (by_reference)
        reinterpret_cast<Function>(symbol)(X, &t, places[0], places[1], places[2], places[3], places[4],
                                           places[5]);
      else
        reinterpret_cast<void (*)(const double*, double, double*, double*, double*, double*, double*,
                                  double*)>(symbol)(X, t, places[0], places[1], places[2], places[3],
                                                    places[4], places[5]);
    });
  }
  dlclose(loaded);
}

TEST(Export, CTextsAreTheSolutions) {
  compiled("c", ".c", "cc -std=c99 -Wall -Wextra -Werror", "", false);
}

TEST(Export, FortranTextsAreTheSolutions) {
  if (std::system("gfortran --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "there is no Fortran compiler";
  compiled("fortran", ".f90", "gfortran -std=f2008", "_", true);
}

TEST(Export, PythonTextsAreTheSolutions) {
  const test::TemporaryFolder folder;
  const auto cases = all_cases();
  {
    std::ofstream file(folder / "all.py");
    for (const Case& one : cases) file << text_of(one, "python") << '\n';
    // numbers in, numbers out: a name, t and X a line
    file << "import sys\nfor line in sys.stdin:\n    name, t, *X = line.split()\n"
            "    parts = globals()[name]([float(x) for x in X], float(t))\n"
            "    print(*[repr(float(x)) for part in parts for x in part], flush=True)\n";
  }
  // first all questions, then one run, then all answers
  std::ofstream questions(folder / "questions");
  for (const Case& one : cases)
    compare(one, [&](const double* X, double t, double* out) {
      questions << one.function << ' ' << std::setprecision(17) << t;
      for (int a = 0; a < one.dimension; ++a) questions << ' ' << X[a];
      questions << '\n';
      // filled with the right values below; here the exact ones, so that this pass says nothing
      const auto fill = [&]<int d>() {
        const ExactFields<d> exact = exact_fields<d>(one.solution, {}, elastic, LawChoice(one.law));
        const Vec<d> at = Eigen::Map<const Vec<d>>(X);
        const Motion<d> m = exact.motion(at, t);
        const auto put = [&](const auto& value) {
          for (int i = 0; i < value.rows(); ++i)
            for (int A = 0; A < value.cols(); ++A) *out++ = value(i, A);
        };
        put(m.displacement), put(m.velocity), put(m.acceleration), put(m.F);
        put(exact.first_piola(at, t)), put(exact.body_force(at, t));
      };
      with_dimension(one.dimension, fill);
    });
  questions.close();
  const std::string in = folder.path().string();
  ASSERT_EQ(std::system(
                ("/usr/bin/python3 -B " + in + "/all.py <" + in + "/questions >" + in + "/answers").c_str()),
            0);
  std::ifstream answers(folder / "answers");
  for (const Case& one : cases)
    compare(one, [&](const double*, double, double* out) {
      std::string line;
      std::getline(answers, line);
      std::istringstream numbers(line);
      for (int k = 0; k < 4 * one.dimension + 2 * one.dimension * one.dimension; ++k) numbers >> out[k];
    });
}

TEST(Export, WhatCannotBeWrittenIsRefused) {
  EXPECT_THROW(source_text("cobol", "swinging-plate", 2, {}, elastic, LawChoice("neo-hookean")), InputError);
  EXPECT_THROW(source_text("c", "swinging-plate", 3, {}, elastic, LawChoice("neo-hookean")), InputError);
  EXPECT_THROW(source_text("c", "swinging-plate", 2, {{"amplitude", 9}}, elastic, LawChoice("neo-hookean")),
               InputError);
  EXPECT_THROW(
      source_text("c", "swinging-plate", 2, {}, elastic, LawChoice("j2-logarithmic", {{"yield", 1e6}})),
      InputError);
  EXPECT_THROW(
      source_text("c", "swinging-plate", 2, {}, elastic, LawChoice("neo-hookean", {}, Plane::stress)),
      InputError);
}

// d/dx of (x sin x)/sqrt(x) by hand: the rules of all operations that the catalogue uses.
TEST(Export, DerivativesOfOperations) {
  Formulas list;
  const Written x(list, list.variable(0));
  const Written f = x * sin(x) / sqrt(x) - reciprocal_cbrt(x) * cos(Written(2.0) * x) + x * log(x);
  const int slope = list.derivative(f.in(list), 0);
  std::vector<double> values(1000);
  const double at = 0.7;
  for (const int term : list.needed({slope})) {
    const Term& t = list[term];
    const auto value = [&](int place) { return values[static_cast<std::size_t>(place)]; };
    double v = t.op == Term::Op::variable ? at : t.value;
    if (t.op == Term::Op::sum) v = value(t.a) + value(t.b);
    if (t.op == Term::Op::difference) v = value(t.a) - value(t.b);
    if (t.op == Term::Op::product) v = value(t.a) * value(t.b);
    if (t.op == Term::Op::quotient) v = value(t.a) / value(t.b);
    if (t.op == Term::Op::negative) v = -value(t.a);
    if (t.op == Term::Op::sine) v = std::sin(value(t.a));
    if (t.op == Term::Op::cosine) v = std::cos(value(t.a));
    if (t.op == Term::Op::root) v = std::sqrt(value(t.a));
    if (t.op == Term::Op::inverse_cube_root) v = 1 / std::cbrt(value(t.a));
    if (t.op == Term::Op::logarithm) v = std::log(value(t.a));
    values[static_cast<std::size_t>(term)] = v;
  }
  const double right = 0.5 / std::sqrt(at) * std::sin(at) + std::sqrt(at) * std::cos(at) +
                       std::pow(at, -4.0 / 3) / 3 * std::cos(2 * at) + 2 * std::sin(2 * at) / std::cbrt(at) +
                       std::log(at) + 1;
  EXPECT_NEAR(values[static_cast<std::size_t>(slope)], right, 1e-14);
}

}  // namespace
}  // namespace plumb::mms
