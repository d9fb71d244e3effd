#pragma once
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "lib/output/particles.hpp"
#include "reports/results.hpp"

/// Results of studies that were never run: every number in them is another one, so that a number in a picture
/// says which study, row and column it was taken from.
namespace plumb::test {

using Json = nlohmann::ordered_json;
using Words = std::map<std::string, std::string>;

/// A row of a result: what it belongs to, and its numbers by column.
struct InventedRow {
  std::string job;
  Words words;
  std::map<std::string, double> numbers;
};

/// Where a number stands.
struct Origin {
  std::shared_ptr<const InventedRow> row;
  std::string column;
};

inline std::vector<std::string> split(const std::string& text, char by) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, by);) parts.push_back(part);
  return parts;
}

/// The options of a call: "--set key=value" as key, "--pair W0,W1" as pair.
inline Words words_of(const reports::Job& job) {
  Words words{{"command", job.arguments[0]}};
  const auto& a = job.arguments;
  for (std::size_t k = 1; k < a.size(); ++k) {
    if (a[k].ends_with(".toml")) words["file"] = a[k].substr(a[k].rfind('/') + 1);
    if (!a[k].starts_with("--")) continue;
    const std::string value = k + 1 < a.size() && !a[k + 1].starts_with("--") ? a[k + 1] : "";
    if (a[k] == "--set")
      words[value.substr(0, value.find('='))] = value.substr(value.find('=') + 1);
    else if (a[k] == "--over" || a[k] == "--vary" || a[k] == "--field")
      words[a[k]] += (words[a[k]].empty() ? "" : ";") + value;
    else
      words[a[k]] = value;
  }
  return words;
}

/// Every combination of "key=a,b;other=c,d" as key and value.
inline std::vector<Words> combinations(const std::string& axes) {
  std::vector<Words> all{{}};
  for (const auto& axis : split(axes, ';')) {
    std::vector<Words> longer;
    for (const auto& words : all)
      for (const auto& value : split(axis.substr(axis.find('=') + 1), ',')) {
        longer.push_back(words);
        longer.back()[axis.substr(0, axis.find('='))] = value;
      }
    all = longer;
  }
  return all;
}

class Invention {
 public:
  explicit Invention(std::filesystem::path folder) : folder_(std::move(folder)) {}

  reports::Results results;
  std::map<double, Origin> origins;

  /// A result of the job, as far as the pictures of the report need one.
  void add(const reports::Job& job);

 private:
  /// A number that no other place has, between 0.1 and 1.
  double number() {
    constexpr double golden = 0.6180339887498949;
    position_ = std::fmod(position_ + golden, 1.0);
    return 0.1 + 0.9 * position_;
  }
  std::shared_ptr<InventedRow> start_row() const {
    auto row = std::make_shared<InventedRow>();
    row->job = job_;
    return row;
  }
  double invent(const std::shared_ptr<InventedRow>& row, const std::string& column) {
    const double value = number();
    row->numbers[column] = value;
    origins[value] = {row, column};
    return value;
  }
  /// A row of JSON: `given` as it is, and an invented number in each column.
  Json row(const Json& given, const std::vector<std::string>& columns) {
    auto made = start_row();
    for (const auto& [key, value] : given.items()) {
      if (value.is_string()) made->words[key] = value.get<std::string>();
      if (value.is_number()) made->numbers[key] = value.get<double>();
    }
    Json out = given;
    for (const auto& column : columns) out[column] = invent(made, column);
    return out;
  }
  Json fit(const Json& given) {
    Json out = row(given, {"order", "low", "high"});
    out["ci95"] = {out["low"], out["high"]};
    out.update({{"pairwise", {2, 2}}, {"drift", 0}, {"levels", 4}, {"declared", 2}, {"verdict", "pass"}});
    return out;
  }
  void write_table(const std::string& file, const std::vector<std::string>& columns) {
    std::ofstream out(place_ / file);
    out.precision(17);
    for (std::size_t k = 0; k < columns.size(); ++k) out << (k ? "," : "") << columns[k];
    for (int n = 0; n < 5; ++n) {
      const auto made = start_row();
      out << '\n';
      for (std::size_t k = 0; k < columns.size(); ++k) out << (k ? "," : "") << invent(made, columns[k]);
    }
    out << '\n';
  }
  /// A tip that comes and goes three times.
  void write_swing() {
    std::ofstream out(place_ / "series.csv");
    out.precision(17);
    const double size = number();  // no two jobs have the same
    const std::array<std::string, 3> columns{"time [s]", "tip displacement x [m]", "tip displacement y [m]"};
    out << fmt::format("{}\n", fmt::join(columns, ","));
    for (int n = 0; n <= 60; ++n) {
      const auto made = start_row();
      const double t = 0.05 * n, swing = std::cos(6.3 * t) - 1.1;
      const std::array<double, 3> values{t, 0.014 * size * swing, 0.065 * size * swing};
      for (std::size_t k = 0; k < 3; ++k) {
        made->numbers[columns[k]] = values[k];
        if (k > 0) origins[values[k]] = {made, columns[k]};
        out << (k ? "," : "") << values[k];
      }
      out << '\n';
    }
  }
  Json oned(const Words& w);
  Json refinement(const Words& w);
  Json work_precision(const Words& w);
  Json spectrum(const Words& w);
  Json bench(const Words& w);
  Json run(const Words& w);
  Json campaign();
  void write_particles(bool plane, bool moves);

  std::filesystem::path folder_, place_;
  std::string job_;
  double position_ = 0.3;
};

inline void Invention::add(const reports::Job& job) {
  job_ = job.id;
  place_ = folder_ / job.id;
  std::filesystem::create_directories(place_);
  const Words words = words_of(job);
  const std::string command = job.arguments[0];
  Json json;
  if (command == "oned") json = oned(words_of({job.id, {job.arguments.begin() + 1, job.arguments.end()}}));
  if (command == "mms") json = words.contains("--work-precision") ? work_precision(words) : refinement(words);
  if (command == "static" || command == "operators") json = refinement(words);
  if (command == "spectrum") json = spectrum(words);
  if (command == "bench") json = bench(words);
  if (command == "run") json = run(words);
  if (command == "campaign") json = campaign();
  std::ofstream(place_ / "result.json") << json.dump();
  reports::JobResult result;
  result.command = "plumb";
  result.folder = place_;
  results.add(job.id, result);
}

inline Json Invention::oned(const Words& w) {
  const std::string command = w.at("command");
  const auto list = [&](const char* option) { return split(w.at(option), ','); };
  Json rows = Json::array(), fits = Json::array();
  if (command == "kernels") {
    for (int n = 0; n < 5; ++n)
      rows.push_back(
          row({{"x", 0.01 * n}}, {"W", "W0", "W1", "gradW", "LgradW", "gradW0", "LgradW0", "gradW1"}));
    return {{"rows", rows},
            {"sums", row({}, {"VW1", "VXW1", "VgradW1", "VXgradW1", "VLgradW0", "VXLgradW0"})}};
  }
  for (const auto& estimator : list("--estimator"))
    for (const auto& pair : list("--pair"))
      for (const auto& field : w.contains("--field") ? split(w.at("--field"), ';') : split("none", ';')) {
        const Json what{{"estimator", estimator}, {"pair", pair}, {"field", field}};
        const auto with = [&](const char* key, double value) {
          Json given = what;
          given[key] = value;
          return given;
        };
        if (command == "gradient")
          for (int n = 0; n < 40; ++n)
            rows.push_back(row(with("X", (n + 0.5) / 8), {"exact", "value", "error"}));
        if (command == "response")
          for (int n = 1; n < 6; ++n) rows.push_back(row(with("theta", 0.6 * n), {"value"}));
        if (command != "study") continue;
        for (const auto& n : list("--n"))
          rows.push_back(row(with("n", std::stod(n)),
                             {"dx", "rmse", "max", "interior_rmse", "interior_max", "boundary_max"}));
        for (const char* norm : {"rmse", "interior_rmse"}) {
          Json given = what;
          given["norm"] = norm;
          fits.push_back(fit(given));
        }
      }
  return {{"rows", rows}, {"fits", fits}};
}

inline Json Invention::refinement(const Words& w) {
  if (w.contains("--temporal")) {
    Json rows = Json::array(), fits = Json::array();
    for (const char* name : {"verlet", "rk3"}) {
      for (int n = 0; n < 4; ++n) rows.push_back(row({{"integrator", name}}, {"dt", "l2"}));
      fits.push_back(fit({{"integrator", name}}));
    }
    return {{"rows", rows}, {"fits", fits}, {"spatial_error", 0.5}, {"units", {{"l2", "m^2"}}}};
  }
  const auto found = w.find("study.spacings");
  std::string spacings = found == w.end() ? "[0.2,0.1,0.05,0.025]" : found->second;
  spacings = spacings.substr(1, spacings.size() - 2);
  std::vector<std::string> columns{"l2",    "h1",     "linf",    "l2_gauss", "h1_gauss",         "stress_l2",
                                   "cpu_s", "wall_s", "setup_s", "solve_s",  "pair_evaluations", "steps"};
  for (const char* norm : {"l2", "h1", "linf", "l2_gauss", "velocity_l2", "stress_l2"})
    columns.push_back(std::string("relative_") + norm);
  Json levels = Json::array(), fits = Json::array();
  if (w.at("command") == "operators") {
    columns.clear();
    for (const char* name : {"f", "div_p", "laplacian", "constraint"})
      for (const char* part : {"_inside", "_boundary"}) columns.push_back(std::string(name) + part);
    for (const char* name : {"F", "Div P", "Laplacian", "constraint"})
      for (const char* part : {"inside", "boundary"})
        fits.push_back(fit({{"operator", name}, {"part", part}}));
  }
  for (const auto& d : split(spacings, ','))
    levels.push_back(row({{"d", std::stod(d)}, {"n", 100}}, columns));
  for (const char* norm : {"l2", "h1", "linf"}) fits.push_back(fit({{"norm", norm}}));
  return {{"levels", levels}, {"fits", fits}, {"status", "pass"}};
}

inline Json Invention::work_precision(const Words& w) {
  Json points = Json::array();
  for (const auto& choice : combinations(w.at("--vary"))) {
    std::string label;
    for (const auto& axis :
         split(w.at("--vary"), ';')) {  // in the order of the call, numbers with their name
      const std::string key = axis.substr(0, axis.find('=')), value = choice.at(key);
      label += label.empty() ? "" : ", ";
      if (value.find_first_not_of("0123456789.") == std::string::npos)
        label += key.substr(key.rfind('.') + 1) + " ";
      label += value;
    }
    for (const double d : {0.2, 0.1}) {
      Json given{{"method", label}, {"d", d}, {"front_cpu", d == 0.1}, {"front_work", d == 0.2}};
      for (const auto& [key, value] : choice) {
        given[key] = value;
        if (key == "material.poisson") given["1/2 - nu"] = 0.5 - std::stod(value);
      }
      points.push_back(row(given, {"error", "cpu_s", "cpu_spread_s", "wall_s", "pair_evaluations"}));
    }
  }
  Json cheapest = Json::array();
  for (const char* measure : {"cpu_s", "pair_evaluations"})
    cheapest.push_back(
        row({{"error", 0.01}, {"measure", measure}, {"method", std::string("least ") + measure}}, {"cost"}));
  return {{"threads", 1}, {"points", points}, {"cheapest", cheapest}};
}

inline Json Invention::spectrum(const Words& w) {
  Json rows = Json::array();
  const std::vector<std::string> columns{
      "rigid",    "near_zero_not_rigid", "spurious_below_smooth", "lowest_nonrigid", "lowest_smooth",
      "largest",  "stable_cfl",          "complex_pairs",         "negative",        "growth_rate",
      "asymmetry"};
  for (const auto& choice : combinations(w.contains("--over") ? w.at("--over") : "")) {
    Json given = Json::object();
    for (const auto& [key, value] : choice) given[key] = value;
    if (!w.contains("--symbol")) rows.push_back(row(given, columns));
    for (const char* direction : {"10", "11", "100", "110", "111"})
      for (int n = 1; w.contains("--symbol") && n < 5; ++n) {
        given["direction"] = direction;
        given["theta"] = 0.7 * n;
        rows.push_back(row(given, {"gradient"}));
      }
  }
  if (w.contains("--over")) return {{"rows", rows}};
  Json out = rows[0];
  out["worst"] = {{"X", {{0, 0}, {1, 0}}},
                  {"u", {{1, 0}, {0, 1}}},
                  {"spacing", 1.0},
                  {"value", 0.1},
                  {"unexplained", 0.5}};
  return out;
}

inline Json Invention::bench(const Words& w) {
  const auto found = w.find("--case");
  const std::string all =
      "adjoint-verlet-2d,paper-2d,adjoint-verlet-3d,paper-3d,adjoint-verlet-2d-jittered,adjoint-verlet-3d-jittered";
  Json rows = Json::array(), exponents = Json::object(), setup = Json::object(), by_threads = Json::array();
  for (const auto& name : split(found == w.end() ? all : found->second, ','))
    for (const int n : {8000, 64000})
      for (const int threads : {1, 2}) {
        exponents[name] = invent(start_row(), "p of a step");
        setup[name] = invent(start_row(), "p of the set-up");
        rows.push_back(row(
            {{"case", name},
             {"dimension", name.find("3d") != std::string::npos ? 3 : 2},
             {"n", n},
             {"threads", threads},
             {"kernel", "force"},
             {"cloud", "lattice"}},
            {"updates_per_cpu_s", "updates_per_wall_s", "setup_cpu_s", "setup_wall_s", "bytes_per_particle",
             "bytes_per_update", "fraction_of_fma", "fraction_of_triad", "ns_per_particle"}));
      }
  for (const int threads : {1, 2})
    by_threads.push_back(
        row({{"threads", threads}}, {"fma_gflops", "triad_gbs", "fma_speed_up", "triad_speed_up"}));
  Json machine = row({}, {"fma_gflops", "triad_gbs"});
  machine["by_threads"] = by_threads;
  const Json speed_up = row({{"case", "paper-2d"}, {"n", 8000}, {"threads", 2}}, {"speed_up"});
  return {{"rows", rows},
          {"machine", machine},
          {"exponents", exponents},
          {"setup_exponents", setup},
          {"speed_ups", {speed_up}}};
}

inline Json Invention::campaign() {
  Json levels = Json::array();
  for (const double d : {0.2, 0.1}) levels.push_back(row({{"d", d}}, {"relative_l2"}));
  return {{"campaign", "invented elements"},
          {"solution", "invented"},
          {"levels", levels},
          {"fits", {fit({{"norm", "l2"}})}},
          {"status", "pass"}};
}

inline void Invention::write_particles(bool plane, bool moves) {
  const int d = plane ? 2 : 3;
  std::vector<double> position, displacement, stress;
  std::ofstream table(place_ / "last.csv");
  table << "position x [m],position y [m],position z [m],displacement x [m],displacement y [m],displacement "
           "z [m],"
           "von Mises stress [Pa]\n";
  for (int n = 0; n < 64; ++n) {
    const double x[3] = {(n % 4 + 0.5) / 4 - 0.5, (n / 4 % 4 + 0.5) / 4 - 0.5,
                         plane ? 0 : (n / 16 + 0.5) * 1.5};
    if (plane && n >= 16) break;
    position.insert(position.end(), x, x + d);
    displacement.insert(displacement.end(), static_cast<std::size_t>(d), 0);
    stress.push_back(1e6 * number());
    table << x[0] << ',' << x[1] << ',' << x[2] << ",0,0,0," << stress.back() << '\n';
  }
  if (!moves) return;
  ParticleSeries series(place_, "particles");
  const std::array<PointField, 2> fields{
      {{"displacement [m]", d, displacement}, {"von Mises stress [Pa]", 1, stress}}};
  for (const double time : {0.0, 1.0}) series.write({time, d, position, fields});
}

inline Json Invention::run(const Words& w) {
  const bool plane = w.at("file").find("plate") != std::string::npos;
  const std::string per = plane ? " [J/m]" : " [J]";
  std::vector<std::string> columns{"time [s]"};
  for (const char* part : {"kinetic", "strain", "total"}) columns.push_back(part + (" energy" + per));
  columns.insert(columns.end(), {"angular momentum z [kg m/s]", "tip displacement y [m]", "hourglass share"});
  if (const auto file = w.at("file"); file.starts_with("flag-swinging") ||
                                      file.starts_with("flag-elements") || file.starts_with("flag-in-steps"))
    write_swing();
  else
    write_table("series.csv", columns);
  write_table("budget.csv", {"time [s]", "stress: angular momentum z [kg m/s]", "stress: energy" + per,
                             "jst: angular momentum z [kg m/s]", "jst: energy" + per,
                             "gap of linear momentum", "gap of angular momentum", "gap of energy"});
  write_particles(plane, w.contains("output.vtk") && w.at("output.vtk") == "true");
  const bool of_spacing = w.at("file").starts_with("cantilever") && w.contains("body.spacing");
  const double particles = of_spacing ? std::round(64 / std::pow(std::stod(w.at("body.spacing")), 3)) : 64;
  const auto made = start_row();
  made->numbers["n"] = particles;
  const auto get = [&](const char* column) { return invent(made, column); };
  double cpu = 0;
  const auto with_cpu = [&](const char* column, double times) {  // two more numbers that no other job has
    const double value = times * cpu;
    made->numbers[column] = value;
    origins[value] = {made, column};
    return value;
  };
  Json made_up{
      {"status", "completed"},
      {"particles", particles},
      {"dimension", plane ? 2 : 3},
      {"time", get("time")},
      {"steps", get("steps")},
      {"energy",
       {{"initial", get("initial")}, {"relative_change", get("relative_change")}, {"strain", get("strain")}}},
      {"dt", {{"first", get("first dt")}, {"min", get("least dt")}}},
      {"angular_momentum", {0, 0, get("angular momentum")}},
      {"extent", {{"min", {0, 0, 0}}, {"max", {1, 1, get("height")}}}},
      {"hourglass_share", get("hourglass_share")},
      {"probes", {{"tip", {{"displacement", {number(), number(), number()}}}}}},
      {"failure", nullptr},
      {"timing", {{"cpu_s", cpu = get("cpu_s")}, {"setup_s", with_cpu("setup_s", 0.37)}}},
      {"memory", {{"peak_rss", with_cpu("peak_rss", 1e8)}}}};
  // of a number that is there already, so that those of other sections stay what they are
  const std::string& file = w.at("file");
  if (file.find("cantilever") != std::string::npos) {
    made_up["error"] = {{"displacement", with_cpu("error of u", 0.11)}};
    made_up["energy"]["terms"] = {{"hourglass", with_cpu("hourglass energy", 0.013)}};
  }
  for (const char* scene : {"thrown-plate", "stiff-plate", "slender-beam"}) {
    if (!file.starts_with(scene)) continue;
    const std::string probe = file.starts_with("thrown")  ? "corner"
                              : file.starts_with("stiff") ? "side"
                                                          : "tip";
    made_up["probes"][probe] = {{"displacement", {with_cpu("end x", 0.7), with_cpu("end y", 0.3)}}};
    made_up["linear_drift"] = with_cpu("linear drift", 1.7e-12);
    made_up["angular_drift"] = with_cpu("angular drift", 2.3e-12);
  }
  return made_up;
}

}  // namespace plumb::test
