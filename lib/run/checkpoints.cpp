#include "lib/run/checkpoints.hpp"

#include <fmt/format.h>

#include <cmath>

#include "lib/core/error.hpp"
#include "lib/output/file.hpp"

namespace plumb {

template <int d>
RunRecord begin_record(const Simulation<d>& simulation) {
  RunRecord record;
  record.initial_energy = simulation.energy().total();
  record.initial_momentum = simulation.momentum();
  return record;
}

template <int d>
RunRecord restore(const Checkpoint& checkpoint, Simulation<d>& simulation) {
  simulation.restore(checkpoint.state);
  return checkpoint.record;
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
void Checkpoints<d>::write(const Simulation<d>& simulation, const RunRecord& record) {
  const Checkpoint checkpoint{program_, scene_, d, simulation.save(), record};
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

template RunRecord begin_record<1>(const Simulation<1>&);
template RunRecord begin_record<2>(const Simulation<2>&);
template RunRecord begin_record<3>(const Simulation<3>&);
template RunRecord restore<1>(const Checkpoint&, Simulation<1>&);
template RunRecord restore<2>(const Checkpoint&, Simulation<2>&);
template RunRecord restore<3>(const Checkpoint&, Simulation<3>&);
template class Checkpoints<1>;
template class Checkpoints<2>;
template class Checkpoints<3>;

}  // namespace plumb
