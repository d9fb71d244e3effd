#pragma once
#include <concepts>
#include <string>
#include <string_view>
#include <vector>

namespace plumb {

/// A list of types, as made by the catalogues (kernels, estimators, materials, manufactured solutions).
template <class... Ts>
struct TypeList {};

/// Stands for the type T in a call, without a value of it.
template <class T>
struct Type {
  using type = T;
};

/// Calls f(Type<T>{}) for every T of the list, in order.
template <class... Ts, class F>
void for_each_type(TypeList<Ts...>, F&& f) {
  (f(Type<Ts>{}), ...);
}

/// Calls f(Type<T>{}) for the T whose T::name is `name`; false if there is none.
template <class... Ts, class F>
bool with_named(TypeList<Ts...>, std::string_view name, F&& f) {
  return ((Ts::name == name && (f(Type<Ts>{}), true)) || ...);
}

/// The names of all members, for messages and --list.
template <class... Ts>
std::vector<std::string> names_of(TypeList<Ts...>) {
  return {std::string(Ts::name)...};
}

}  // namespace plumb
