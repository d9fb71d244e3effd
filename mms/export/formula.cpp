#include "mms/export/formula.hpp"

#include <algorithm>
#include <cmath>

namespace plumb::mms {
namespace {

/// The value of an operation on numbers.
double computed(Term::Op op, double a, double b) {
  switch (op) {
    case Term::Op::sum:
      return a + b;
    case Term::Op::difference:
      return a - b;
    case Term::Op::product:
      return a * b;
    case Term::Op::quotient:
      return a / b;
    case Term::Op::negative:
      return -a;
    case Term::Op::sine:
      return std::sin(a);
    case Term::Op::cosine:
      return std::cos(a);
    case Term::Op::root:
      return std::sqrt(a);
    case Term::Op::inverse_cube_root:
      return 1 / std::cbrt(a);
    case Term::Op::logarithm:
      return std::log(a);
    case Term::Op::constant:
    case Term::Op::variable:
      break;
  }
  return a;
}

}  // namespace

int Formulas::find_or_add(const Term& term) {
  const auto key = std::tuple(static_cast<int>(term.op), term.a, term.b, term.value, term.variable);
  const auto [at, fresh] = places_.try_emplace(key, static_cast<int>(terms_.size()));
  if (fresh) terms_.push_back(term);
  return at->second;
}

int Formulas::constant(double value) {
  return find_or_add({Term::Op::constant, -1, -1, value == 0 ? 0.0 : value, 0});  // -0 is 0
}

int Formulas::variable(int number) {
  return find_or_add({Term::Op::variable, -1, -1, 0, number});
}

bool Formulas::is(int term, double value) const {
  const Term& t = (*this)[term];
  return t.op == Term::Op::constant && t.value == value;
}

int Formulas::make(Term::Op op, int a, int b) {
  using Op = Term::Op;
  const bool alone = b < 0;
  if ((*this)[a].op == Op::constant && (alone || (*this)[b].op == Op::constant))
    return constant(computed(op, (*this)[a].value, alone ? 0 : (*this)[b].value));
  if (op == Op::sum && is(a, 0)) return b;
  if ((op == Op::sum || op == Op::difference) && is(b, 0)) return a;
  if (op == Op::difference && is(a, 0)) return make(Op::negative, b);
  if (op == Op::difference && a == b) return constant(0);
  if (op == Op::product && (is(a, 0) || is(b, 0))) return constant(0);
  if (op == Op::product && is(a, 1)) return b;
  if ((op == Op::product || op == Op::quotient) && is(b, 1)) return a;
  if (op == Op::quotient && is(a, 0)) return a;
  if (op == Op::negative && (*this)[a].op == Op::negative) return (*this)[a].a;
  if ((op == Op::sum || op == Op::product) && a > b) std::swap(a, b);
  return find_or_add({op, a, b, 0, 0});
}

int Formulas::derivative(int term, int variable) {
  const auto known = derivatives_.find({term, variable});
  if (known != derivatives_.end()) return known->second;
  const Term copy = (*this)[term];  // the list grows below
  const int found = derivative_of(copy, term, variable);
  return derivatives_[{term, variable}] = found;
}

int Formulas::derivative_of(const Term& term, int place, int variable) {
  using Op = Term::Op;
  if (term.op == Op::constant) return constant(0);
  if (term.op == Op::variable) return constant(term.variable == variable ? 1 : 0);
  const int da = derivative(term.a, variable), db = term.b < 0 ? -1 : derivative(term.b, variable);
  switch (term.op) {
    case Op::sum:
    case Op::difference:
      return make(term.op, da, db);
    case Op::product:
      return make(Op::sum, make(Op::product, da, term.b), make(Op::product, term.a, db));
    case Op::quotient:  // (a' - (a/b) b')/b
      return make(Op::quotient, make(Op::difference, da, make(Op::product, place, db)), term.b);
    case Op::negative:
      return make(Op::negative, da);
    case Op::sine:
      return make(Op::product, make(Op::cosine, term.a), da);
    case Op::cosine:
      return make(Op::negative, make(Op::product, make(Op::sine, term.a), da));
    case Op::root:
      return make(Op::quotient, make(Op::product, constant(0.5), da), place);
    case Op::inverse_cube_root:
      return make(Op::quotient, make(Op::product, constant(-1.0 / 3), make(Op::product, place, da)), term.a);
    case Op::logarithm:
      return make(Op::quotient, da, term.a);
    case Op::constant:
    case Op::variable:
      break;
  }
  return constant(0);
}

std::vector<int> Formulas::needed(const std::vector<int>& outputs) const {
  std::vector<bool> wanted(terms_.size(), false);
  for (const int output : outputs) wanted[static_cast<std::size_t>(output)] = true;
  std::vector<int> all;
  for (int k = static_cast<int>(terms_.size()) - 1; k >= 0; --k) {  // operands stand before what they make
    if (!wanted[static_cast<std::size_t>(k)]) continue;
    all.push_back(k);
    for (const int operand : {(*this)[k].a, (*this)[k].b})
      if (operand >= 0) wanted[static_cast<std::size_t>(operand)] = true;
  }
  std::reverse(all.begin(), all.end());
  return all;
}

Written Written::both(Term::Op op, const Written& x, const Written& y) {
  Formulas* list = x.list != nullptr ? x.list : y.list;
  if (list == nullptr) return Written(computed(op, x.value, y.value));
  const int a = x.in(*list), b = y.in(*list);
  return {*list, list->make(op, a, b)};
}

Written Written::one(Term::Op op, const Written& x) {
  if (x.list == nullptr) return Written(computed(op, x.value, 0));
  return {*x.list, x.list->make(op, x.term)};
}

}  // namespace plumb::mms
