#include "lib/material/law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lib/core/error.hpp"

namespace plumb {

double allowed(const LawParameter& about, double value) {
  const auto refuse = [&](const char* why) {
    throw InputError(fmt::format("{} = {}", about.name, value), why, std::string(about.meaning));
  };
  if (std::isnan(value)) refuse("it is not a number");
  if (about.sign == Sign::positive && !(value > 0)) refuse("it must be positive");
  if (about.sign == Sign::not_negative && value < 0) refuse("it must not be negative");
  if (value > about.most) refuse("it is too large");
  return value;
}

void refuse_unknown_parameters(const LawChoice& choice, const std::vector<std::string>& known) {
  for (const auto& entry : choice.parameters)
    if (std::find(known.begin(), known.end(), entry.first) == known.end())
      throw unknown_name("parameter of " + choice.name, entry.first, known);
}

void refuse_missing(const LawChoice& choice, const LawParameter& about) {
  throw InputError(fmt::format("{} without {}", choice.name, about.name), std::string(about.meaning),
                   fmt::format("give {}", about.name));
}

}  // namespace plumb
