#include "mms/export/source_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lib/core/error.hpp"
#include "mms/export/formulas_of.hpp"

namespace plumb::mms {
namespace {

/// How a language writes what the formulas need.
struct Language {
  std::string_view comment, assignment, inverse_cube_root;
  bool fortran = false;  ///< exponents with d, no constants without a point
  int first = 0;         ///< number of the first entry of an array
  char open = '[', close = ']';
};

Language language_of(std::string_view name) {
  if (name == "c") return {"//", "  const double t{} = {};\n", "1.0 / cbrt({})"};
  if (name == "fortran") return {"!", "  t{} = {}\n", "({})**(-1.0d0/3.0d0)", true, 1, '(', ')'};
  if (name == "python") return {"#", "    t{} = {}\n", "({}) ** (-1.0 / 3.0)"};
  throw unknown_name("language", name, {std::begin(source_languages), std::end(source_languages)});
}

class Writer {
 public:
  Writer(const Formulas& list, const Language& language, int dimension)
      : list_(list), language_(language), dimension_(dimension) {}

  /// One line for each operation that the outputs need, then one for each entry of an output.
  std::string body(const std::vector<std::pair<std::string, const std::vector<int>*>>& outputs) const {
    std::vector<int> all;
    for (const auto& entry : outputs) all.insert(all.end(), entry.second->begin(), entry.second->end());
    std::string text;
    for (const int term : list_.needed(all))
      if (!is_leaf(term)) text += fmt::format(fmt::runtime(language_.assignment), term, operation(term));
    return text;
  }
  std::string operand(int term) const {
    const Term& t = list_[term];
    if (t.op == Term::Op::constant) return number(t.value);
    if (t.op != Term::Op::variable) return fmt::format("t{}", term);
    if (t.variable == dimension_) return "t";
    return fmt::format("X{}{}{}", language_.open, t.variable + language_.first, language_.close);
  }
  bool is_leaf(int term) const {
    return list_[term].op == Term::Op::constant || list_[term].op == Term::Op::variable;
  }

 private:
  std::string number(double value) const {
    std::string text = fmt::format("{:.17g}", value);
    if (language_.fortran) {
      std::replace(text.begin(), text.end(), 'e', 'd');
      if (text.find('d') == std::string::npos) text += "d0";
    } else if (text.find_first_of(".e") == std::string::npos) {
      text += ".0";
    }
    return value < 0 ? "(" + text + ")" : text;
  }
  std::string operation(int term) const {
    const Term& t = list_[term];
    const std::string a = operand(t.a), b = t.b < 0 ? "" : operand(t.b);
    switch (t.op) {
      case Term::Op::sum:
        return a + " + " + b;
      case Term::Op::difference:
        return a + " - " + b;
      case Term::Op::product:
        return a + " * " + b;
      case Term::Op::quotient:
        return a + " / " + b;
      case Term::Op::negative:
        return "-" + a;
      case Term::Op::sine:
        return "sin(" + a + ")";
      case Term::Op::cosine:
        return "cos(" + a + ")";
      case Term::Op::root:
        return "sqrt(" + a + ")";
      case Term::Op::inverse_cube_root:
        return fmt::format(fmt::runtime(language_.inverse_cube_root), a);
      case Term::Op::logarithm:
        return "log(" + a + ")";
      case Term::Op::constant:
      case Term::Op::variable:
        break;
    }
    return a;
  }

  const Formulas& list_;
  const Language& language_;
  int dimension_;
};

using Outputs = std::vector<std::pair<std::string, const std::vector<int>*>>;

std::string heading(const Language& language, const std::string& about, int d) {
  std::string text;
  const auto line = [&](const std::string& words) {
    text += fmt::format("{} {}\n", language.comment, words);
  };
  line("Manufactured solution, written by Plumbline: " + about + ".");
  line(fmt::format("X: reference position [m], {} numbers; t: time [s]. SI units.", d));
  line(
      "u [m], v = u_t [m/s], a = u_tt [m/s^2], F = I + Grad u, "
      "P: first Piola-Kirchhoff stress [Pa] (F and P row by row),");
  line(
      "b = rho a - Div P per reference volume [N/m^3]: with "
      "this load u is the solution. Traction on a face: P N.");
  return text;
}

std::string c_text(const Writer& writer, const std::string& name, int d, const Outputs& outputs) {
  std::string text = "#include <math.h>\n\n";
  text += fmt::format("void {}(const double X[{}], double t", name, d);
  for (const auto& [key, terms] : outputs) text += fmt::format(", double {}[{}]", key, terms->size());
  text += ") {\n" + writer.body(outputs);
  for (const auto& [key, terms] : outputs)
    for (std::size_t k = 0; k < terms->size(); ++k)
      text += fmt::format("  {}[{}] = {};\n", key, k, writer.operand((*terms)[k]));
  return text + "  (void)X, (void)t;\n}\n";
}

std::string python_text(const Writer& writer, const std::string& name, const Outputs& outputs) {
  std::string text =
      "try:\n    from numpy import cos, log, sin, sqrt  # then X may hold arrays\nexcept ImportError:\n    from "
      "math import cos, log, sin, "
      "sqrt\n\n\n";
  text += fmt::format("def {}(X, t):\n    \"\"\"Returns u, v, a, F, P, b as lists of numbers.\"\"\"\n", name);
  text += writer.body(outputs) + "    return (";
  for (std::size_t n = 0; n < outputs.size(); ++n) {
    text += n == 0 ? "[" : ",\n            [";
    for (std::size_t k = 0; k < outputs[n].second->size(); ++k)
      text += (k == 0 ? "" : ", ") + writer.operand((*outputs[n].second)[k]);
    text += "]";
  }
  return text + ")\n";
}

/// Declarations of the temporary numbers, some in a line: lines have at most 132 characters.
std::string declarations(const Formulas& list, const Writer& writer, const std::vector<int>& outputs) {
  std::string text, line;
  for (const int term : list.needed(outputs)) {
    if (writer.is_leaf(term)) continue;
    line += fmt::format("{}t{}", line.empty() ? "" : ", ", term);
    if (line.size() < 90) continue;
    text += "  real(kind(1.0d0)) :: " + line + "\n";
    line.clear();
  }
  return line.empty() ? text : text + "  real(kind(1.0d0)) :: " + line + "\n";
}

std::string fortran_text(const Formulas& list, const Writer& writer, const std::string& name, int d,
                         const Outputs& outputs) {
  std::string text = fmt::format("pure subroutine {}(X, t, u, v, a, F, P, b)\n  implicit none\n", name);
  text += fmt::format("  real(kind(1.0d0)), intent(in) :: X({}), t\n", d);
  std::vector<int> all;
  for (const auto& [key, terms] : outputs) {
    text += fmt::format("  real(kind(1.0d0)), intent(out) :: {}({})\n", key, terms->size());
    all.insert(all.end(), terms->begin(), terms->end());
  }
  text += declarations(list, writer, all) + writer.body(outputs);
  for (const auto& [key, terms] : outputs)
    for (std::size_t k = 0; k < terms->size(); ++k)
      text += fmt::format("  {}({}) = {}\n", key, k + 1, writer.operand((*terms)[k]));
  return text + "end subroutine\n";
}

}  // namespace

std::string source_text(std::string_view language, std::string_view name, int dimension,
                        const std::map<std::string, double>& parameters, const Elastic& elastic,
                        const LawChoice& law) {
  const Language how = language_of(language);
  const SolutionFormulas formulas = formulas_of(name, dimension, parameters, elastic, law);
  const Outputs outputs{{"u", &formulas.u}, {"v", &formulas.v}, {"a", &formulas.a},
                        {"F", &formulas.F}, {"P", &formulas.P}, {"b", &formulas.b}};
  std::string about = fmt::format("{} in {}D, {}, E = {:.17g} Pa, nu = {:.17g}, rho = {:.17g} kg/m^3", name,
                                  dimension, law.name, elastic.young, elastic.poisson, elastic.density);
  for (const auto& [key, value] : law.parameters) about += fmt::format(", {} = {:.17g}", key, value);
  for (const auto& [key, value] : parameters) about += fmt::format(", {} = {:.17g}", key, value);
  std::string function(name);
  std::replace(function.begin(), function.end(), '-', '_');
  const Writer writer(formulas.list, how, dimension);
  const std::string head = heading(how, about, dimension);
  if (language == "c") return head + c_text(writer, function, dimension, outputs);
  if (language == "python") return head + python_text(writer, function, outputs);
  return head + fortran_text(formulas.list, writer, function, dimension, outputs);
}

}  // namespace plumb::mms
