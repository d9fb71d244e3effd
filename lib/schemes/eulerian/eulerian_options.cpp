#include "lib/schemes/eulerian/eulerian_options.hpp"

#include <fmt/format.h>

#include "lib/input/section.hpp"

namespace plumb {
namespace {

void read_numbers(const Section& section, EulerianOptions& o) {
  const auto read = [&](const Key& key, double& value) {
    value = section.number_or(key, value, quantity::number, Sign::not_negative);
  };
  read({"xi", "of the stiffness control (32)"}, o.xi);
  read({"xi_tension", "what the square of the largest tension over Young's modulus adds to xi"},
       o.xi_tension);
  read({"zeta", "of the viscous control (33)"}, o.zeta);
  read({"chi", "share of the viscous control in the mixed one (34)"}, o.chi);
  if (o.chi > 1)
    section.fail("chi", fmt::format("{:g} is more than the whole", o.chi),
                 "it is the share of the viscous control", "0.5 is that of paper 001");
  read({"viscosity_linear", "alpha of the artificial viscosity (17)"}, o.viscosity_linear);
  read({"viscosity_quadratic", "beta of the artificial viscosity (17)"}, o.viscosity_quadratic);
  read({"artificial_stress", "epsilon of (11)"}, o.artificial_stress);
  read({"artificial_exponent", "n of (11), the power of its weight"}, o.artificial_exponent);
  read({"diffusion", "delta of the diffusion of density (21)"}, o.diffusion);
  o.beta = section.number_or({"beta", "smoothing length over the spacing"}, o.beta, quantity::number,
                             Sign::positive);
  if (o.beta <= 0.5)
    section.fail("beta", fmt::format("a support of {:g} spacings holds no neighbour", 2 * o.beta),
                 "particles of a lattice are one spacing apart", "the paper has 1.3");
  o.skin = section.number_or({"skin", "how many spacings farther the list of neighbours looks"}, o.skin,
                             quantity::number, Sign::positive);
  if (const auto steps = section.optional_integer(
          {"rereference",
           "steps from one reference of hourglass control to the next; each new list where it is left out"},
          1))
    o.rereference = *steps;
}

}  // namespace

EulerianOptions EulerianOptions::read(const Section& section, EulerianOptions o) {
  o.force = section.choice_or(
      {"force",
       "minus the power of the stress, the printed (10), (11), whose sums are Shepard's, or (11) with the plain gradient"},
      o.force, {"adjoint", "printed", "shepard", "plain"});
  if (o.force == "shepard") o.force = "printed";
  o.damping = section.choice_or(
      {"damping", "half of the stress increment (stress: the same), extrapolated velocities, or none"},
      o.damping, {"objective", "stress", "extrapolated", "none"});
  if (o.damping == "stress") o.damping = "objective";
  o.incremental_error =
      section.choice_or({"error_vector",
                         "of hourglass control: that of the whole deformation, or since the latest "
                         "reference only (incremental)"},
                        o.incremental_error ? "incremental" : "total",
                        {"total", "incremental"}) == "incremental";
  o.hourglass = section.choice_or(
      {"hourglass", "control of hourglass modes: stiffness (32), viscous (33), mixed (34), or none"},
      o.hourglass, {"stiffness", "viscous", "mixed", "none"});
  read_numbers(section, o);
  const auto refuse_unused = [&](const char* key, bool used, const char* of) {
    if (section.has(key) && !used)
      section.fail(key, fmt::format("contradicts hourglass = \"{}\"", o.hourglass),
                   fmt::format("it belongs to {}", of), "leave it out");
  };
  refuse_unused("xi", o.hourglass == "stiffness" || o.hourglass == "mixed", "the stiffness control (32)");
  refuse_unused("xi_tension", o.hourglass == "stiffness" || o.hourglass == "mixed",
                "the stiffness control (32)");
  refuse_unused("zeta", o.hourglass == "viscous" || o.hourglass == "mixed", "the viscous control (33)");
  refuse_unused("chi", o.hourglass == "mixed", "the mixed control (34)");
  refuse_unused("error_vector", o.controls_hourglass() || !o.incremental_error, "hourglass control");
  refuse_unused("rereference", o.controls_hourglass(), "the F of hourglass control (30)");
  if (section.has("artificial_exponent") && o.artificial_stress == 0)
    section.fail("artificial_exponent", "there is no artificial stress", "it is the power of its weight",
                 "give artificial_stress, too, or leave it out");
  if (section.has("misprints"))
    o.misprints = section.texts({"misprints", "equations of the paper that are taken as they are printed"},
                                {"32", "33"});
  for (const std::string& equation : o.misprints)
    if (equation != "32" && equation != "33")
      section.fail("misprints", fmt::format("there is none of ({})", equation),
                   "the others are not in the scheme, or cannot be computed", "valid: \"32\", \"33\"");
  return o;
}

void read_sections_beside(const Section& root, EulerianOptions& o) {
  const auto take = [&](const Section& section, const Key& key, const char* other, double& value) {
    if (!section.has(key)) return;
    if (const auto own = root.optional_section({"eulerian", "the scheme with Eulerian kernels, paper 001"});
        own && own->has(other))
      section.fail(key.name, fmt::format("contradicts [eulerian] {}", other),
                   "they are two names of one number", "leave one of them out");
    value = section.number(key, quantity::number, Sign::not_negative);
  };
  if (const auto section =
          root.optional_section({"viscosity", "artificial viscosity (17) of scheme = \"eulerian\""})) {
    take(*section, {"alpha", "viscosity_linear"}, "viscosity_linear", o.viscosity_linear);
    take(*section, {"beta", "viscosity_quadratic"}, "viscosity_quadratic", o.viscosity_quadratic);
    section->reject_unknown();
  }
  if (const auto section =
          root.optional_section({"artificial_stress", "artificial stress (11) of scheme = \"eulerian\""})) {
    take(*section, {"epsilon", "artificial_stress"}, "artificial_stress", o.artificial_stress);
    take(*section, {"n", "artificial_exponent"}, "artificial_exponent", o.artificial_exponent);
    section->reject_unknown();
  }
}

EulerianOptions EulerianOptions::of_paper() {
  EulerianOptions o;
  o.force = "printed";
  o.damping = "extrapolated";
  o.cfl = 0.4;
  return o;
}

std::string EulerianOptions::in_words() const {
  std::string text = fmt::format("{} force, hourglass control {}, damping {}, cubic spline with h = {:g} dp",
                                 force, hourglass, damping, beta);
  if (stiffness_share() > 0 && xi_tension > 0)
    text += fmt::format(", xi {:g} and {:g} of tension", xi, xi_tension);
  if (incremental_error) text += ", incremental error vector";
  if (has_viscosity()) text += fmt::format(", viscosity {:g}, {:g}", viscosity_linear, viscosity_quadratic);
  if (artificial_stress > 0) text += fmt::format(", artificial stress {:g}", artificial_stress);
  if (diffusion > 0) text += fmt::format(", diffusion of density {:g}", diffusion);
  for (const std::string& equation : misprints) text += fmt::format(", ({}) with its misprint", equation);
  return text;
}

std::vector<std::string> EulerianOptions::warnings() const {
  std::vector<std::string> found;
  if (!adjoint())
    found.push_back(fmt::format(
        "the {} force is not the adjoint of the velocity gradient: it makes energy, and its wave speed "
        "is 0.53 % off in 2D however fine the particles are",
        force));
  if (!adjoint() && damping == "none")
    found.push_back(
        fmt::format("the {} force lets a free body at rest grow: without damping it breaks", force));
  if (incremental_error)
    found.emplace_back(
        "the incremental error vector forgets at each new reference what hourglass control has not undone");
  if (damping == "extrapolated")
    found.emplace_back("rates of extrapolated velocities inflate a body that spins");
  if (!controls_hourglass() && !has_viscosity())
    found.emplace_back(
        "without hourglass control and viscosity, tension tears the body at a strain of some percent");
  return found;
}

}  // namespace plumb
