#include "reports/plot/axes.hpp"

#include <fmt/format.h>

#include <cmath>

namespace plumb::reports::plot {
namespace {

/// 1, 2, 5, 10, .. within the range.
std::vector<double> one_two_five(const Range& range) {
  std::vector<double> ticks;
  for (int decade = static_cast<int>(std::floor(std::log10(range.low))); std::pow(10.0, decade) <= range.high;
       ++decade)
    for (double digit : {1.0, 2.0, 5.0}) {
      const double value = digit * std::pow(10.0, decade);
      if (value >= range.low * (1 - 1e-12) && value <= range.high * (1 + 1e-12)) ticks.push_back(value);
    }
  return ticks;
}

/// A step of 1, 2 or 5 times a power of ten that divides the range into at most six parts.
double nice_step(const Range& range) {
  const double rough = (range.high - range.low) / 6;
  const double decade = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double digit : {1.0, 2.0, 5.0})
    if (digit * decade >= rough) return digit * decade;
  return 10 * decade;
}

std::string explicit_ticks(const std::string& name, const std::vector<double>& ticks) {
  std::string list;
  for (double value : ticks)
    list += fmt::format("{}\"{}\" {:.12g}", list.empty() ? "" : ", ", tick_text(value), value);
  return fmt::format("set {}tics ({})\n", name, list);
}

}  // namespace

std::string literal(const std::string& text) {
  std::string out = "\"";
  for (char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (c == '\n')
      out += "\\n";
    else if (c == '`')
      out += '\'';
    else if (static_cast<unsigned char>(c) >= 0x20)
      out += c;
  }
  return out + "\"";
}

std::string with_unit(const std::string& label, const std::string& unit) {
  return unit.empty() || unit == "1" ? label : label + " [" + unit + "]";
}

std::string tick_text(double value) {
  const double size = std::abs(value);
  if (size >= 1e4 && size < 0.999e5) return fmt::format("{:.0f}", value);
  if (value == 0 || (size >= 0.999e-3 && size < 1e4)) return fmt::format("{:.4g}", value);
  const std::string text = fmt::format("{:.3e}", value);
  const auto e = text.find('e');
  std::string digits = text.substr(0, e);
  while (digits.back() == '0') digits.pop_back();
  if (digits.back() == '.') digits.pop_back();
  const int exponent = std::stoi(text.substr(e + 1));
  return digits == "1" ? fmt::format("10^{{{}}}", exponent) : fmt::format("{}·10^{{{}}}", digits, exponent);
}

std::string axis_commands(const std::string& name, const Range& range, const std::vector<double>& ticks) {
  std::string out = fmt::format("set {}range [{:.12g}:{:.12g}]\n", name, range.low, range.high);
  if (range.log) out += fmt::format("set logscale {}\n", name);
  if (!ticks.empty()) return out + explicit_ticks(name, ticks);
  if (!range.log) return out + fmt::format("set {}tics {:.12g}\n", name, nice_step(range));
  const double decades = std::log10(range.high / range.low);
  if (decades < 2.2) return out + explicit_ticks(name, one_two_five(range));
  const int step = static_cast<int>(std::ceil(decades / 9));
  return out + fmt::format("set {0}tics 1e{1} format \"10^{{%T}}\"\nset m{0}tics {2}\n", name, step,
                           step == 1 ? 10 : 1);
}

}  // namespace plumb::reports::plot
