#include "lib/run/recorder.hpp"

#include <fmt/format.h>

#include <cmath>

#include "lib/measures/body_units.hpp"
#include "lib/run/frame.hpp"

namespace plumb {
namespace {

constexpr const char* axes = "xyz";

template <int d>
void add_columns(std::vector<std::string>& columns, const std::string& name, const std::string& unit) {
  for (int k = 0; k < d; ++k) columns.push_back(fmt::format("{} {} [{}]", name, axes[k], unit));
}

template <int d>
void add_values(std::vector<double>& row, const Vec<d>& v) {
  row.insert(row.end(), v.data(), v.data() + d);
}

}  // namespace

template <int d>
Recorder<d>::Recorder(const Output& output, std::filesystem::path folder, const Simulation<d>& simulation,
                      const RunRecord* from)
    : output_(output), folder_(std::move(folder)) {
  if (!output_.probes.empty()) probes_ = bind_probes<d>(output_.probes, simulation.snapshot().X);
  if (output_.vtk || output_.series) std::filesystem::create_directories(folder_);
  const auto series = folder_ / "series.csv";
  if (output_.series)
    series_ = from ? std::make_unique<CsvSeries>(series, columns(simulation), from->series_bytes)
                   : std::make_unique<CsvSeries>(series, columns(simulation));
  if (output_.vtk) particles_.emplace(folder_, "particles");
  if (!from) return;
  if (particles_) particles_->resume(from->particle_times);
  next_ = static_cast<long>(from->next_row);
  recorded_ = static_cast<long>(from->recorded_step);
}

template <int d>
std::vector<std::string> Recorder<d>::columns(const Simulation<d>& simulation) const {
  using Units = BodyUnits<d>;
  std::vector<std::string> names{"step", "time [s]"};
  std::vector<std::string> energies{"kinetic", "strain"};
  energies.insert(energies.end(), simulation.energy_names.begin(), simulation.energy_names.end());
  energies.emplace_back("total");
  for (const auto& energy : energies) names.push_back(fmt::format("{} energy [{}]", energy, Units::energy));
  add_columns<d>(names, "linear momentum", Units::linear_momentum);
  for (int k = Units::first_angular; k < 3; ++k)
    names.push_back(fmt::format("angular momentum {} [{}]", axes[k], Units::angular_momentum));
  if (simulation.hourglass_share) names.emplace_back("hourglass share");
  for (const auto& probe : probes_) {
    add_columns<d>(names, probe.name + " position", "m");
    add_columns<d>(names, probe.name + " displacement", "m");
    add_columns<d>(names, probe.name + " velocity", "m/s");
    for (const auto& name : output_.fields)
      for (const auto& column : probe_columns<d>(name)) names.push_back(probe.name + " " + column);
  }
  if (simulation.reactions)
    for (const auto& [boundary, force] : simulation.reactions())
      add_columns<d>(names, "reaction " + boundary, Units::force);
  if (simulation.load_factor) names.emplace_back("load factor");
  return names;
}

template <int d>
void Recorder<d>::observe(const Simulation<d>& simulation) {
  if (!series_ && !particles_) return;
  const double time = simulation.steps.now().time;
  const bool first = recorded_ < 0;
  // 1e-12: a step that ends on the multiple but for rounding counts
  const bool due = output_.every && time >= static_cast<double>(next_) * *output_.every * (1 - 1e-12);
  if (!first && !due) return;
  if (output_.every) next_ = static_cast<long>(std::floor(time / *output_.every * (1 + 1e-12))) + 1;
  record(simulation);
}

template <int d>
void Recorder<d>::finish(const Simulation<d>& simulation) {
  if (simulation.steps.now().step != recorded_) record(simulation);
  if (particles_) particles_->finish();
  if (series_) series_->flush();
}

template <int d>
void Recorder<d>::record(const Simulation<d>& simulation) {
  if (series_) record_series(simulation);
  if (particles_) Frame<d>(simulation.snapshot(), output_.fields).write(*particles_);
  recorded_ = simulation.steps.now().step;
}

template <int d>
void Recorder<d>::record_series(const Simulation<d>& simulation) {
  const auto [time, step] = simulation.steps.now();
  const Energy energy = simulation.energy();
  const Momentum momentum = simulation.momentum();
  std::vector<double> row{static_cast<double>(step), time, energy.kinetic, energy.strain};
  for (const auto& more : energy.more) row.push_back(more.value);
  row.push_back(energy.total());
  row.insert(row.end(), momentum.linear.begin(), momentum.linear.begin() + d);
  row.insert(row.end(), momentum.angular.begin() + BodyUnits<d>::first_angular, momentum.angular.end());
  if (simulation.hourglass_share) row.push_back(simulation.hourglass_share());
  for (const auto& probe : probes_) {
    const PointView<d> at = simulation.at(probe.particle);
    add_values<d>(row, at.x);
    add_values<d>(row, at.u);
    add_values<d>(row, at.v);
    for (const auto& name : output_.fields) {
      const auto values = probe_values<d>(name, at);
      row.insert(row.end(), values.begin(), values.end());
    }
  }
  if (simulation.reactions)
    for (const auto& [boundary, force] : simulation.reactions()) add_values<d>(row, force);
  if (simulation.load_factor) row.push_back(simulation.load_factor());
  series_->append(row);
}

template <int d>
void Recorder<d>::note(RunRecord& record) {
  record.next_row = next_;
  record.recorded_step = recorded_;
  record.series_bytes = series_ ? series_->flush() : 0;
  if (!particles_) return;
  particles_->flush();
  record.particle_times = particles_->times();
}

template <int d>
std::vector<std::filesystem::path> Recorder<d>::files() const {
  std::vector<std::filesystem::path> names;
  if (series_) names.push_back(folder_ / "series.csv");
  if (particles_) names.push_back(particles_->index_file());
  return names;
}

template class Recorder<1>;
template class Recorder<2>;
template class Recorder<3>;

}  // namespace plumb
