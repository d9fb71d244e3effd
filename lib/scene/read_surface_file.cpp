// [body] file = "..stl": the surface of a body.
#include <boost/algorithm/string.hpp>

#include "lib/geometry/flat_outlines.hpp"
#include "lib/input/document.hpp"
#include "lib/input/stl.hpp"
#include "lib/scene/cloud_file.hpp"
#include "lib/scene/readers.hpp"

namespace plumb {
namespace {

std::vector<double> coordinates(const std::vector<Vec<2>>& corners) {
  std::vector<double> all;
  for (const Vec<2>& corner : corners) all.insert(all.end(), {corner[0], corner[1]});
  return all;
}

}  // namespace

bool is_surface_file(const std::string& name) {
  return boost::iends_with(name, ".stl");
}

void read_surface_file(const Section& section, Body& body, int dimension) {
  if (dimension == 0)
    section.fail("file", "in a study", "the body of a study is the domain of its solution", "leave it out");
  for (const char* key : {"shape", "size", "origin", "particles"})
    if (section.has(key))
      section.fail(key, "contradicts file", "the surface in the file is the body's shape", "leave it out");
  const std::string path = file_beside_scene(section);
  const double metre = metres_of_unit(section);
  std::vector<Triangle> triangles = parse_stl(read_text(path), path);
  for (Triangle& triangle : triangles)
    for (Vec<3>& corner : triangle) corner *= metre;
  if (dimension == 3) {
    body.shape = "polyhedron";
    auto& corners = body.lengths["corners"];
    for (const Triangle& triangle : triangles)
      for (const Vec<3>& corner : triangle) corners.insert(corners.end(), corner.begin(), corner.end());
    return;
  }
  try {
    const auto outlines = flat_outlines(triangles);
    body.shape = "polygon";
    body.lengths["corners"] = coordinates(outlines.front());
    for (std::size_t k = 1; k < outlines.size(); ++k)
      body.holes.push_back({"polygon", {{"corners", coordinates(outlines[k])}}});
  } catch (const InputError& error) {
    section.fail("file", error.problem(), error.why(), error.suggestion());
  }
}

}  // namespace plumb
