#pragma once

namespace plumb {

/// Where the particles of a lattice sit.
enum class Layout {
  cell,   ///< first particle half a spacing inside the face, equal volumes
  node,   ///< particles on the faces, tributary volumes
  mirror  ///< cell, with reflected ghosts behind rollers
};

}  // namespace plumb
