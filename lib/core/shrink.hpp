#pragma once

namespace plumb {

/// Gives back the memory that vectors have reserved beyond their size, so that bytes() are what is held.
template <class... Vectors>
void shrink_to_fit(Vectors&... vectors) {
  (vectors.shrink_to_fit(), ...);
}

}  // namespace plumb
