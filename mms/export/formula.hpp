#pragma once
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace plumb::mms {

/// One operation of a formula. The operands are places of earlier terms.
struct Term {
  enum class Op {
    constant,
    variable,
    sum,
    difference,
    product,
    quotient,
    negative,
    sine,
    cosine,
    root,
    inverse_cube_root,
    logarithm
  };
  Op op = Op::constant;
  int a = -1, b = -1;
  double value = 0;  ///< of a constant
  int variable = 0;  ///< number of a variable: 0 .. d-1 are X, d is t
};

/// Formulas as a list of operations, each written once: what is the same is the same term. Sums with 0 and
/// products with 0 and 1 are not written.
class Formulas {
 public:
  int constant(double value);
  int variable(int number);
  int make(Term::Op op, int a, int b = -1);
  /// The term that is the derivative of `term` by a variable.
  int derivative(int term, int variable);

  const Term& operator[](int term) const { return terms_[static_cast<std::size_t>(term)]; }
  /// The terms that the given ones need, operands first.
  std::vector<int> needed(const std::vector<int>& outputs) const;

 private:
  int find_or_add(const Term& term);
  int derivative_of(const Term& term, int place, int variable);
  bool is(int term, double value) const;

  std::vector<Term> terms_;
  std::map<std::tuple<int, int, int, double, int>, int> places_;
  std::map<std::pair<int, int>, int> derivatives_;
};

/// A number whose calculation is written down. Solutions and laws are templates on the number type: given
/// this one they write their own formulas. A constant needs no list until it meets a term.
struct Written {
  Formulas* list = nullptr;
  int term = -1;
  double value = 0;  ///< of a constant, where there is no list

  Written() = default;
  Written(double v) : value(v) {}  // NOLINT: constants mix with terms as numbers do
  Written(Formulas& formulas, int place) : list(&formulas), term(place) {}

  /// Its place in a list.
  int in(Formulas& formulas) const { return list != nullptr ? term : formulas.constant(value); }

  friend Written operator+(const Written& x, const Written& y) { return both(Term::Op::sum, x, y); }
  friend Written operator-(const Written& x, const Written& y) { return both(Term::Op::difference, x, y); }
  friend Written operator*(const Written& x, const Written& y) { return both(Term::Op::product, x, y); }
  friend Written operator/(const Written& x, const Written& y) { return both(Term::Op::quotient, x, y); }
  friend Written operator-(const Written& x) { return one(Term::Op::negative, x); }
  friend Written sin(const Written& x) { return one(Term::Op::sine, x); }
  friend Written cos(const Written& x) { return one(Term::Op::cosine, x); }
  friend Written sqrt(const Written& x) { return one(Term::Op::root, x); }
  friend Written reciprocal_cbrt(const Written& x) { return one(Term::Op::inverse_cube_root, x); }
  friend Written log(const Written& x) { return one(Term::Op::logarithm, x); }
  Written& operator+=(const Written& y) { return *this = *this + y; }
  Written& operator-=(const Written& y) { return *this = *this - y; }
  Written& operator*=(const Written& y) { return *this = *this * y; }

 private:
  static Written both(Term::Op op, const Written& x, const Written& y);
  static Written one(Term::Op op, const Written& x);
};

}  // namespace plumb::mms
