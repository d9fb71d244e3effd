#include "reports/theory/mathml.hpp"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <string_view>
#include <utility>

#include "reports/plot/svg_text.hpp"

namespace plumb::reports::theory {
namespace {

using Pair = std::pair<std::string_view, std::string_view>;

constexpr std::array<Pair, 15> greek{{{"alpha", "α"},
                                      {"beta", "β"},
                                      {"gamma", "γ"},
                                      {"Lambda", "Λ"},
                                      {"lambda", "λ"},
                                      {"kappa", "κ"},
                                      {"theta", "θ"},
                                      {"omega", "ω"},
                                      {"eta", "η"},
                                      {"phi", "φ"},
                                      {"psi", "ψ"},
                                      {"rho", "ρ"},
                                      {"mu", "μ"},
                                      {"nu", "ν"},
                                      {"pi", "π"}}};
constexpr std::array<Pair, 2> large{{{"sum", "∑"}, {"grad", "∇"}}};
/// Names of more than one letter that are no words.
constexpr std::array<std::string_view, 22> symbols{"dt",  "dW",  "dF",  "Dv",  "Dx",  "DE",  "vm",  "xm",
                                                   "sin", "cos", "max", "min", "tr",  "cof", "div", "lap",
                                                   "ij",  "ji",  "RHS", "WC",  "MPa", "rms"};
/// Signs of more than one character, the longer ones first.
constexpr std::array<Pair, 8> signs{{{"(x-product)", "×"},
                                     {"<=", "≤"},
                                     {">=", "≥"},
                                     {"!=", "≠"},
                                     {"<-", "←"},
                                     {"+=", "+="},
                                     {"-=", "−="},
                                     {"..", ".."}}};

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}
bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// Reads one line from left to right.
class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  std::string all() {
    std::string out;
    while (at_ < text_.size()) out += next();
    return out;
  }

 private:
  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
  char before() const { return at_ > 0 ? text_[at_ - 1] : ' '; }
  bool starts(std::string_view with) const { return text_.substr(at_).starts_with(with); }

  std::string next() {
    if (peek() == ' ') return spaces();
    if (is_letter(peek())) return word();
    if (is_digit(peek())) return number();
    return sign();
  }

  std::string spaces() {
    while (peek() == ' ') ++at_;
    return "<mspace width=\"0.2em\"/>";
  }

  std::string number() {
    const std::size_t from = at_;
    while (is_digit(peek()) || (peek() == '.' && is_digit(peek(1)))) ++at_;
    if (peek() == 'e' && (is_digit(peek(1)) || (peek(1) == '-' && is_digit(peek(2))))) {
      at_ += 2;
      while (is_digit(peek())) ++at_;
    }
    if (peek() == 'D' && !is_letter(peek(1))) {  // 1D, 2D, 3D
      ++at_;
      return "<mtext>" + std::string(text_.substr(from, at_ - from)) + "</mtext>";
    }
    return scripts("<mn>" + std::string(text_.substr(from, at_ - from)) + "</mn>");
  }

  /// The letters, digits and marks of a name or a word; "B-spline" is one word.
  std::string_view take_word() {
    const std::size_t from = at_;
    while (is_letter(peek()) || is_digit(peek())) ++at_;
    while (peek() == '-' && is_letter(peek(1)) && is_letter(peek(2))) {
      ++at_;
      while (is_letter(peek())) ++at_;
    }
    return text_.substr(from, at_ - from);
  }

  std::string word() {
    const bool after_word = before() == ' ' && last_was_word_;
    const std::string_view name = take_word();
    last_was_word_ = false;
    if (name == "sqrt") return root();
    for (const auto& [key, value] : large)
      if (name == key) return scripts(fmt::format("<mo>{}</mo>", value));
    if (is_prose(name, after_word)) {
      last_was_word_ = true;
      return "<mtext>" + std::string(name) + "</mtext>";
    }
    std::string shown(name);
    for (const auto& [key, value] : greek)
      if (name.starts_with(key) &&
          name.find_first_not_of("0123456789", key.size()) == std::string_view::npos) {
        shown = std::string(value) + std::string(name.substr(key.size()));
        break;
      }
    const std::string mark = marks();
    if (name.size() == 1 && !mark.empty() && mark != "\u0303")  // apart, so that the letter stays slanted
      return scripts("<mrow><mi>" + shown + "</mi><mtext>" + mark + "</mtext></mrow>");
    if (name.size() > 1 && is_letter(name[0]) &&
        name.find_first_not_of("0123456789", 1) == std::string_view::npos)
      return scripts(fmt::format("<mrow><mi>{}</mi><mn>{}</mn></mrow>", name.substr(0, 1), name.substr(1)));
    return scripts("<mi>" + shown + mark + "</mi>");
  }

  /// A word of the language: not a name with an index, not the name of a function or a symbol.
  bool is_prose(std::string_view name, bool after_word) const {
    if (peek() == '_' || peek() == '^' || peek() == '\'' || peek() == '~') return false;
    if (name == "a" && peek() == ' ' && is_letter(peek(1)) && is_letter(peek(2))) return true;
    if (name.size() == 1 || name.find_first_of("0123456789") != std::string_view::npos) return false;
    for (const auto& [key, value] : greek)
      if (name == key) return false;
    for (const auto& symbol : symbols)
      if (name == symbol) return false;
    return after_word || peek() != '(' || name.size() > 2;
  }

  /// Primes, stars and tildes behind a name, and "t+" for its positive part.
  std::string marks() {
    std::string out;
    for (;; ++at_) {
      if (peek() == '\'')
        out += "′";
      else if (peek() == '*')
        out += "*";
      else if (peek() == '~')
        out += "\u0303";
      else if (peek() == '+' && peek(1) == ' ')
        out += "+";
      else
        return out;
    }
  }

  std::string root() {
    if (peek() == '(') return "<msqrt>" + bracketed('(', ')') + "</msqrt>";
    while (peek() == ' ') ++at_;
    return "<msqrt>" + next() + "</msqrt>";
  }

  /// What stands between the brackets that open here, without them.
  std::string bracketed(char open, char close) {
    const std::size_t from = ++at_;
    for (int depth = 1; at_ < text_.size(); ++at_) {
      depth += peek() == open ? 1 : peek() == close ? -1 : 0;
      if (depth == 0) break;
    }
    const std::string inside = Reader(text_.substr(from, at_ - from)).all();
    ++at_;
    return "<mrow>" + inside + "</mrow>";
  }

  /// What stands lowered or raised: a name, a number, or what is in brackets.
  std::string script() {
    ++at_;
    if (peek() == '{') return bracketed('{', '}');
    if (peek() == '(') return bracketed('(', ')');
    std::string minus;
    if (peek() == '-') ++at_, minus = "<mo>−</mo>";
    const std::size_t from = at_;
    while (is_letter(peek()) || is_digit(peek())) ++at_;
    const std::string name(text_.substr(from, at_ - from));
    for (const auto& [key, value] : greek)
      if (name == key) return "<mrow>" + minus + "<mi>" + std::string(value) + "</mi></mrow>";
    const char* element = !name.empty() && is_digit(name[0]) ? "mn" : "mi";
    return fmt::format("<mrow>{}<{}>{}</{}></mrow>", minus, element, name, element);
  }

  std::string scripts(const std::string& base) {
    const std::string low = peek() == '_' ? script() : "";
    const std::string high = peek() == '^' ? script() : "";
    if (low.empty() && high.empty()) return base;
    if (high.empty()) return "<msub>" + base + low + "</msub>";
    if (low.empty()) return "<msup>" + base + high + "</msup>";
    return "<msubsup>" + base + low + high + "</msubsup>";
  }

  std::string sign() {
    for (const auto& [key, value] : signs)
      if (starts(key)) {
        at_ += key.size();
        return fmt::format("<mo>{}</mo>", value);
      }
    if (before() == ' ' && starts("(x) ")) {
      at_ += 3;
      return "<mo>⊗</mo>";
    }
    if (before() == ' ' && starts(". ")) {
      ++at_;
      return "<mo>·</mo>";
    }
    const char c = peek();
    ++at_;
    if (c == '\'') return "<mo>′</mo>";
    const std::string shown = c == '-' ? "−" : plot::escaped(std::string(1, c));
    if (c == ')' && peek() == '+' && peek(1) == '^') {  // positive part
      ++at_;
      return "<msubsup><mo stretchy=\"false\">)</mo><mo>+</mo>" + script() + "</msubsup>";
    }
    if (c == '.') return "<mtext>.</mtext>";
    const bool fence = std::string_view("()[]{}|").find(c) != std::string_view::npos;
    return scripts("<mo" + std::string(fence ? " stretchy=\"false\">" : ">") + shown + "</mo>");
  }

  std::string_view text_;
  std::size_t at_ = 0;
  bool last_was_word_ = false;
};

}  // namespace

std::string mathml(const std::string& line) {
  return fmt::format("<math alttext=\"{}\">{}</math>", plot::escaped(line), Reader(line).all());
}

}  // namespace plumb::reports::theory
