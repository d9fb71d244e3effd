#pragma once
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "lib/core/error.hpp"

namespace plumb::mms {

/// One parameter of a manufactured solution.
struct Parameter {
  std::string_view name;
  double value;           ///< default
  std::string_view unit;  ///< "m", "rad", "1" ..
  double least, most;     ///< allowed range, ends included; `plumb mms --check` draws from it
  std::string_view meaning;
};

/// The parameters of one solution, in the order of its declaration.
class Parameters {
 public:
  Parameters(std::initializer_list<Parameter> list) : list_(list) {}

  const std::vector<Parameter>& all() const { return list_; }
  /// Value by name; the name must be one of the solution's own.
  double operator[](std::string_view name) const { return list_[find(name)].value; }
  /// Sets a value. InputError for an unknown name (with the nearest one) and for a value out of range.
  void set(std::string_view name, double value) {
    Parameter& p = list_[find(name)];
    if (!(value >= p.least && value <= p.most))
      throw InputError("parameter " + std::string(name) + " = " + std::to_string(value) + " is out of range",
                       std::string(p.meaning),
                       "Choose between " + std::to_string(p.least) + " and " + std::to_string(p.most) + ".");
    p.value = value;
  }

 private:
  std::size_t find(std::string_view name) const {
    const auto hit =
        std::find_if(list_.begin(), list_.end(), [&](const Parameter& p) { return p.name == name; });
    if (hit == list_.end()) {
      std::vector<std::string> names;
      for (const Parameter& p : list_) names.emplace_back(p.name);
      throw unknown_name("parameter of the solution", name, names);
    }
    return static_cast<std::size_t>(hit - list_.begin());
  }

  std::vector<Parameter> list_;
};

}  // namespace plumb::mms
