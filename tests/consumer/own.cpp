// Somebody else's program on the installed library alone: an own material, linear elasticity, and an own
// case, a standing wave u = A sin(pi X) cos(pi c t) in a unit box on rollers. After a quarter of its period
// it has no displacement.
#include <cmath>
#include <cstdio>

#include "plumbline/scene/read_scene.hpp"
#include "plumbline/scene/tlsph.hpp"
#include "plumbline/schemes/tlsph/loops/make_sweeps.hpp"

struct LinearElasticity {  // W = lambda/2 (tr e)^2 + mu e:e,  P = dW/dF = lambda tr e I + 2 mu e,  e = (F +
                           // F^T)/2 - I
  static constexpr std::string_view name = "linear-elasticity";
  double lame, shear;  // [Pa]
  explicit LinearElasticity(const plumb::Elastic& e) : lame(e.lame()), shear(e.shear_modulus()) {}

  template <class T, int d>
  Eigen::Matrix<T, d, d> first_piola(const Eigen::Matrix<T, d, d>& F) const {
    T trace(-d);
    for (int a = 0; a < d; ++a) trace = trace + F(a, a);
    Eigen::Matrix<T, d, d> P;
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b)
        P(a, b) = T(shear) * (F(a, b) + F(b, a)) + T(a == b ? 1 : 0) * (T(lame) * trace - T(2 * shear));
    return P;
  }
  template <class T, int d>
  T energy(const Eigen::Matrix<T, d, d>& F) const {  // P : (F - I) / 2, as P is linear in F - I
    const Eigen::Matrix<T, d, d> P = first_piola(F);
    T sum(0);
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b) sum = sum + T(0.5) * P(a, b) * (F(a, b) - T(a == b ? 1 : 0));
    return sum;
  }
};

constexpr const char* box_on_rollers = R"toml(
[scene]
name = "standing wave"
dimension = 2
end_time = "3.4665266 ms"  # L/(2 c): a quarter of the period, c = 144.2366 m/s
[body]
size = [1, 1]
spacing = 0.05
[material]  # its constants; the law is the one above
young = "17 MPa"
poisson = 0.3
density = 1100
[method]
gradient = "compatible"
[initial]
velocity = ["0.1*sin(pi*X)", "0"]
)toml";

int main() {
  std::string text = box_on_rollers;
  for (const char* face : {"x-", "x+", "y-", "y+"})
    text += std::string("[[boundary]]\nkind = \"roller\"\nface = \"") + face + "\"\n";
  auto wave = plumb::make_tlsph<2>(plumb::parse_scene(text, "standing wave"));
  wave.solid.sweeps = plumb::sweeps_of<2>(LinearElasticity(wave.solid.elastic), wave.solid.bonds);
  const bool completed = plumb::run<2>(wave.solid, wave.state, wave.integrator, wave.control).completed();

  double fastest = 0;
  for (plumb::Index i = 0; i < wave.solid.bonds.slots.count(); ++i)
    fastest = std::max(fastest, std::abs(wave.state.v[0][i]));
  std::printf("%ld steps, rest of the velocity %.4f\n", wave.state.step, fastest / 0.1);
  // The frequency is off by (pi d)^2/6 = 0.41 % (sin(pi d) instead of pi d), and so the phase of pi/2: by
  // 0.0065
  return completed && fastest < 0.01 * 0.1 ? 0 : 1;
}
