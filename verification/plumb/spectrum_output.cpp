#include "verification/plumb/spectrum_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "lib/output/particles.hpp"
#include "lib/output/table.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

const char* name_of(ModeKind kind) {
  return kind == ModeKind::rigid ? "rigid" : kind == ModeKind::smooth ? "smooth" : "spurious";
}

/// The `wanted` lowest modes, then the rigid ones.
std::vector<const Mode*> listed_modes(const Spectrum& s, int wanted) {
  std::vector<const Mode*> modes;
  for (const Mode& mode : s.low.modes)
    if (static_cast<int>(modes.size()) < wanted) modes.push_back(&mode);
  for (const Mode& mode : s.rigid) modes.push_back(&mode);
  return modes;
}

/// [Hz]; what the eigenvalue of a rigid motion gives is the rounding of zero.
double hertz(const Mode& mode, double time_unit) {
  return mode.kind == ModeKind::rigid ? 0 : mode.frequency() / time_unit;
}

Json mode_json(const Mode& mode, double time_unit) {
  const double hz = hertz(mode, time_unit);
  return {{"value", mode.value},
          {"imaginary", mode.imaginary},
          {"hz", hz},
          {"period_s", hz > 0 ? Json(1 / hz) : Json()},
          {"unexplained", mode.unexplained},
          {"kind", name_of(mode.kind)},
          {"spurious", mode.spurious()}};
}

Json or_null(const std::optional<double>& value) {
  return value ? Json(*value) : Json();
}

/// The motion at every particle, its largest entry `largest`.
template <int d>
std::vector<double> motion_of(const Mode& mode, const LinearOperator<d>& op, double largest) {
  std::vector<double> u(static_cast<std::size_t>(op.solid().cloud.size() * d), 0.0);
  Index first = 0;  // of the largest entries, which has the sign of `largest`: an eigenvector has none
  const double most = mode.motion.cwiseAbs().maxCoeff();
  while (std::abs(mode.motion[first]) < (1 - 1e-6) * most) ++first;
  const double scale = std::copysign(largest / most, mode.motion[first]);
  for (Index n = 0; n < op.size(); ++n) {
    const auto& [particle, axis] = op.components()[n];
    u[static_cast<std::size_t>(particle * d + axis)] = scale * mode.motion[n];
  }
  return u;
}

/// "at least 3" or "3".
std::string count_text(const Json& count, bool at_least) {
  return fmt::format("{}{}", at_least ? "at least " : "", count.get<int>());
}

std::string smooth_text(const Json& s) {
  const bool some = !s["lowest_smooth"].is_null(), all = s["complete"].get<bool>();
  const auto spurious = s["spurious_below_smooth"].get<int>();
  if (!some)
    return fmt::format("  {}{} spurious; lowest smooth: {}\n", all ? "" : "At least ", spurious,
                       all ? "none, all modes are spurious" : "not among those looked at");
  return fmt::format(
      "  {}{} spurious below the lowest smooth one, {} of them of nearly no energy; lowest smooth: {:.6g}\n",
      all ? "" : "At least ", spurious, s["near_zero_not_rigid"].get<int>(),
      s["lowest_smooth"].get<double>());
}

std::string modes_text(const Json& modes) {
  Table table{{"mode", "kind", "frequency [Hz]", "period [s]", "unexplained share"}, {}};
  for (const auto& mode : modes)
    table.rows.push_back({static_cast<long long>(table.rows.size() + 1), mode["kind"].get<std::string>(),
                          mode["hz"].get<double>(),
                          mode["period_s"].is_null() ? Cell("none") : Cell(mode["period_s"].get<double>()),
                          mode["unexplained"].get<double>()});
  return plain_text(table);
}

}  // namespace

Json spectrum_json(const Spectrum& s, const Scene& scene, double time_unit, int listed) {
  const double limit = oscillation_limit(scene.method.integrator);
  Json modes = Json::array();
  for (const Mode* mode : listed_modes(s, listed)) modes.push_back(mode_json(*mode, time_unit));
  const auto& near_zero = s.low.near_zero_not_rigid;
  return {{"scene", scene.name},
          {"unknowns", s.unknowns},
          {"complete", s.complete},
          {"at_least", s.partial()},
          {"asymmetry", s.asymmetry},
          {"rigid", s.rigid.size()},
          {"rigid_residual", s.rigid_residual},
          {"near_zero_not_rigid", near_zero ? Json(near_zero->found) : Json()},
          {"spurious_below_smooth", s.low.spurious_below_smooth.found},
          {"complex_pairs", s.complex_pairs.found},
          {"negative", s.negative.found},
          {"largest_imaginary", s.largest_imaginary},
          {"largest", s.largest},
          {"lowest_nonrigid", or_null(s.lowest_nonrigid())},
          {"lowest_smooth", or_null(s.low.lowest_smooth)},
          {"growth_rate_undamped", s.growth_undamped.rate},
          {"growth_rate", s.growth.rate},
          {"growth_resolution", s.growth.resolution},
          {"time_unit_s", time_unit},
          {"stable_step_s", limit / std::sqrt(s.largest) * time_unit},
          {"stable_cfl", limit / std::sqrt(s.largest)},
          {"modes", modes}};
}

std::string spectrum_text(const Json& s) {
  const bool partial = s["at_least"].get<bool>() && s["asymmetry"].get<double>() > symmetric_to_rounding;
  const auto resolution = s["growth_resolution"].get<double>();
  std::string text = fmt::format(
      "{}: {} unknowns, {} eigenvalues; values are (omega d/c_p)^2, rates c_p/d, d/c_p = {:.4g} s\n"
      "  rigid motions           {} (residual {:.1e})\n",
      s["scene"].get<std::string>(), s["unknowns"].get<long>(),
      s["complete"].get<bool>() ? "all" : "the lowest, the largest and the fastest growing",
      s["time_unit_s"].get<double>(), s["rigid"].get<int>(), s["rigid_residual"].get<double>());
  text += smooth_text(s);
  text += s["lowest_nonrigid"].is_null()
              ? std::string("  lowest not rigid        none\n")
              : fmt::format("  lowest not rigid        {:.6g}\n", s["lowest_nonrigid"].get<double>());
  text += fmt::format(
      "  largest                 {:.6g}: steps up to {:.4g} s, cfl {:.4g}\n"
      "  complex pairs           {} (largest imaginary part {:.1e} of the largest), negative {}\n"
      "  growth                  {:.6g} with dissipation, {:.6g} without{}\n",
      s["largest"].get<double>(), s["stable_step_s"].get<double>(), s["stable_cfl"].get<double>(),
      count_text(s["complex_pairs"], partial), s["largest_imaginary"].get<double>(),
      count_text(s["negative"], partial), s["growth_rate"].get<double>(),
      s["growth_rate_undamped"].get<double>(),
      resolution > 0 ? fmt::format("; below {:.1g} it may be missed", resolution) : "");
  return text + modes_text(s["modes"]);
}

template <int d>
Json worst_mode(const Spectrum& spectrum, const LinearOperator<d>& op) {
  if (spectrum.low.modes.empty()) return {};
  const Mode& mode = spectrum.low.modes.front();
  const Cloud<d>& cloud = op.solid().cloud;
  const std::vector<double> motion = motion_of(mode, op, 1);
  std::vector<std::vector<double>> X, u;
  for (Index i = 0; i < cloud.size(); ++i) {
    X.emplace_back(cloud.X[i].data(), cloud.X[i].data() + d);
    u.emplace_back(motion.begin() + i * d, motion.begin() + (i + 1) * d);
  }
  return {{"value", mode.value},
          {"unexplained", mode.unexplained},
          {"spurious", mode.spurious()},
          {"spacing", cloud.spacing},
          {"X", X},
          {"u", u}};
}

template <int d>
void write_modes(const Spectrum& spectrum, const LinearOperator<d>& op, int listed,
                 const std::filesystem::path& folder) {
  const Cloud<d>& cloud = op.solid().cloud;
  std::vector<double> positions;
  for (const auto& X : cloud.X) positions.insert(positions.end(), X.data(), X.data() + d);
  ParticleSeries series(folder, "modes");
  for (const Mode* mode : listed_modes(spectrum, listed)) {
    const std::vector<double> motion = motion_of(*mode, op, cloud.spacing),
                              hz(cloud.X.size(), hertz(*mode, op.time_unit()));
    const std::vector<double> shown = padded_to_three(motion, d);
    const std::array<PointField, 2> fields{{{"displacement [m]", 3, shown}, {"frequency [Hz]", 1, hz}}};
    series.write({static_cast<double>(series.size() + 1), d, positions, fields});
  }
}

#define PLUMB_INSTANTIATE(d)                                              \
  template Json worst_mode<d>(const Spectrum&, const LinearOperator<d>&); \
  template void write_modes<d>(const Spectrum&, const LinearOperator<d>&, int, const std::filesystem::path&);
PLUMB_INSTANTIATE(1)
PLUMB_INSTANTIATE(2)
PLUMB_INSTANTIATE(3)
#undef PLUMB_INSTANTIATE

}  // namespace plumb::app
