#pragma once
#include <cmath>
#include <concepts>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

/// JSON of values that list their own members, once: what is written and what is read cannot differ. Members are
///   template <class Self, class Visit>
///   static void members(Self& self, Visit&& visit) { visit("n", self.n); visit("spacing", self.d); }
/// numbers, words, texts, such values, and optionals and lists of them.
namespace plumb {

namespace listed_detail {
struct AnyVisit {
  template <class T>
  void operator()(const char*, T&) const {}
};
}  // namespace listed_detail

/// A value that lists its members.
template <class T>
concept Listed = requires(T& value) {
  T::members(value, listed_detail::AnyVisit{});
};

/// Returns the value as JSON: members in their order, an absent optional and a number that is not finite as null.
template <class T>
nlohmann::ordered_json to_json(const T& value) {
  using Json = nlohmann::ordered_json;
  if constexpr (Listed<const T>) {
    Json object = Json::object();
    T::members(value, [&](const char* name, const auto& member) { object[name] = to_json(member); });
    return object;
  } else if constexpr (requires { value.has_value(); }) {
    return value ? to_json(*value) : Json();
  } else if constexpr (std::floating_point<T>) {
    return std::isfinite(value) ? Json(value) : Json();
  } else if constexpr (requires(T list) { list.push_back(*list.begin()); } &&
                       !std::convertible_to<T, std::string>) {
    Json list = Json::array();
    for (const auto& entry : value) list.push_back(to_json(entry));
    return list;
  } else {
    return Json(value);
  }
}

/// Reads back what to_json() made; null for a number is NaN. Throws nlohmann's exceptions if a member is missing or of
/// another kind.
template <class T>
T from_json(const nlohmann::ordered_json& json) {
  if constexpr (Listed<T>) {
    T value{};
    T::members(value, [&](const char* name, auto& member) {
      member = from_json<std::remove_cvref_t<decltype(member)>>(json.at(name));
    });
    return value;
  } else if constexpr (requires(T optional) { optional.has_value(); }) {
    return json.is_null() ? T() : T(from_json<typename T::value_type>(json));
  } else if constexpr (std::floating_point<T>) {
    return json.is_null() ? std::numeric_limits<T>::quiet_NaN() : json.get<T>();
  } else if constexpr (requires(T list) { list.push_back(*list.begin()); } &&
                       !std::convertible_to<T, std::string>) {
    T list;
    for (const auto& entry : json) list.push_back(from_json<typename T::value_type>(entry));
    return list;
  } else {
    return json.get<T>();
  }
}

}  // namespace plumb
