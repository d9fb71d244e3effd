#include <fmt/format.h>

#include "plumbline/scene/names.hpp"
#include "plumbline/scene/readers.hpp"

namespace plumb {

namespace {

Compatible read_compatible(const Section& root, const Method& method) {
  Compatible compatible;
  const auto section = root.optional_section("compatible");
  if (!section) return compatible;
  if (method.gradient != "compatible")
    section->fail("", fmt::format("contradicts gradient = \"{}\"", method.gradient),
                  "it says how the table of gradient = \"compatible\" is made", "leave one of them out");
  compatible.start = section->choice_or("start", compatible.start, start_table_names());
  compatible.volumes = section->choice_or("volumes", compatible.volumes, {"unknown", "fixed"});
  compatible.surface = section->choice_or("surface", compatible.surface, {"shape", "estimated"});
  if (section->has("cache")) compatible.cache = section->text("cache");
  section->reject_unknown();
  return compatible;
}

Method read_method_section(const Section& root) {
  Method method;
  const auto section = root.optional_section("method");
  if (!section) return method;
  method.kernel = section->choice_or("kernel", method.kernel, kernel_names());
  method.beta = section->number_or("beta", method.beta, quantity::number, Sign::positive);
  method.pair = section->choice_or("pair", method.pair, pair_names());
  method.gradient = section->choice_or("gradient", method.gradient, gradient_names());
  method.momentum = section->choice_or("momentum", method.momentum, momentum_names());
  if (method.momentum == "variational" && method.gradient == "compatible")
    section->fail("momentum", R"("variational" contradicts gradient = "compatible")",
                  "a compatible table leaves nothing to correct", "use momentum = \"adjoint\"");
  method.integrator = section->choice_or("integrator", method.integrator, integrator_names());
  method.wave_speed = section->choice_or("wave_speed", method.wave_speed, wave_speed_names());
  method.time_step = section->optional_number("time_step", quantity::time, Sign::positive);
  const auto cfl = section->optional_number("cfl", quantity::number, Sign::positive);
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

Method read_method(const Section& root) {
  Method method = read_method_section(root);
  method.compatible = read_compatible(root, method);
  return method;
}

std::optional<Jst> read_jst(const Section& root) {
  const auto section = root.optional_section("jst");
  if (!section) return std::nullopt;
  Jst jst;
  jst.eta2 = section->number_or("eta2", jst.eta2, quantity::number, Sign::not_negative);
  jst.eta4 = section->number_or("eta4", jst.eta4, quantity::number, Sign::not_negative);
  jst.laplacian_factor =
      section->number_or("laplacian_factor", jst.laplacian_factor, quantity::number, Sign::positive);
  jst.outer = section->choice_or("outer", jst.outer, outer_laplacian_names());
  section->reject_unknown();
  return jst;
}

std::optional<Hourglass> read_hourglass(const Section& root) {
  const auto section = root.optional_section("hourglass");
  if (!section) return std::nullopt;
  Hourglass hourglass;
  hourglass.alpha = section->number_or("alpha", hourglass.alpha, quantity::number, Sign::not_negative);
  section->reject_unknown();
  return hourglass;
}

bool read_projection(const Section& root) {
  const auto section = root.optional_section("projection");
  if (section) section->reject_unknown();
  return section.has_value();
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
