#include "lib/spectrum/own_step.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <random>

#include "lib/core/error.hpp"
#include "lib/linear/dense.hpp"

namespace plumb {
namespace {

/// A disturbance relative to the scales: its square, and the rounding of 1 divided by it, are both 1e-10.
constexpr double disturbance = 1e-5;
/// Velocities of the start in spacings a step: far below the disturbance, as the stress that they leave turns the body's
/// rigid rotation into a slow motion of the rate of its root.
constexpr double preparation = 1e-12;
/// What a step leaves less of than this is no oscillation: rounding makes such factors of 0.
constexpr double least_factor = 1e-2;
/// J is known to some 1e-9, and factors to the root of that where two of them meet, as those of rigid motions do.
const double factor_error = std::sqrt(1e-9);

/// The size of a disturbance of one unit.
double scale_of(const SavedField& field, const StateScales& s, int d) {
  const double stress = s.density * s.speed * s.speed, time = s.length / s.speed;
  const std::map<std::string, double> of_unit = {{"m", s.length},
                                                 {"m/s", s.speed},
                                                 {"m/s^2", s.speed / time},
                                                 {"1/s", 1 / time},
                                                 {"kg/m^3", s.density},
                                                 {"kg/(m^3 s)", s.density / time},
                                                 {"Pa", stress},
                                                 {"J/m^3", stress},
                                                 {"N", stress * std::pow(s.length, d - 1)},
                                                 {"J", stress * std::pow(s.length, d)},
                                                 {"m^d", std::pow(s.length, d)}};
  if (field.of == KeptFor::pairs) return s.length;
  const auto found = of_unit.find(field.unit);
  return found == of_unit.end() ? 1 : found->second;
}

/// One number of the state that is disturbed.
struct Number {
  std::size_t field, at;  ///< in the fields, in its values
  double scale;
};

/// The numbers of a state, those of pairs as (particle, particle) -> number.
class Numbers {
 public:
  Numbers(const SavedState& state, const StateScales& scales, int d) {
    for (std::size_t f = 0; f < state.fields.size(); ++f) {
      const SavedField& field = state.fields[f];
      if (field.of == KeptFor::body) continue;
      const std::size_t stride = field.of == KeptFor::pairs ? 3 : 1;
      for (std::size_t n = stride - 1; n < field.values.size(); n += stride)
        numbers_.push_back({f, n, scale_of(field, scales, d)});
    }
  }

  Index size() const { return static_cast<Index>(numbers_.size()); }
  const Number& operator[](Index n) const { return numbers_[static_cast<std::size_t>(n)]; }

  /// The scaled numbers of a state whose fields are those of `base`. Pairs that `base` has not are left out.
  Eigen::VectorXd read(const SavedState& base, const SavedState& state) const {
    Eigen::VectorXd values(size());
    std::size_t field = state.fields.size();
    std::map<std::pair<double, double>, double> pairs;
    for (Index n = 0; n < size(); ++n) {
      const Number& number = (*this)[n];
      const std::vector<double>& from = state.fields[number.field].values;
      if (base.fields[number.field].of != KeptFor::pairs) {
        values[n] = from[number.at] / number.scale;
        continue;
      }
      if (field != number.field) {
        field = number.field;
        pairs.clear();
        for (std::size_t k = 0; k + 2 < from.size(); k += 3) pairs[{from[k], from[k + 1]}] = from[k + 2];
      }
      const std::vector<double>& own = base.fields[number.field].values;
      const auto found = pairs.find({own[number.at - 2], own[number.at - 1]});
      values[n] = found == pairs.end() ? 0 : found->second / number.scale;
    }
    return values;
  }

 private:
  std::vector<Number> numbers_;
};

template <int d>
SavedState stepped(Simulation<d>& simulation, const SavedState& from, double dt) {
  simulation.restore(from);
  if (const auto failure = simulation.steps.advance(dt))
    throw InputError("a step of the disturbed body fails",
                     fmt::format("{}: {}{}", name_of(failure->cause), failure->quantity,
                                 failure->value ? fmt::format(" becomes {:g}", *failure->value) : ""),
                     "see plumb run, or look at an earlier state");
  return simulation.save();
}

/// Small random velocities, and a step: all that is kept of pairs is not zero then.
template <int d>
SavedState disturbed(Simulation<d>& simulation, const StateScales& scales, double dt) {
  SavedState state = simulation.save();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(-1, 1);
  for (SavedField& field : state.fields)
    if (field.name == "velocity")
      for (double& value : field.values) value += preparation * scales.length / dt * share(random);
  return stepped(simulation, state, dt);
}

/// Fields that act on each other, through others too, as lists of the numbers of each such group.
std::vector<std::vector<Index>> groups_of(const Eigen::MatrixXd& J, const Numbers& numbers,
                                          std::size_t fields) {
  constexpr double nothing = 1e-8;  // beside the 1 of what stays as it is: rounding of differences
  Eigen::MatrixXi acts = Eigen::MatrixXi::Identity(static_cast<Index>(fields), static_cast<Index>(fields));
  for (Index a = 0; a < J.rows(); ++a)
    for (Index b = 0; b < J.cols(); ++b)
      if (std::abs(J(a, b)) > nothing)
        acts(static_cast<Index>(numbers[a].field), static_cast<Index>(numbers[b].field)) = 1;
  for (std::size_t n = 1; n < fields; n *= 2) acts = (acts * acts).cwiseMin(1).eval();
  std::map<Index, std::vector<Index>> groups;  // by the first field of each
  for (Index n = 0; n < numbers.size(); ++n) {
    const auto field = static_cast<Index>(numbers[n].field);
    Index first = 0;
    while (!(acts(field, first) && acts(first, field))) ++first;
    groups[first].push_back(n);
  }
  std::vector<std::vector<Index>> lists;
  for (auto& [first, list] : groups) lists.push_back(std::move(list));
  return lists;
}

void judge(StepSpectrum& spectrum) {
  const double dt = spectrum.time_step;
  spectrum.resolution = factor_error / dt;
  for (const std::complex<double>& factor : spectrum.factors) {
    const double rate = std::log(std::abs(factor)) / dt,
                 angle = std::abs(std::arg(factor));  // -inf where nothing stays
    if (std::abs(factor) > least_factor) spectrum.fastest = std::max(spectrum.fastest, angle / dt);
    if (!(rate > spectrum.resolution)) continue;
    ++spectrum.growing;
    spectrum.growth = std::max(spectrum.growth, rate);
    if (angle < factor_error) spectrum.growth_aperiodic = std::max(spectrum.growth_aperiodic, rate);
  }
}

}  // namespace

template <int d>
StepSpectrum spectrum_of_step(Simulation<d>& simulation, const StateScales& scales, Index most) {
  StepSpectrum spectrum;
  spectrum.time_step = simulation.steps.allowed();
  const double dt = spectrum.time_step;
  const SavedState base = disturbed(simulation, scales, dt);
  const Numbers numbers(base, scales, d);
  if (numbers.size() > most)
    throw InputError(fmt::format("a state of {} numbers", numbers.size()),
                     fmt::format("the spectrum of a step is found for at most {}", most),
                     "use a coarser body");
  Eigen::MatrixXd J(numbers.size(), numbers.size());
  for (Index n = 0; n < numbers.size(); ++n) {
    const auto moved = [&](double by) {
      SavedState state = base;
      state.fields[numbers[n].field].values[numbers[n].at] += by * numbers[n].scale;
      return numbers.read(base, stepped(simulation, state, dt));
    };
    J.col(n) = (moved(disturbance) - moved(-disturbance)) / (2 * disturbance);
  }
  std::vector<std::complex<double>> factors;
  for (const auto& list : groups_of(J, numbers, base.fields.size())) {
    const Eigen::MatrixXd own = J(list, list);
    if (own.isIdentity(1e-8) || own.isZero(1e-8)) continue;
    spectrum.unknowns += own.rows();
    const Eigen::VectorXcd found = complex_values(own);
    factors.insert(factors.end(), found.begin(), found.end());
  }
  spectrum.factors = Eigen::Map<const Eigen::VectorXcd>(factors.data(), static_cast<Index>(factors.size()));
  judge(spectrum);
  return spectrum;
}

template StepSpectrum spectrum_of_step<1>(Simulation<1>&, const StateScales&, Index);
template StepSpectrum spectrum_of_step<2>(Simulation<2>&, const StateScales&, Index);
template StepSpectrum spectrum_of_step<3>(Simulation<3>&, const StateScales&, Index);

}  // namespace plumb
