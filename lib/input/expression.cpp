#include "lib/input/expression.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <mutex>
#include <numbers>
#include <vector>

#include "lib/core/error.hpp"
#include "lib/input/spelling.hpp"

namespace plumb {

/// muParser reads its variables through pointers, so one evaluation at a time.
struct Expression::Compiled {
  std::string text, where;
  int dimension = 3;
  bool uses_time = false;
  mutable std::array<double, 3> X{};
  mutable double time = 0;
  mutable mu::Parser parser;
  mutable std::mutex in_use;

  std::string prefix() const { return where.empty() ? "" : where + ": "; }
};

namespace {

constexpr std::array<const char*, 3> coordinates{"X", "Y", "Z"};

std::string known_variables(int dimension, Variables variables) {
  if (dimension == 0) return "t";
  const std::string space = dimension == 1 ? "X" : dimension == 2 ? "X, Y" : "X, Y, Z";
  return variables == Variables::space ? space : space + ", t";
}

std::string suggestion_for(const std::string& name, int dimension, const mu::Parser& parser) {
  if (dimension > 0 && (name == "x" || name == "y" || name == "z"))
    return "capital letters stand for the reference coordinates";
  if (name == "t" || name == "T" || name == "time")
    return parser.GetVar().contains("t") ? "write t for the time" : "what it says holds for the whole run";
  if (dimension > 0 && (name == "Z" || name == "Y")) return fmt::format("the dimension is {}", dimension);
  std::vector<std::string> known;
  for (const auto& entry : parser.GetVar()) known.push_back(entry.first);
  for (const auto& entry : parser.GetConst()) known.push_back(entry.first);
  for (const auto& entry : parser.GetFunDef()) known.push_back(entry.first);
  const std::string near = nearest_name(name, known);
  return near.empty() ? "" : fmt::format("did you mean \"{}\"?", near);
}

/// The name or sign that starts at `position`, for messages.
std::string token_at(const std::string& text, std::size_t position) {
  std::size_t end = position;
  while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) || text[end] == '_'))
    ++end;
  return text.substr(position, std::max<std::size_t>(end - position, 1));
}

InputError syntax_error(const std::string& prefix, const std::string& text, int dimension,
                        Variables variables, const mu::Parser& parser,
                        const mu::Parser::exception_type& error) {
  const std::string in = fmt::format("{}in \"{}\"", prefix, text);
  if (error.GetCode() == mu::ecEMPTY_EXPRESSION)
    return {in + ": the formula is empty", "", "write \"0\" for zero"};
  const int at = error.GetPos();
  const auto position = static_cast<std::size_t>(std::max(at, 0));
  if (error.GetCode() == mu::ecUNASSIGNABLE_TOKEN && position < text.size()) {
    const std::string token = token_at(text, position);
    const bool is_name = std::isalpha(static_cast<unsigned char>(token[0])) || token[0] == '_';
    const std::string problem =
        fmt::format("{} \"{}\" at position {}", is_name ? "unknown name" : "unexpected", token, position + 1);
    return {in + ": " + problem,
            fmt::format("known: {}, pi and functions such as sin", known_variables(dimension, variables)),
            suggestion_for(token, dimension, parser)};
  }
  std::string message = error.GetMsg();
  if (!message.empty()) message[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(message[0])));
  const auto tail = message.find(" found at position");
  if (tail != std::string::npos) message.resize(tail);
  const auto place = message.find(" at position");
  if (place != std::string::npos) message.resize(place);
  return {fmt::format("{}: {} at position {}", in, message, position + 1), "it is not a formula", ""};
}

/// muParser would let a formula change X.
void refuse_assignment(const std::string& prefix, const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '=') continue;
    if (i + 1 < text.size() && text[i + 1] == '=') {
      ++i;
      continue;
    }
    if (i > 0 && (text[i - 1] == '<' || text[i - 1] == '>' || text[i - 1] == '!')) continue;
    throw InputError(fmt::format(R"({}in "{}": assignment "=" at position {})", prefix, text, i + 1),
                     "a formula cannot change X, Y, Z", "write == to compare");
  }
}

}  // namespace

Expression::Expression(std::string text, int dimension, std::string where, Variables variables) {
  auto compiled = std::make_shared<Compiled>();
  compiled->text = std::move(text);
  compiled->where = std::move(where);
  compiled->dimension = dimension;
  refuse_assignment(compiled->prefix(), compiled->text);
  mu::Parser& parser = compiled->parser;
  for (int k = 0; k < dimension; ++k)
    parser.DefineVar(coordinates[static_cast<std::size_t>(k)], &compiled->X[static_cast<std::size_t>(k)]);
  if (variables == Variables::space_and_time) parser.DefineVar("t", &compiled->time);
  parser.DefineConst("pi", std::numbers::pi);
  int results = 0;
  try {
    parser.SetExpr(compiled->text);
    parser.Eval(results);
  } catch (const mu::Parser::exception_type& error) {
    throw syntax_error(compiled->prefix(), compiled->text, dimension, variables, parser, error);
  }
  if (const auto corrected = without_decimal_comma(compiled->text))
    throw InputError(fmt::format("{}in \"{}\": a decimal comma", compiled->prefix(), compiled->text),
                     "decimals follow a point", fmt::format("write \"{}\"", *corrected));
  if (results != 1)
    throw InputError(fmt::format("{}in \"{}\": {} values", compiled->prefix(), compiled->text, results),
                     "a formula has one", "write an array of formulas");
  compiled->uses_time = parser.GetUsedVar().contains("t");
  compiled_ = std::move(compiled);
}

Expression Expression::constant(double value) {
  return Expression(fmt::format("{:.17g}", value));
}

double Expression::at(const std::array<double, 3>& X, double time) const {
  double value = 0.0;
  {
    const std::lock_guard lock(compiled_->in_use);
    compiled_->X = X;
    compiled_->time = time;
    value = compiled_->parser.Eval();
  }
  if (std::isfinite(value)) return value;
  std::string point;
  for (int k = 0; k < compiled_->dimension; ++k)
    point += fmt::format("{}{:.6g}", k ? ", " : "", X[static_cast<std::size_t>(k)]);
  if (compiled_->uses_time) point += fmt::format("{}t = {:.6g}", point.empty() ? "" : ", ", time);
  throw InputError(fmt::format("{}in \"{}\": the value at ({}) is {}", compiled_->prefix(), compiled_->text,
                               point, std::isnan(value) ? "not a number" : "infinite"),
                   "division by zero, or a function outside its domain", "change the formula there");
}

bool Expression::uses_time() const {
  return compiled_->uses_time;
}

const std::string& Expression::text() const {
  return compiled_->text;
}

}  // namespace plumb
