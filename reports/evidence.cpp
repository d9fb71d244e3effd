#include "reports/evidence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace plumb::reports {
namespace {

const std::string folder = "verification/studies/";
const std::vector<std::string> everywhere{"0", "1", "2", "3", "blue"}, two{"0", "2"};

/// Nearly incompressible plates, as an equilibrium: explicit steps would be a hundred times shorter.
Problem static_plate(const std::string& poisson) {
  return {"static-" + poisson.substr(2),
          "static plate, ν = " + poisson,
          "static",
          folder + "static_plate.toml",
          {"material.poisson=" + poisson},
          two,
          two,
          {}};
}

/// The same at finite strain and in motion. Above 0.495 what is claimed is claimed of the lattice.
Problem moving_plate(const std::string& poisson, std::vector<std::string> second_order) {
  return {"plate-" + poisson.substr(2),
          "swinging plate, finite strain, ν = " + poisson,
          "mms",
          folder + "swinging_plate_finite_strain.toml",
          {"study.quadrature=nodal", "material.poisson=" + poisson},
          two,
          std::move(second_order),
          {}};
}

}  // namespace

std::vector<Problem> problems(bool long_run) {
  const std::string rings = "study.spacings=[0.0416666666666667,0.03125,0.0208333333333333,0.015625]";
  std::vector<Problem> all = {
      {"static",
       "static plate, ν = 0.3",
       "static",
       folder + "static_plate.toml",
       {},
       everywhere,
       {"0", "1", "2", "blue"}},
      {"plate",
       "swinging plate, finite strain, ν = 0.495",
       "mms",
       folder + "swinging_plate_finite_strain.toml",
       {"study.quadrature=nodal"},
       everywhere,
       everywhere},
      static_plate("0.49995"),
      {"column",
       "stretched column under traction",
       "mms",
       folder + "stretched_column.toml",
       {"expect.l2=2", "expect.reason=as inside"},
       two,
       {"0", "1", "2"}},
      {"vortex",
       "vortex, A = 0.1 rad, particles on the circles (lattice: rings)",
       "mms",
       folder + "generalized_vortex.toml",
       {rings, "study.parameters.amplitude=0.1"},
       two,
       everywhere,
       everywhere},
      // coarser: on this lattice only the direct solver serves (THEORY, chapter 11), with 3 GB at 1/24
      {"cube-lattice",
       "trigonometric cube, d = 1/4 to 1/12",
       "mms",
       folder + "trigonometric_cube.toml",
       {"study.spacings=[0.25,0.166666666666667,0.125,0.0833333333333333]"},
       {"0"},
       {"0"}},
      {"cube",
       "trigonometric cube, d = 1/8 to 1/24",
       "mms",
       folder + "trigonometric_cube.toml",
       {"study.spacings=[0.125,0.0833333333333333,0.0625,0.0416666666666667]"},
       {"2"},
       {"1", "2", "3", "blue"},
       {"1", "2", "3", "blue"}}};
  if (!long_run) return all;
  for (auto& problem : all)
    if (!problem.long_clouds.empty()) problem.clouds = problem.long_clouds;
  for (auto& problem : all)
    if (problem.id == "static") problem.set = {"study.spacings=[0.2,0.1,0.05,0.025,0.0125]"};
  all.push_back({"clipped",
                 "vortex, A = 0.5 rad, clipped ring, β = 1.2",
                 "mms",
                 folder + "generalized_vortex.toml",
                 {rings, "body.layout=cell", "method.beta=1.2"},
                 everywhere,
                 {}});
  all.push_back({"rings",
                 "vortex, A = 0.5 rad, hourglass energy 2, particles on the circles (lattice: rings)",
                 "mms",
                 folder + "generalized_vortex.toml",
                 {rings, "hourglass.alpha=2"},
                 everywhere,
                 {"0", "2", "blue"}});
  all.push_back({"linear",
                 "swinging plate, linear, ν = 0.495",
                 "mms",
                 folder + "swinging_plate_adjoint.toml",
                 {"study.quadrature=nodal"},
                 everywhere,
                 everywhere});
  for (const char* poisson : {"0.4", "0.45", "0.49", "0.495", "0.499", "0.4999"})
    all.push_back(static_plate(poisson));
  all.push_back(moving_plate("0.3", two));
  all.push_back(moving_plate("0.45", two));
  all.push_back(moving_plate("0.4995", {"0"}));
  all.push_back(moving_plate("0.49995", {}));
  return all;
}

const std::vector<Choice>& clouds() {
  static const std::vector<Choice> all = {{"0", "lattice", {"body.jitter=0"}},
                                          {"1", "jitter 0.1", {"body.jitter=0.1"}},
                                          {"2", "jitter 0.2", {"body.jitter=0.2"}},
                                          {"3", "jitter 0.3", {"body.jitter=0.3"}},
                                          {"blue", "blue noise", {"body.jitter=0", "body.cloud=blue-noise"}}};
  return all;
}

const std::vector<Choice>& schemes() {
  static const std::vector<Choice> all = {
      {"compatible", "compatible", {"method.gradient=compatible", "method.integrator=verlet"}},
      {"adjoint", "improved, adjoint", {"method.gradient=improved", "method.integrator=verlet"}},
      {"paper",
       "paper: improved, symmetrised, JST, RK3",
       {"method.gradient=improved", "method.momentum=symmetrised", "method.integrator=rk3",
        "jst.eta4=0.125"}}};
  return all;
}

const Choice& cloud_of(const std::string& id) {
  const auto found =
      std::find_if(clouds().begin(), clouds().end(), [&](const Choice& c) { return c.id == id; });
  if (found == clouds().end()) throw std::logic_error("no cloud " + id);
  return *found;
}

bool is_lattice(const Choice& cloud) {
  return cloud.id == "0";
}

Job evidence_job(const Problem& problem, const Choice& cloud, const Choice& scheme) {
  Job job{fmt::format("evidence-{}-{}-{}", problem.id, cloud.id, scheme.id),
          {problem.command, problem.file},
          {problem.file}};
  for (const auto* set : {&problem.set, &cloud.set, &scheme.set})
    for (const auto& entry : *set) {
      // nothing is stepped in a static study, which refuses to be told how
      const bool of_steps = entry.starts_with("method.integrator=") || entry.starts_with("jst.");
      if (!of_steps || problem.command != "static")
        job.arguments.insert(job.arguments.end(), {"--set", entry});
    }
  return job;
}

}  // namespace plumb::reports
