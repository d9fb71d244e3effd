#include "reports/modes.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

namespace plumb::reports {
namespace {

using Json = nlohmann::ordered_json;

/// Where and along which axis the motion is largest.
std::pair<std::size_t, std::size_t> largest_of(const Json& motion) {
  std::pair<std::size_t, std::size_t> place{0, 0};
  double most = 0;
  for (std::size_t i = 0; i < motion.size(); ++i)
    for (std::size_t k = 0; k < motion[i].size(); ++k)
      if (const double size = std::abs(motion[i][k].get<double>()); size > most) {
        most = size;
        place = {i, k};
      }
  return place;
}

}  // namespace

Picture mode_picture(const Json& mode, std::string title) {
  const Json &X = mode.at("X"), &u = mode.at("u");
  const double d = mode.at("spacing");
  const auto [place, axis] = largest_of(u);
  PointMap particles{{}, {}, {}, d, std::string("motion along ") + "XYZ"[axis]};
  for (std::size_t i = 0; i < X.size(); ++i) {
    if (X[i].size() == 3 && std::abs(X[i][2].get<double>() - X[place][2].get<double>()) > 0.5 * d) continue;
    const double along = X[i].size() == 1 ? 0 : u[i][0].get<double>();
    particles.x.push_back(X[i][0].get<double>() + d / 3 * along);
    const std::size_t across = X[i].size() == 1 ? 0 : 1;  // a bar's motion is drawn across it
    const double y = across == 0 ? 0 : X[i][1].get<double>();
    particles.y.push_back(y + d / 3 * u[i][across].get<double>());
    particles.z.push_back(u[i][axis]);
  }
  Picture picture{std::move(title), {"X", "m"}, {"Y", "m"}};
  picture.map = std::move(particles);
  picture.equal_axes = true;
  return picture;
}

}  // namespace plumb::reports
