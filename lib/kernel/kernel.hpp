#pragma once
#include <cmath>
#include <concepts>
#include <string_view>

#include "lib/core/error.hpp"
#include "lib/core/type_list.hpp"
#include "lib/kernel/catalogue.hpp"  // made by CMake from kernel/kernels/*.hpp

namespace plumb {

/// A radial kernel in d dimensions: W(r, h) = w(q) / h^d with q = r / h, zero for q >= support (kappa).
/// w is normalised: its integral over R^d is 1. dw is its derivative. A new kernel is one file in kernels/.
template <class K, int d>
concept Kernel = requires(double q) {
  { K::name } -> std::convertible_to<std::string_view>;
  { K::support } -> std::convertible_to<double>;
  { K::template w<d>(q) } -> std::convertible_to<double>;
  { K::template dw<d>(q) } -> std::convertible_to<double>;
};

/// A kernel chosen at run time. It acts at set-up only, so it is a pair of functions.
template <int d>
struct RadialKernel {
  std::string_view name;
  double support;          ///< kappa = R / h
  double (*w)(double q);   ///< dimensionless W h^d
  double (*dw)(double q);  ///< dimensionless W' h^(d+1)
};

/// Makes the value that stands for a kernel at run time.
template <int d, Kernel<d> K>
constexpr RadialKernel<d> radial_kernel() {
  return {K::name, K::support, &K::template w<d>, &K::template dw<d>};
}

/// The kernel of that name from the catalogue; InputError names the nearest valid one.
template <int d>
RadialKernel<d> kernel_named(std::string_view name) {
  RadialKernel<d> kernel{};
  if (!with_named(KernelCatalogue{}, name, [&]<class K>(Type<K>) { kernel = radial_kernel<d, K>(); }))
    throw unknown_name("kernel", name, names_of(KernelCatalogue{}));
  return kernel;
}

}  // namespace plumb
