#include "lib/geometry/ghosts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lib/core/error.hpp"

namespace plumb {
namespace {

template <int d>
void refuse_thin(const Cloud<d>& cloud, const std::vector<Wall>& walls, double R) {
  std::array<int, d> sides{};
  for (const Wall& wall : walls) ++sides[wall.axis];
  for (int k = 0; k < d; ++k)
    if (sides[k] == 2 && R > cloud.box.size[k])
      throw InputError(fmt::format("support radius {:.6g} m between rollers {:.6g} m apart (axis {})", R,
                                   cloud.box.size[k], "xyz"[k]),
                       "particles would see images of images", "use a smaller spacing or beta");
}

/// The sides of axis k on which a particle of the given position can have an image.
template <int d>
std::vector<int> sides_of(int k, const std::vector<Wall>& walls) {
  std::vector<int> sides{0};
  for (const Wall& wall : walls)
    if (wall.axis == k) sides.push_back(wall.upper ? +1 : -1);
  return sides;
}

}  // namespace

template <int d>
std::vector<Ghost<d>> ghosts_behind(const Cloud<d>& cloud, const std::vector<Wall>& walls, double R) {
  refuse_thin(cloud, walls, R);
  std::vector<std::array<int, d>> images{{}};
  for (int k = 0; k < d; ++k) {
    std::vector<std::array<int, d>> more;
    for (const auto& image : images)
      for (const int side : sides_of<d>(k, walls)) {
        more.push_back(image);
        more.back()[k] = side;
      }
    images = std::move(more);
  }
  std::sort(images.begin(), images.end());
  std::vector<Ghost<d>> ghosts;
  for (const auto& across : images) {
    if (across == std::array<int, d>{}) continue;  // the particle itself
    for (Index i = 0; i < cloud.size(); ++i) {
      bool near = true;  // an image is no nearer to a particle than to the wall
      for (int k = 0; k < d; ++k) {
        const double depth = across[k] < 0 ? cloud.X[i][k] - cloud.box.origin[k]
                                           : cloud.box.origin[k] + cloud.box.size[k] - cloud.X[i][k];
        near = near && (across[k] == 0 || depth < R);
      }
      if (near) ghosts.push_back({i, across});
    }
  }
  return ghosts;
}

template <int d>
Vec<d> signs_of(const Ghost<d>& ghost) {
  Vec<d> signs;
  for (int k = 0; k < d; ++k) signs[k] = ghost.across[k] == 0 ? 1 : -1;
  return signs;
}

template <int d>
Vec<d> image_of(const Vec<d>& X, const Box<d>& box, const Ghost<d>& ghost) {
  Vec<d> image = X;
  for (int k = 0; k < d; ++k)
    if (ghost.across[k] != 0) image[k] = 2 * (box.origin[k] + (ghost.across[k] > 0 ? box.size[k] : 0)) - X[k];
  return image;
}

template <int d>
Cloud<d> with_ghosts(const Cloud<d>& cloud, const std::vector<Ghost<d>>& ghosts) {
  Cloud<d> all = cloud;
  all.line = 0;
  for (const auto& ghost : ghosts) {
    all.X.push_back(image_of(cloud.X[ghost.real], cloud.box, ghost));
    all.V.push_back(cloud.V[ghost.real]);
  }
  return all;
}

#define PLUMBLINE_INSTANTIATE(d)                                                                      \
  template std::vector<Ghost<d>> ghosts_behind<d>(const Cloud<d>&, const std::vector<Wall>&, double); \
  template Vec<d> signs_of<d>(const Ghost<d>&);                                                       \
  template Vec<d> image_of<d>(const Vec<d>&, const Box<d>&, const Ghost<d>&);                         \
  template Cloud<d> with_ghosts<d>(const Cloud<d>&, const std::vector<Ghost<d>>&);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
