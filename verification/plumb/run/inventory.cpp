#include "verification/plumb/run/inventory.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

namespace plumb::app {

std::size_t total_bytes(const std::vector<ArrayEntry>& arrays) {
  std::size_t sum = 0;
  for (const auto& entry : arrays) sum += entry.bytes;
  return sum;
}

template <int d>
Parts parts_of(const Scene& scene, const TlsphBody<d>& simulation) {
  Parts parts;
  const auto add = [&parts](bool built, std::string name) {
    (built ? parts.built : parts.left_out).push_back(std::move(name));
  };
  // What counts is what is there, not what was asked for.
  const auto has_term = [&](std::string_view name) {
    return std::any_of(simulation.solid.terms.begin(), simulation.solid.terms.end(),
                       [&](const Term<d>& term) { return term.name == name; });
  };
  const Output output = scene.output.value_or(Output{});
  add(true, "material " + scene.material.model);
  add(true, "bond constants: kernel " + scene.method.kernel + ", correction " + scene.method.pair +
                ", gradient " + scene.method.gradient + ", momentum " + scene.method.momentum);
  add(true, "integrator " + std::string(simulation.integrator.name));
  for_each_part(scene.method, [&]<class Part>(const std::optional<Part>&) {
    add(has_term(Part::section), std::string(Part::section));
  });
  add(scene.initial.has_value(), "initial");
  add(has_term("loads"), "load");
  add(has_term("supports"), "boundary");
  add(has_term("mirror"), "mirror");
  add(scene.relaxation.has_value(), "relaxation");
  add(stores_F(simulation.solid.terms), "stored deformation gradient");
  add(stores_force(simulation.solid.terms), "stored force");
  add(output.series, "series");
  add(output.budget, "budget");
  add(output.vtk, "vtk");
  add(!output.probes.empty(), "probe");
  return parts;
}

nlohmann::ordered_json compatible_json(const CompatibleReport* report) {
  if (!report) return nullptr;
  if (report->closed_form) return {{"table", "closed-form"}};
  return {{"table", "projected"},
          {"why_projected", report->why_projected},
          {"unknowns", report->unknowns},
          {"divergence_defect", report->divergence_defect},
          {"divergence_remainder", report->divergence_remainder},
          {"start_residual", report->start_residual},
          {"residual", report->residual},
          {"largest_change", report->largest_change},
          {"largest_volume_change", report->largest_volume_change},
          {"refinements", report->refinements},
          {"iterations", report->iterations},
          {"from_cache", report->from_cache}};
}

std::string compatible_text(const CompatibleReport* report) {
  if (!report) return "";
  if (report->closed_form) return "compatible table: closed form, nothing was solved\n";
  return fmt::format(
      "compatible table: boundary vectors miss the divergence theorem by {:.2g} of the volume, corrected to "
      "{:.1g}; "
      "constraints from {:.2g} to {:.1g}, {}; volumes change by at most {:.2g} of themselves\n",
      report->divergence_defect, report->divergence_remainder, report->start_residual, report->residual,
      report->from_cache ? "read from the cache"
      : report->iterations > 0
          ? fmt::format("{} unknowns, {} iterations", report->unknowns, report->iterations)
          : fmt::format("{} unknowns, factorised", report->unknowns),
      report->largest_volume_change);
}

std::size_t peak_resident_bytes() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;  // Linux counts in KiB
}

std::size_t available_bytes() {
  std::ifstream file("/proc/meminfo");
  std::string key, unit;
  for (std::size_t kib = 0; file >> key >> kib && std::getline(file, unit);)
    if (key == "MemAvailable:") return kib * 1024;
  return 0;
}

template Parts parts_of<1>(const Scene&, const TlsphBody<1>&);
template Parts parts_of<2>(const Scene&, const TlsphBody<2>&);
template Parts parts_of<3>(const Scene&, const TlsphBody<3>&);

}  // namespace plumb::app
