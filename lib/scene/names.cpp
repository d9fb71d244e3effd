#include "plumbline/scene/names.hpp"

#include <algorithm>

#include "plumbline/geometry/shape.hpp"
#include "plumbline/gradient/catalogue.hpp"
#include "plumbline/kernel/catalogue.hpp"
#include "plumbline/material/catalogue.hpp"
#include "plumbline/momentum/catalogue.hpp"
#include "plumbline/time/catalogue.hpp"

namespace plumb {

std::vector<std::string> kernel_names() {
  return names_of(KernelCatalogue{});
}
std::vector<std::string> pair_names() {
  return {"W1", "W0"};
}

std::vector<std::string> gradient_names() {
  auto names = names_of(EstimatorCatalogue{});
  std::erase(names, "bond");
  if (std::find(names.begin(), names.end(), "compatible") == names.end()) names.emplace_back("compatible");
  return names;
}

std::vector<std::string> compatible_table_names() {
  return {"auto", "closed-form", "projected"};
}
std::vector<std::string> start_table_names() {
  return {"standard", "improved"};
}
std::vector<std::string> momentum_names() {
  auto names = names_of(MomentumCatalogue{});
  names.emplace_back("variational");
  return names;
}
std::vector<std::string> integrator_names() {
  return names_of(IntegratorCatalogue{});
}
std::vector<std::string> wave_speed_names() {
  return {"linear", "stretch", "stretch-inverse"};
}
std::vector<std::string> material_names() {
  return names_of(MaterialCatalogue{});
}
std::vector<std::string> outer_laplacian_names() {
  return {"symmetric", "transpose"};
}
std::vector<std::string> shape_names() {
  return shape_catalogue_names();
}
std::vector<std::string> layout_names() {
  return {"cell", "node", "mirror"};
}
std::vector<std::string> boundary_kind_names() {
  return {"clamped", "roller", "velocity"};
}

std::vector<std::string> face_names(int dimension) {
  std::vector<std::string> names{"x-", "x+", "y-", "y+"};
  if (dimension == 3) names.insert(names.end(), {"z-", "z+"});
  return names;
}

}  // namespace plumb
