#include "lib/run/checkpoint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

#include "lib/core/error.hpp"
#include "lib/output/file.hpp"
#include "lib/output/hdf5_image.hpp"
#include "lib/output/sealed.hpp"

namespace plumb {
namespace {

/// One "key<tab>value" a line; neither holds a tab or an end of line.
std::string text_of(const std::map<std::string, std::string>& scene) {
  std::string text;
  for (const auto& [key, value] : scene) text.append(key).append("\t").append(value).append("\n");
  return text;
}

std::map<std::string, std::string> choices_of(const std::string& text) {
  std::map<std::string, std::string> scene;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const auto tab = line.find('\t');
    if (tab == std::string::npos) throw InputError("a line of the scene has no key", "", "");
    scene[line.substr(0, tab)] = line.substr(tab + 1);
  }
  return scene;
}

bool finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

std::size_t records_of(const SavedField& field) {
  return field.values.size() / static_cast<std::size_t>(field.components);
}

/// One "name<tab>components" a line.
std::string text_of(const std::vector<SavedField>& fields) {
  std::string text;
  for (const auto& field : fields) text += fmt::format("{}\t{}\n", field.name, field.components);
  return text;
}

/// The fields that the text lists, with their values.
std::vector<SavedField> fields_of(const Hdf5Image& file) {
  std::vector<SavedField> fields;
  for (const auto& [name, components] : choices_of(file.text("fields"))) {
    const int count = std::atoi(components.c_str());
    if (count < 1) throw InputError(fmt::format("field {} has no components", name), "", "");
    fields.push_back({name, count, file.numbers(name.c_str())});
  }
  return fields;
}

void require_consistent(const Checkpoint& c) {
  const auto require = [](bool holds, const std::string& problem) {
    if (!holds) throw InputError(problem, "", "");
  };
  require(c.dimension >= 1 && c.dimension <= 3, "the dimension is not 1, 2 or 3");
  require(!c.state.fields.empty() && !c.state.fields.front().values.empty(), "there are no particles");
  const auto particles = records_of(c.state.fields.front());
  for (const auto& field : c.state.fields)
    require(field.values.size() % static_cast<std::size_t>(field.components) == 0 &&
                (records_of(field) == particles || records_of(field) == 1),
            fmt::format("{} and {} differ in size", c.state.fields.front().name, field.name));
  require(is_finite(c), "the state is not finite");
  require(c.state.now.step >= 0, "the step is negative");
}

void write(const Hdf5Image& file, const Checkpoint& c) {
  const RunRecord& r = c.record;
  file.write("program", c.program);
  file.write("scene", text_of(c.scene));
  file.write("dimension and step", std::vector<std::int64_t>{c.dimension, c.state.now.step});
  file.write("time", std::vector<double>{c.state.now.time});
  file.write("fields", text_of(c.state.fields));
  for (const auto& field : c.state.fields)
    file.write(field.name.c_str(), field.values, static_cast<std::size_t>(field.components));
  file.write("time steps", std::vector<double>{r.dt.first, r.dt.least, r.dt.most, r.dt.last});
  if (r.initial_energy) file.write("initial energy", std::vector<double>{*r.initial_energy});
  const Momentum& p = r.initial_momentum;
  file.write("initial momentum",
             std::vector<double>{p.linear[0], p.linear[1], p.linear[2], p.angular[0], p.angular[1],
                                 p.angular[2], p.linear_scale, p.angular_scale});
  file.write("work",
             std::vector<std::int64_t>{c.state.work.particle_evaluations, c.state.work.pair_evaluations});
  file.write("seconds", std::vector<double>{r.wall_s, r.cpu_s, r.writing_s});
  file.write("recorder", std::vector<std::int64_t>{r.next_row, r.recorded_step, r.series_bytes});
  if (!r.particle_times.empty()) file.write("particle times", r.particle_times);
}

Checkpoint read(const Hdf5Image& file) {
  Checkpoint c;
  c.program = file.text("program");
  c.scene = choices_of(file.text("scene"));
  const auto whole = file.integers("dimension and step", 2);
  c.dimension = whole[0], c.state.now.step = whole[1];
  c.state.now.time = file.numbers("time", 1)[0];
  c.state.fields = fields_of(file);
  const auto dt = file.numbers("time steps", 4);
  RunRecord& r = c.record;
  r.dt = {dt[0], dt[1], dt[2], dt[3]};
  if (file.has("initial energy")) r.initial_energy = file.numbers("initial energy", 1)[0];
  const auto p = file.numbers("initial momentum", 8);
  r.initial_momentum = {{p[0], p[1], p[2]}, {p[3], p[4], p[5]}, p[6], p[7]};
  const auto work = file.integers("work", 2);
  c.state.work = {work[0], work[1]};
  const auto seconds = file.numbers("seconds", 3);
  r.wall_s = seconds[0], r.cpu_s = seconds[1], r.writing_s = seconds[2];
  const auto files = file.integers("recorder", 3);
  r.next_row = files[0], r.recorded_step = files[1], r.series_bytes = files[2];
  if (file.has("particle times")) r.particle_times = file.numbers("particle times");
  return c;
}

/// "material.young is 18 MPa here and 17 MPa there", one for each setting that differs.
std::vector<std::string> differences(const std::map<std::string, std::string>& here,
                                     const std::map<std::string, std::string>& there) {
  std::vector<std::string> found;
  for (const auto& [key, value] : here) {
    const auto other = there.find(key);
    if (other == there.end())
      found.push_back(fmt::format("{} = {} is not in it", key, value));
    else if (other->second != value)
      found.push_back(fmt::format("{} is {} here and {} there", key, value, other->second));
  }
  for (const auto& [key, value] : there)
    if (!here.contains(key)) found.push_back(fmt::format("it has {} = {}", key, value));
  return found;
}

}  // namespace

bool is_finite(const Checkpoint& c) {
  return std::isfinite(c.state.now.time) &&
         std::all_of(c.state.fields.begin(), c.state.fields.end(),
                     [](const auto& field) { return finite(field.values); });
}

std::string bytes_of(const Checkpoint& checkpoint) {
  Hdf5Image file;
  write(file, checkpoint);
  return sealed(file.bytes());
}

Checkpoint checkpoint_of(std::string_view bytes, const std::string& name) {
  try {
    Checkpoint checkpoint = read(Hdf5Image(unsealed(bytes)));
    require_consistent(checkpoint);
    return checkpoint;
  } catch (const InputError& error) {
    throw InputError(fmt::format("{} cannot be used: {}", name, error.problem()), error.why(),
                     "start the run anew, without --resume");
  }
}

void write_checkpoint(const std::filesystem::path& file, const Checkpoint& checkpoint) {
  replace_file(file, bytes_of(checkpoint));
}

Checkpoint read_checkpoint(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream content;
  if (std::filesystem::is_regular_file(file)) content << in.rdbuf();
  if (!in || content.view().empty())
    throw InputError(fmt::format("there is no checkpoint {}", file.string()),
                     std::strerror(errno ? errno : ENOENT), "start the run without --resume");
  return checkpoint_of(content.view(), file.string());
}

void require_same_settings(const std::string& name, const std::map<std::string, std::string>& here,
                           const std::map<std::string, std::string>& there) {
  const auto found = differences(here, there);
  if (!found.empty())
    throw InputError(name + " belongs to another scene", join(found, "; "),
                     "start the run anew, without --resume");
}

void require_same_origin(const Checkpoint& checkpoint, const std::string& program,
                         const std::map<std::string, std::string>& scene, const std::string& name) {
  if (checkpoint.program != program)
    throw InputError(name + " was written by another version",
                     fmt::format("{}; this is {}", checkpoint.program, program),
                     "start the run anew, without --resume");
  require_same_settings(name, scene, checkpoint.scene);
}

}  // namespace plumb
