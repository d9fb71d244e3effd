#include "lib/schemes/updated/updated_options.hpp"

#include <fmt/format.h>

#include "lib/core/error.hpp"
#include "lib/input/section.hpp"

namespace plumb {
namespace {

void read_numbers(const Section& section, UpdatedOptions& o) {
  if (section.has("xi"))
    o.xi = section.number(
        {"xi", "strength of the force between pairs; by the form and the dimension where it is left out"},
        quantity::number, Sign::not_negative);
  o.beta = section.number_or({"beta", "smoothing length over the spacing"}, o.beta, quantity::number,
                             Sign::positive);
  if (o.beta <= 0.5)
    section.fail("beta", fmt::format("a support of {:g} spacings holds no neighbour", 2 * o.beta),
                 "particles of a lattice are one spacing apart", "the paper has 1.3");
  o.skin = section.number_or({"skin", "how many spacings farther the list of neighbours looks"}, o.skin,
                             quantity::number, Sign::positive);
  o.guard = section.number_or(
      {"guard",
       "share of its first determinant below which a correction is blended with the identity; 0: never"},
      o.guard, quantity::number, Sign::not_negative);
  if (o.guard >= 1)
    section.fail("guard", fmt::format("{:g} blends every correction away", o.guard),
                 "it is a share of the determinant at the start", "0.15 touches ejected particles only");
  o.advection_cfl = section.number_or({"advection_cfl", "of the advection step, (22)"}, o.advection_cfl,
                                      quantity::number, Sign::positive);
  if (section.has("reference_speed"))
    o.reference_speed = section.number({"reference_speed", "least speed that (22) takes"}, quantity::velocity,
                                       Sign::positive);
  if (section.has("tension_limit"))
    o.tension_limit = section.number({"tension_limit", "the pressure falls no lower than minus this"},
                                     quantity::stress, Sign::positive);
}

}  // namespace

UpdatedOptions UpdatedOptions::read(const Section& section, UpdatedOptions o) {
  o.form = section.choice_or({"form", "og: no control of hourglass modes; eno: (25); gno: (45)"}, o.form,
                             {"og", "eno", "gno"});
  o.balance = section.choice_or({"balance", "conservative: both momenta to round-off; printed: the paper's"},
                                o.balance, {"conservative", "printed"});
  o.penalty =
      section.choice_or({"penalty", "projected on the pair (46), or the vector (43); of form = \"gno\""},
                        o.penalty, {"projected", "vector"});
  o.rotation = section.choice_or({"rotation", "of what pairs have summed up; of balance = \"printed\""},
                                 o.rotation, {"none", "own", "mean"});
  o.geometry = section.choice_or(
      {"geometry", "new at every step, or frozen for an advection step; of balance = \"printed\""},
      o.geometry, {"step", "advection"});
  o.dissipation = section.choice_or({"dissipation", "between pairs: a Riemann problem (17), or none"},
                                    o.dissipation, {"riemann", "none"});
  o.deviator =
      section.choice_or({"deviator", "of strains in 2D: that of plane strain, or of two dimensions (8)"},
                        o.deviator, {"plane-strain", "two-dimensional"});
  o.stress_update = section.choice_or({"stress_update", "rotated, or by the rate of Jaumann (8)"},
                                      o.stress_update, {"rotate", "jaumann"});
  o.speed =
      section.choice_or({"speed", "of the step: pressure waves of the discrete body, or the bulk speed (23)"},
                        o.speed, {"pressure", "bulk"});
  o.reaction = section.flag_or(
      {"reaction", "of what the penalty does on the stress, so that its work is what it stores; of form gno"},
      o.reaction);
  o.yield_ratio = section.flag_or(
      {"yield_ratio", "the penalty falls with the stress that plastic flow takes away"}, o.yield_ratio);
  if (section.has("misprints"))
    o.misprints = section.texts(
        {"misprints", "equations of the paper that are taken with their misprints; of balance = \"printed\""},
        {"17", "49"});
  for (const std::string& equation : o.misprints)
    if (equation != "17" && equation != "49")
      section.fail("misprints", fmt::format("there is none of ({})", equation),
                   "the others are not in the scheme, or cannot be computed", "valid: \"17\", \"49\"");
  read_numbers(section, o);
  try {
    require_consistent(o);
  } catch (const InputError& error) {
    section.fail("balance", error.problem(), error.why(), error.suggestion());
  }
  return o;
}

UpdatedOptions UpdatedOptions::of_paper() {
  UpdatedOptions o;
  o.balance = "printed";
  o.rotation = "mean";
  o.geometry = "advection";
  o.yield_ratio = false;
  o.deviator = "two-dimensional";
  o.stress_update = "jaumann";
  o.speed = "bulk";
  o.guard = 0;
  o.cfl = 0.4;
  return o;
}

void require_consistent(const UpdatedOptions& o) {
  if (!o.conservative()) return;
  const auto refuse = [](const std::string& what, const std::string& why) {
    throw InputError("\"conservative\" contradicts " + what, why,
                     "leave it out, or use balance = \"printed\"");
  };
  if (o.penalty == "vector") refuse("penalty = \"vector\"", "forces across a pair have a torque");
  if (o.rotation != "none")
    refuse("rotation = \"" + o.rotation + "\"",
           "it keeps one number of each pair, which turns with the pair");
  if (!o.misprints.empty()) refuse("misprints", "they are of equations that it does not have");
  if (o.geometry != "step")
    refuse("geometry = \"" + o.geometry + "\"", "frozen directions of forces give a torque");
}

std::string UpdatedOptions::in_words() const {
  std::string text = fmt::format("form {}, balance {}", form, balance);
  if (form == "gno" && penalty == "vector") text += ", penalty by vectors";
  if (rotation != "none") text += fmt::format(", {} rotation", rotation);
  if (geometry != "step") text += ", geometry of the last advection step";
  text += fmt::format(", dissipation {}, Wendland C2 with h = {:g} dp", dissipation, beta);
  if (form == "gno" && conservative() && !reaction) text += ", penalty without reaction";
  if (has_bonds() && !yield_ratio) text += ", penalty without yield ratio";
  for (const std::string& equation : misprints) text += fmt::format(", ({}) with its misprint", equation);
  if (deviator != "plane-strain") text += ", deviator of two dimensions";
  return text;
}

std::vector<std::string> UpdatedOptions::warnings() const {
  std::vector<std::string> found;
  if (form == "og") found.emplace_back("form = \"og\" has modes without energy: tension tears it");
  if (form == "eno" && rotation == "none" && !conservative())
    found.emplace_back(
        "the sums of form \"eno\" do not turn with the body: "
        "a spinning plate gains half of its angular momentum");
  if (!conservative() && dissipation == "none")
    found.emplace_back("without dissipation the printed balance lets the motion of a free body grow");
  if (!conservative() && geometry == "advection")
    found.emplace_back(
        "frozen geometry drives a spin: dL/dt = omega^2 L times half the time that it is frozen");
  return found;
}

}  // namespace plumb
