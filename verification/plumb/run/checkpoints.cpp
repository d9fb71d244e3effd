#include "plumb/run/checkpoints.hpp"

#include <fmt/format.h>

#include <cmath>

#include "plumbline/core/error.hpp"
#include "plumbline/output/file.hpp"

namespace plumb {
namespace {

/// Component by component on slots to particle by particle, and back.
template <int d>
std::vector<double> gathered(const Solid<d>& solid, const Field& field) {
  std::vector<double> values(static_cast<std::size_t>(solid.cloud.size()) * d);
  for (Index i = 0; i < solid.cloud.size(); ++i)
    for (int k = 0; k < d; ++k) values[i * d + k] = field[k][solid.bonds.slots.of(i)];
  return values;
}

template <int d>
void scatter(const Solid<d>& solid, const std::vector<double>& values, Field& field) {
  for (Index i = 0; i < solid.cloud.size(); ++i)
    for (int k = 0; k < d; ++k) field[k][solid.bonds.slots.of(i)] = values[i * d + k];
}

}  // namespace

template <int d>
RunBook begin_book(const Simulation<d>& simulation) {
  RunBook book;
  book.initial_energy = energy_of(simulation.solid, simulation.state);
  book.initial_momentum = momentum_of(simulation.solid, simulation.state);
  book.history.initial_energy = book.initial_energy.total();
  return book;
}

template <int d>
RunBook restore(const Checkpoint& c, Simulation<d>& simulation) {
  Solid<d>& solid = simulation.solid;
  if (c.displacement.size() != static_cast<std::size_t>(solid.cloud.size()) * d)
    throw InputError("the checkpoint has another number of particles",
                     fmt::format("{}, the scene {}", c.displacement.size() / d, solid.cloud.size()), "");
  scatter<d>(solid, c.displacement, simulation.state.u);
  scatter<d>(solid, c.velocity, simulation.state.v);
  simulation.state.time = c.time;
  simulation.state.step = static_cast<long>(c.step);
  if (!c.carried.empty() && simulation.stepper.carry) {
    Field carried = solid.make_field(d);
    scatter<d>(solid, c.carried, carried);
    simulation.stepper.carry(carried);
  }
  solid.work = c.work;
  RunBook book{c.initial_energy, c.initial_momentum, {}, {}, c.support_work, c.support_power};
  book.timing = {.setup = 0, .wall = c.wall, .cpu = c.cpu, .writing = c.writing};
  book.history = {c.dt, c.initial_energy.total()};
  return book;
}

template <int d>
Checkpoints<d>::Checkpoints(std::filesystem::path file, std::optional<double> interval, std::string program,
                            std::map<std::string, std::string> scene)
    : file_(std::move(file)), interval_(interval), program_(std::move(program)), scene_(std::move(scene)) {}

template <int d>
bool Checkpoints<d>::due(double time) {
  if (!interval_) return false;
  // 1e-12: a step that ends on the multiple but for rounding counts
  const long reached = static_cast<long>(std::floor(time / *interval_ * (1 + 1e-12)));
  const bool now = next_ >= 0 && reached >= next_;
  next_ = reached + 1;
  return now;
}

template <int d>
void Checkpoints<d>::write(const Simulation<d>& simulation, const RunBook& book,
                           const RecorderMark& recorder) {
  const Solid<d>& solid = simulation.solid;
  const Field* carried = simulation.stepper.carried ? simulation.stepper.carried() : nullptr;
  const Checkpoint checkpoint{program_,
                              scene_,
                              d,
                              simulation.state.step,
                              simulation.state.time,
                              gathered<d>(solid, simulation.state.u),
                              gathered<d>(solid, simulation.state.v),
                              carried ? gathered<d>(solid, *carried) : std::vector<double>{},
                              book.history.dt,
                              book.initial_energy,
                              book.initial_momentum,
                              solid.work,
                              book.timing.wall,
                              book.timing.cpu,
                              book.timing.writing,
                              recorder,
                              book.support_work,
                              book.support_power};
  if (!is_finite(checkpoint)) return;
  try {
    write_checkpoint(file_, checkpoint);
  } catch (const OutputError& error) {
    const bool kept = std::filesystem::exists(file_);
    throw OutputError(
        fmt::format("{}; {}", error.what(),
                    kept ? "the checkpoint before it is intact: make room and continue with --resume"
                         : "there is no checkpoint yet"));
  }
}

template RunBook begin_book<2>(const Simulation<2>&);
template RunBook begin_book<3>(const Simulation<3>&);
template RunBook restore<2>(const Checkpoint&, Simulation<2>&);
template RunBook restore<3>(const Checkpoint&, Simulation<3>&);
template class Checkpoints<2>;
template class Checkpoints<3>;

}  // namespace plumb
