#include "lib/schemes/tlsph/run/traffic.hpp"

namespace plumb {

template <int d>
double bytes_per_update(const Solid<d>& solid, const ChosenIntegrator<d>& integrator) {
  constexpr double real = sizeof(double), offset = sizeof(std::int32_t), start = sizeof(std::int64_t);
  double bytes = real * d            // u is read
                 + 2 * real * d * d  // P is written and read
                 + real * d * integrator.vectors_moved;
  if (stores_F(solid.terms)) bytes += 2 * real * d * d;
  if (stores_force(solid.terms)) bytes += 2 * real * d;
  if (solid.bonds.width == 1) {
    const double neighbours =
        static_cast<double>(solid.bonds.pairs) / static_cast<double>(solid.cloud.size());
    bytes += 2 * neighbours * (real * d + offset)  // c_ij and a_ij
             + real * (d * d + d) + 2 * (start + offset);
  }
  for (const auto& term : solid.terms) bytes += term.bytes_per_update;
  return bytes;
}

template double bytes_per_update<1>(const Solid<1>&, const ChosenIntegrator<1>&);
template double bytes_per_update<2>(const Solid<2>&, const ChosenIntegrator<2>&);
template double bytes_per_update<3>(const Solid<3>&, const ChosenIntegrator<3>&);

}  // namespace plumb
