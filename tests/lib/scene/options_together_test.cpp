// Options of a scene in combination: every pair of choices stands in some scene, and what the library
// computes for it is what a plain implementation finds that knows nothing of tables, packs, rows or blocks
// (tests/support/plain_body.hpp).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

#include "lib/material/laws.hpp"
#include "lib/scene/read_scene.hpp"
#include "lib/scene/tlsph.hpp"
#include "lib/schemes/tlsph/loops/evaluate.hpp"
#include "lib/schemes/tlsph/measures/solid_measures.hpp"
#include "tests/support/clouds.hpp"
#include "tests/support/plain_body.hpp"

namespace plumb {
namespace {

struct Choice {
  std::string_view name;
  std::vector<std::string> values;
};
const std::vector<Choice> choices = {{"dimension", {"2", "3"}},
                                     {"layout", {"cell", "node", "mirror"}},
                                     {"jitter", {"0", "0.2"}},
                                     {"rollers", {"none", "two"}},
                                     {"model", {"neo-hookean", "mooney-rivlin"}},
                                     {"kernel", {"cubic", "quintic", "wendland-c2", "quadratic"}},
                                     {"beta", {"0.9", "1.2"}},
                                     {"pair", {"W0", "W1"}},
                                     {"gradient", {"standard", "improved", "bond38"}},
                                     {"momentum", {"adjoint", "symmetrised"}},
                                     {"jst", {"none", "symmetric", "transpose"}},
                                     {"laplacian_factor", {"2", "1"}},
                                     {"eta2", {"0", "0.3"}},
                                     {"hourglass", {"none", "0.7"}},
                                     {"projection", {"no", "yes"}}};
using Picks = std::vector<std::size_t>;  ///< per choice, the place of its value

const std::string& value(const Picks& row, std::string_view name) {
  for (std::size_t c = 0; c < choices.size(); ++c)
    if (choices[c].name == name) return choices[c].values[row[c]];
  throw std::logic_error("no such choice");
}

/// What no scene can have: images need the rollers, and neither springs nor the projection know of them.
bool possible(const Picks& row) {
  return value(row, "layout") != "mirror" ||
         (value(row, "rollers") == "two" && value(row, "hourglass") == "none" &&
          value(row, "projection") == "no");
}

using Pairs = std::set<std::array<std::size_t, 4>>;  ///< two choices and their values

Pairs pairs_of(const Picks& row) {
  Pairs pairs;
  for (std::size_t a = 0; a < row.size(); ++a)
    for (std::size_t b = a + 1; b < row.size(); ++b) pairs.insert({a, row[a], b, row[b]});
  return pairs;
}

Picks random_picks(test::Numbers& numbers) {
  Picks row;
  for (const auto& choice : choices)
    row.push_back(
        static_cast<std::size_t>(0.5 * (1 + numbers.next()) * static_cast<double>(choice.values.size())));
  return row;
}

/// Rows that hold every possible pair: of fifty random rows always the one with most pairs that are new.
std::vector<Picks> covering_rows() {
  test::Numbers numbers(11);
  Pairs missing;
  for (int n = 0; n < 4000; ++n)
    if (const Picks row = random_picks(numbers); possible(row)) missing.merge(pairs_of(row));
  std::vector<Picks> rows;
  while (!missing.empty()) {
    Picks best;
    std::size_t most = 0;
    for (int n = 0; n < 50; ++n) {
      const Picks row = random_picks(numbers);
      if (!possible(row)) continue;
      std::size_t news = 0;
      for (const auto& pair : pairs_of(row)) news += missing.count(pair);
      if (news > most) most = news, best = row;
    }
    if (most == 0) continue;
    for (const auto& pair : pairs_of(best)) missing.erase(pair);
    rows.push_back(best);
  }
  return rows;
}

std::string scene_of(const Picks& row) {
  const auto v = [&](std::string_view name) { return value(row, name); };
  const bool flat = v("dimension") == "2";
  std::string text = fmt::format(
      "[scene]\ndimension = {}\nmax_steps = 1\n[body]\nsize = {}\norigin = {}\nspacing = 0.1\nlayout = "
      "\"{}\"\njitter = "
      "{}\n[material]\nmodel = \"{}\"\nyoung = 17e6\npoisson = 0.45\ndensity = 1100\n"
      "[method]\nkernel = \"{}\"\nbeta = {}\npair = \"{}\"\ngradient = \"{}\"\nmomentum = \"{}\"\n",
      v("dimension"), flat ? "[0.9, 0.7]" : "[0.6, 0.5, 0.4]", flat ? "[0.3, -0.2]" : "[0.3, -0.2, 0.1]",
      v("layout"), v("jitter"), v("model"), v("kernel"), v("beta"), v("pair"), v("gradient"), v("momentum"));
  if (v("jst") != "none")
    text += fmt::format("[jst]\nouter = \"{}\"\nlaplacian_factor = {}\neta2 = {}\neta4 = 0.125\n", v("jst"),
                        v("laplacian_factor"), v("eta2"));
  if (v("hourglass") != "none") text += "[hourglass]\nalpha = 0.7\n";
  if (v("projection") == "yes") text += "[projection]\n";
  if (v("rollers") == "two")
    text +=
        "[[boundary]]\nface = \"x-\"\nkind = \"roller\"\n[[boundary]]\nface = \"y-\"\nkind = \"roller\"\n";
  return text;
}

test::PlainChoices plain_choices(const Picks& row) {
  test::PlainChoices o{value(row, "kernel"),
                       value(row, "pair"),
                       value(row, "gradient"),
                       value(row, "momentum"),
                       std::stod(value(row, "beta")),
                       {},
                       {},
                       value(row, "projection") == "yes",
                       {}};
  if (value(row, "jst") != "none")
    o.jst = {std::stod(value(row, "eta2")), 0.125, std::stod(value(row, "laplacian_factor")),
             value(row, "jst") == "transpose"};
  if (value(row, "hourglass") != "none") o.hourglass = 0.7;
  if (value(row, "layout") == "mirror") o.walls = {{0, false}, {1, false}};
  return o;
}

template <int d>
std::vector<Vec<d>> forces_of(TlsphBody<d>& body) {
  std::vector<Vec<d>> by_slot(body.solid.bonds.slots.count(), Vec<d>::Zero()), f;
  Workspace<d> workspace;
  EXPECT_TRUE(evaluate(body.solid, workspace, body.state, 0.0, [&](const Block& block, BlockForce<d>& force) {
    for (Index i = block.begin(); i < block.end(); ++i)
      for (int k = 0; k < d; ++k) by_slot[i][k] = force(k, i);
  }));
  for (Index i = 0; i < body.solid.cloud.size(); ++i) f.push_back(by_slot[body.solid.bonds.slots.of(i)]);
  return f;
}

/// Particles within `reach` of the lower face of an axis are held there. A roller's layer is on the face of a
/// node layout and half a spacing inside of a cell layout, jitter added.
template <int d>
void hold(const Cloud<d>& cloud, const Picks& row, std::vector<Vec<d>>& f) {
  if (value(row, "rollers") == "none" || value(row, "layout") == "mirror") return;
  const double reach = value(row, "layout") == "cell" ? 0.9 * cloud.spacing : 1e-9;
  for (Index i = 0; i < cloud.size(); ++i)
    for (const int axis : {0, 1})
      if (cloud.X[i][axis] - cloud.box.origin[axis] < reach) f[i][axis] = 0;
}

/// Largest difference and largest value of two lists.
template <int d>
std::pair<double, double> compare(const std::vector<Vec<d>>& a, const std::vector<Vec<d>>& b) {
  double difference = 0, size = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference = std::max(difference, (a[i] - b[i]).norm());
    size = std::max(size, b[i].norm());
  }
  return {difference, size};
}

template <int d>
void check(const Picks& row) {
  SCOPED_TRACE(scene_of(row));
  auto body = make_tlsph<d>(parse_scene(scene_of(row), "pairs.toml"));
  const Cloud<d>& cloud = body.solid.cloud;
  test::Numbers numbers(3);
  std::vector<Vec<d>> u, v;
  for (Index i = 0; i < cloud.size(); ++i) {  // strains of some hundredths
    u.push_back(2e-3 * numbers.vector<d>());
    v.push_back(numbers.vector<d>());
    set_vector<d>(body.state.u, body.solid.bonds.slots.of(i), u[i]);
    set_vector<d>(body.state.v, body.solid.bonds.slots.of(i), v[i]);
  }
  const test::PlainBody<d> plain(cloud, plain_choices(row), body.solid.elastic);
  std::function<Mat<d>(const Mat<d>&)> stress;
  std::function<double(const Mat<d>&)> energy;
  with_elastic_law<d>(LawChoice(value(row, "model")), body.solid.elastic, [&](const auto& material) {
    stress = [material](const Mat<d>& F) { return Mat<d>(material.first_piola(F)); };
    energy = [material](const Mat<d>& F) { return material.energy(F); };
  });

  double strain = 0, kinetic = 0;
  for (Index i = 0; i < cloud.size(); ++i) {
    // some thirty products of order 1
    ASSERT_LT((deformation_gradient_of(body.solid, body.state, i) - plain.deformation(i, u)).norm(), 1e-12)
        << "particle " << i;
    strain += cloud.V[i] * energy(plain.deformation(i, u));
    kinetic += 0.5 * body.solid.elastic.density * cloud.V[i] * v[i].squaredNorm();
  }
  const Energy found = energy_of(body.solid, body.state);
  EXPECT_NEAR(found.strain, strain,
              1e-10 * std::abs(strain));  // differences of numbers a thousand times larger
  EXPECT_NEAR(found.kinetic, kinetic, 1e-13 * kinetic);
  EXPECT_NEAR(found.elsewhere(), plain.hourglass_energy(u), 1e-11 * std::abs(strain));

  auto expected = plain.forces(u, v, stress);
  hold(cloud, row, expected);
  const auto [difference, size] = compare(forces_of(body), expected);
  EXPECT_GT(size, 0);
  EXPECT_LT(difference, 1e-10 * size);  // twice differenced rounding: found up to 1e-12
}

TEST(OptionsTogether, EveryPairGivesTheForcesOfAPlainImplementation) {
  const auto rows = covering_rows();
  EXPECT_LT(rows.size(), 40u);
  for (const Picks& row : rows) value(row, "dimension") == "2" ? check<2>(row) : check<3>(row);
}

}  // namespace
}  // namespace plumb
