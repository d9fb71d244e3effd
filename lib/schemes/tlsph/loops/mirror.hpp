#pragma once
#include "lib/schemes/tlsph/loops/solid.hpp"

namespace plumb {

/// The force that mirror images behind rollers exert: the part of the internal force that holds the body at
/// the rollers, THEORY (10.7). A solid with images has it as its first term.
template <int d>
Term<d> mirror_term(const Solid<d>& solid);

}  // namespace plumb
