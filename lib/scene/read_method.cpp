#include <fmt/format.h>

#include <charconv>
#include <type_traits>

#include "lib/scene/names.hpp"
#include "lib/scene/readers.hpp"
#include "lib/scene/scheme_simulation.hpp"

namespace plumb {

namespace {

Compatible read_compatible(const Section& root, const Method& method) {
  Compatible compatible;
  const auto section =
      root.optional_section({"compatible", "how the table of gradient = \"compatible\" is made"});
  if (!section) return compatible;
  if (method.gradient != "compatible")
    section->fail("", fmt::format("contradicts gradient = \"{}\"", method.gradient),
                  "it says how the table of gradient = \"compatible\" is made", "leave one of them out");
  compatible.table = section->choice_or(
      {"table", "closed form on lattices in boxes, or projected; auto: closed form wherever there is one"},
      compatible.table, compatible_table_names());
  compatible.start = section->choice_or(
      {"start", "the table that is projected, or whose weights inside of a lattice are closed at its faces"},
      compatible.start, start_table_names());
  compatible.volumes =
      section->choice_or({"volumes", "found with the area vectors, or fixed as those of Voronoi cells"},
                         compatible.volumes, compatible_volume_names());
  compatible.surface =
      section->choice_or({"surface", "that of the body's shape, or one estimated from the particles"},
                         compatible.surface, compatible_surface_names());
  if (compatible.table == "closed-form" && compatible.surface == "estimated")
    section->fail("table", "\"closed-form\" contradicts surface = \"estimated\"",
                  "the closed form ends at the faces of the box", "leave one of them out");
  if (compatible.table == "closed-form" && method.momentum != "adjoint")
    section->fail("table", fmt::format("\"closed-form\" contradicts momentum = \"{}\"", method.momentum),
                  "its bonds within a face are not antisymmetric, so "
                  "that only the adjoint form passes the patch test",
                  "use momentum = \"adjoint\" or table = \"projected\"");
  if (section->has("cache"))
    compatible.cache = section->text({"cache", "folder of tables that were projected before"});
  section->reject_unknown();
  return compatible;
}

/// The scheme of that paper as it is printed. The [jst] of paper 000 is in read_method().
void set_paper(Method& method) {
  if (method.paper == "003") {
    method.scheme = "mixed";
    method.mixed.volumes = "tributary";
    method.mixed.kinematics = "evolved";
    method.mixed.upwind = "reconstructed";
    method.cfl = 0.9;  // of its section 8
    return;
  }
  if (method.paper == "001") {
    method.scheme = "eulerian";
    method.eulerian = EulerianOptions::of_paper();
    method.cfl = method.eulerian.cfl;
    return;
  }
  if (method.paper == "002") {
    method.scheme = "updated";
    method.updated = UpdatedOptions::of_paper();
    method.cfl = method.updated.cfl;
    return;
  }
  if (method.paper == "004") {
    method.scheme = "implicit";
    method.kernel = "quintic";
    method.beta = 2.05 / 3;  // 2.05 spacings are the radius of the support, 3 h
    method.pair = "none";
    method.gradient = "standard";
    method.hourglass = HourglassOptions{};
    method.hourglass->weight = "slope";
    method.hourglass->alpha = 1;
    return;
  }
  method.pair = "W1";
  method.gradient = "improved";
  method.momentum = "symmetrised";
  method.integrator = "rk3";
}

/// Compatible bonds end at the surface, where particles must lie, and their force is the adjoint one.
std::string default_gradient(const Method& method, const Body& body) {
  if (method.pair == "none") return "standard";
  if (!method.paper.empty()) return method.gradient;
  return method.momentum == "adjoint" && body.layout == Layout::node ? "compatible" : "improved";
}

/// Particles beside a surface that cuts a cloud have too few bonds with 0.9, THEORY chapter 11.
double default_beta(const Method& method, const Body& body) {
  const bool fills_box = body.shape == "box" && body.holes.empty() && body.cloud == "lattice";
  return method.gradient == "compatible" && !fills_box ? 1.2 : method.beta;
}

/// Schemes with a body of their own have tables and stages of their own.
void refuse_keys_of_tlsph(const Section& section, const std::string& scheme) {
  for (const char* key : {"kernel", "beta", "pair", "gradient", "momentum", "integrator", "wave_speed"})
    if (section.has(key))
      section.fail(key, fmt::format("contradicts scheme = \"{}\"", scheme),
                   fmt::format("that scheme has its own, which section [{}] chooses", scheme),
                   "leave it out, or use scheme = \"tlsph\"");
}

/// "uniform", "spacing" (both 0) or "nearest:12".
long read_support(const Section& section, bool& by_spacing) {
  const std::string
      given = section.text(
          {"support",
           "\"uniform\"; \"spacing\": beta times that around each particle; \"nearest:12\": each one's reaches to that neighbour"}),
      nearest = "nearest:";
  by_spacing = given == "spacing";
  if (given == "uniform" || by_spacing) return 0;
  long k = 0;
  const char* end = given.data() + given.size();
  const bool number = given.starts_with(nearest) && std::from_chars(given.data() + nearest.size(), end, k) ==
                                                        std::from_chars_result{end, {}};
  if (!number)
    section.fail("support", fmt::format("unknown support \"{}\"", given), "",
                 "write \"uniform\", \"spacing\", or \"nearest:12\" for the twelve nearest neighbours");
  constexpr long least = 4;  // fewer cannot span the space once the farthest has no weight
  if (k < least)
    section.fail("support", fmt::format("{} neighbours do not make a gradient", k),
                 "the farthest has no weight, and the rest must span the space", "ask for 10 to 40");
  return k;
}

/// Kernels without correction, and supports of their own, have a table of one kind.
void refuse_beside_plain_kernel(const Section& section, const Method& method) {
  if ((method.nearest > 0 || method.by_spacing) && method.pair != "none")
    section.fail("support",
                 fmt::format("\"{}\" contradicts pair = \"{}\"", method.by_spacing ? "spacing" : "nearest",
                             method.pair),
                 "corrected kernels have one smoothing length", "use pair = \"none\"");
  if (method.nearest > 0 && section.has("beta"))
    section.fail("beta", "contradicts support = \"nearest\"", "supports follow from the number of neighbours",
                 "leave one of them out");
  if (method.pair != "none") return;
  if (method.gradient != "standard")
    section.fail("gradient", fmt::format("\"{}\" contradicts pair = \"none\"", method.gradient),
                 "the uncorrected kernel is normalised by L^-1 and by nothing else", "leave one of them out");
  if (method.momentum != "adjoint")
    section.fail("momentum", fmt::format("\"{}\" contradicts pair = \"none\"", method.momentum),
                 "its force is minus the derivative of the energy", "use momentum = \"adjoint\"");
}

Method read_method_section(const Section& root, const Body& body) {
  Method method;
  const auto section = root.optional_section({"method", "the scheme"});
  if (!section) {
    method.gradient = default_gradient(method, body);
    method.beta = default_beta(method, body);
    return method;
  }
  if (section->has("paper")) {
    method.paper = section->choice_or({"paper", "keys that are not given are those of that paper"}, "000",
                                      paper_names());
    set_paper(method);
  }
  method.scheme = section->choice_or(
      {"scheme",
       "total Lagrangian, implicit, mixed, updated Lagrangian, Eulerian kernels, or finite elements"},
      method.scheme, scheme_names());
  if (has_own_body(method.scheme)) refuse_keys_of_tlsph(*section, method.scheme);
  method.kernel = section->choice_or({"kernel", "the smoothing kernel"}, method.kernel, kernel_names());
  method.pair = section->choice_or({"pair", "correction of the kernel: constant (W0), linear (W1), or none"},
                                   method.pair, pair_names());
  method.momentum =
      section->choice_or({"momentum", "the form of the internal force"}, method.momentum, momentum_names());
  method.gradient = section->choice_or({"gradient", "the estimate of the deformation gradient"},
                                       default_gradient(method, body), gradient_names());
  method.beta = section->number_or(
      {"beta",
       "smoothing length over the spacing; 1.2 where it is left out and a surface cuts a cloud with compatible bonds"},
      default_beta(method, body), quantity::number, Sign::positive);
  if (method.momentum == "variational" && method.gradient == "compatible")
    section->fail("momentum", R"("variational" contradicts gradient = "compatible")",
                  "a compatible table leaves nothing to correct", "use momentum = \"adjoint\"");
  if (section->has("support")) method.nearest = read_support(*section, method.by_spacing);
  refuse_beside_plain_kernel(*section, method);
  method.integrator =
      section->choice_or({"integrator", "the rule of the time steps"}, method.integrator, integrator_names());
  method.wave_speed = section->choice_or(
      {"wave_speed", "what the step follows: the speed of linear waves, or that of the stretched body"},
      method.wave_speed, wave_speed_names());
  method.time_step = section->optional_number({"time_step", "fixed step in time, instead of one by cfl"},
                                              quantity::time, Sign::positive);
  const auto cfl =
      section->optional_number({"cfl", "the step over the time in which a wave crosses a smoothing length"},
                               quantity::number, Sign::positive);
  if (cfl && method.time_step)
    section->fail("time_step", "contradicts cfl", "the step is either fixed or follows from cfl",
                  "leave one of them out");
  if (method.time_step && section->has("wave_speed"))
    section->fail("wave_speed", "contradicts time_step", "a fixed step does not depend on the wave speed",
                  "leave one of them out");
  if (cfl) method.cfl = cfl;
  if (method.time_step) method.cfl = std::nullopt;
  section->reject_unknown();
  return method;
}

}  // namespace

std::vector<std::string> method_sections() {
  std::vector<std::string> names{"method",   "compatible", "mixed",     "implicit",         "updated",
                                 "eulerian", "element",    "viscosity", "artificial_stress"};
  Method method;
  for_each_part(method, [&]<class Part>(std::optional<Part>&) { names.emplace_back(Part::section); });
  return names;
}

Method read_method(const Section& root, const Body& body) {
  Method method = read_method_section(root, body);
  if (body.finer && has_own_body(method.scheme))
    root.section("body").fail("finer", fmt::format("contradicts scheme = \"{}\"", method.scheme),
                              "its sums and cells know one spacing",
                              "use scheme = \"tlsph\" or \"implicit\", or leave it out");
  read_scheme(root, method);
  method.compatible = read_compatible(root, method);
  for_each_part(method, [&]<class Part>(std::optional<Part>& part) {
    const auto section = root.optional_section({std::string(Part::section), std::string(Part::meaning)});
    if (!section) {
      if constexpr (std::is_same_v<Part, JstOptions>)
        if (method.paper == "000") part = JstOptions{};  // paper 000 has one
      return;
    }
    part = Part::read(*section);
    section->reject_unknown();
    if constexpr (std::is_same_v<Part, HourglassOptions>)
      if (part && method.paper == "004" && !section->has("weight")) {
        part->weight = "slope";
        if (!section->has("alpha")) part->alpha = 1;
      }
  });
  if (method.dissipation && method.momentum != "adjoint")
    root.section("dissipation")
        .fail("", fmt::format("contradicts momentum = \"{}\"", method.momentum),
              "the transpose of its velocity gradients is the adjoint force",
              "use momentum = \"adjoint\", or [jst]");
  if (method.pair == "none" && method.jst)
    root.section("jst").fail("", "contradicts pair = \"none\"", "its Laplacian has corrected kernels",
                             "leave it out");
  return method;
}

void refuse_beside_mirror(const Section& root, Layout layout, const Method& method) {
  if (layout != Layout::mirror) return;
  const auto refuse = [&](const char* section, const char* key, const char* why) {
    root.section(section).fail(key, "contradicts layout = \"mirror\"", why, "use layout = \"node\"");
  };
  if (method.gradient == "compatible")
    refuse("method", "gradient", "compatible area vectors end at the surface, where particles must lie");
  if (method.momentum == "variational")
    refuse("method", "momentum", "its correction needs particles on the surface, and has no bonds to images");
  if (root.has("dissipation")) refuse("dissipation", "", "its pairs have no images behind a roller");
  if (root.has("hourglass")) refuse("hourglass", "", "the hourglass energy has no bonds to images");
  if (root.has("projection")) refuse("projection", "", "images exert a torque that is not to be taken away");
}

const Alternatives& scene_alternatives() {
  static const Alternatives alternatives{{"body.spacing", "body.particles"},
                                         {"method.cfl", "method.time_step"},
                                         {"initial.velocity", "initial.spin"},
                                         {"study.time", "study.periods"}};
  return alternatives;
}

}  // namespace plumb
