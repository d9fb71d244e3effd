#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "lib/scene/material_path.hpp"
#include "reports/picture.hpp"
#include "verification/plumb/commands.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

struct MaterialCommand {
  std::string file;
  std::vector<std::string> overrides;
  std::optional<long> steps;
};

template <class T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

Json json_of(const Mat<3>& A) {
  Json rows = Json::array();
  for (int a = 0; a < 3; ++a) rows.push_back({A(a, 0), A(a, 1), A(a, 2)});
  return rows;
}

Json json_of(const PathRow& row) {
  const PointState& s = row.state;
  return {{"t", row.t},
          {"F", json_of(s.F)},
          {"cauchy", json_of(s.cauchy)},
          {"q", s.equivalent},
          {"plastic_strain", or_null(s.plastic_strain)},
          {"temperature", or_null(s.temperature)},
          {"damage", or_null(s.damage)},
          {"iterations", or_null(s.iterations)}};
}

/// The row without arrays, for tables: F_11 .. and sigma_11 .., the six different ones.
Json flat(const PathRow& row) {
  const PointState& s = row.state;
  Json out{{"t", row.t}};
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) out[fmt::format("F_{}{}", a + 1, b + 1)] = s.F(a, b);
  for (int a = 0; a < 3; ++a)
    for (int b = a; b < 3; ++b) out[fmt::format("cauchy_{}{}", a + 1, b + 1)] = s.cauchy(a, b);
  out["q"] = s.equivalent;
  if (s.plastic_strain) out["plastic_strain"] = *s.plastic_strain;
  if (s.temperature) out["temperature"] = *s.temperature;
  if (s.damage) out["damage"] = *s.damage;
  if (s.iterations) out["iterations"] = *s.iterations;
  return out;
}

reports::Picture picture_of(const std::string& model, const std::vector<PathRow>& rows) {
  reports::Picture picture;
  picture.title = model + " at one point";
  picture.x = {"time", "s"};
  picture.y = {"stress", "Pa"};
  picture.labels = reports::Labels::legend;
  const auto add = [&](const std::string& label, auto&& value) {
    reports::Series series;
    series.label = label;
    series.style = reports::Style::lines;
    bool all_zero = true;
    for (const PathRow& row : rows) {
      series.x.push_back(row.t);
      series.y.push_back(value(row.state));
      all_zero = all_zero && series.y.back() == 0;
    }
    if (!all_zero || label == "q") picture.series.push_back(series);
  };
  for (int a = 0; a < 3; ++a)
    for (int b = a; b < 3; ++b)
      add(fmt::format("sigma_{}{}", a + 1, b + 1), [a, b](const PointState& s) { return s.cauchy(a, b); });
  add("q", [](const PointState& s) { return s.equivalent; });
  return picture;
}

int material_action(const Session& session, const MaterialCommand& command) {
  const MaterialPath path = read_material_path(command.file, command.overrides);
  const std::vector<PathRow> rows = follow(path, command.steps);
  Json table = Json::array(), json = Json::array(), parameters = Json::object();
  for (const PathRow& row : rows) {
    table.push_back(flat(row));
    json.push_back(json_of(row));
  }
  for (const auto& [name, value] : path.material.parameters) parameters[name] = value;
  session.write_table(table);
  if (!session.plot.empty())
    for (const auto& dropped : reports::save(picture_of(path.material.model, rows), session.plot))
      session.warn(fmt::format("{}: {} points not drawn, {}", dropped.series, dropped.points, dropped.why));
  session.write_json({{"material", path.material.model},
                      {"young", path.material.young},
                      {"poisson", path.material.poisson},
                      {"parameters", parameters},
                      {"plane", path.dimension != 2                    ? Json()
                                : path.material.plane == Plane::stress ? Json("stress")
                                                                       : Json("strain")},
                      {"rows", json}});
  return 0;
}

}  // namespace

/// `plumb material PATH.toml`: one point of any law along a path of deformations.
void add_material(CLI::App& program, Session& session) {
  const auto options = std::make_shared<MaterialCommand>();
  CLI::App& command = add_command(
      program, session,
      {"material", "one point of a material along a path of F(t) or of a constant velocity gradient",
       "plumb material verification/material/copper-shear.toml --plot shear.svg"},
      {.table = true, .plot = true}, [&session, options] { return material_action(session, *options); });
  command.add_option("PATH", options->file, "the path file (.toml): [material] and [path]")
      ->required()
      ->type_name("FILE");
  command.add_option("--set", options->overrides, "change one value of the file; may be repeated")
      ->type_name("section.key=value");
  command.add_option("--steps", options->steps, "increments of each piece, in place of its own")
      ->check(CLI::Range(1L, 100000000L))
      ->type_name("N");
}

}  // namespace plumb::app
