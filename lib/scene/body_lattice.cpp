#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lib/scene/names.hpp"
#include "lib/scene/readers.hpp"

namespace plumb {
namespace {

/// As in cells_of (geometry): a spacing typed with seven digits is meant to divide the size.
constexpr double divides = 1e-6;
/// A particle needs about a kilobyte: more than this cannot be meant.
constexpr double most_particles = 1e9;

bool divides_all(const std::vector<double>& size, double d) {
  return std::all_of(size.begin(), size.end(), [d](double length) {
    const double cells = length / d;
    return std::round(cells) >= 1.0 && std::abs(cells - std::round(cells)) <= divides * cells;
  });
}

/// The nearest spacings, one at most `d` and one at least, that divide every edge; for the suggestion.
std::string nearest_spacings(const std::vector<double>& size, double d) {
  const double shortest = *std::min_element(size.begin(), size.end());
  const long start = static_cast<long>(std::floor(shortest / d));
  std::vector<std::string> found;
  for (const long step : {-1L, +1L}) {
    for (long n = step < 0 ? start : start + 1; n >= 1 && n <= start + 1000; n += step) {
      const double candidate = shortest / static_cast<double>(n);
      if (!divides_all(size, candidate)) continue;
      found.push_back(fmt::format("{:.9g}", candidate));
      break;
    }
  }
  return found.empty() ? "" : "the nearest that do: " + join(found, " and ") + " m";
}

std::string joined(const auto& numbers) {
  std::vector<std::string> words;
  words.reserve(numbers.size());
  for (const auto number : numbers) words.push_back(fmt::format("{:.9g}", static_cast<double>(number)));
  return "[" + join(words) + "]";
}

double spacing_of_counts(const Body& body) {
  const long ends = body.layout == Layout::node ? 1 : 0;
  std::vector<double> spacings;
  for (std::size_t k = 0; k < body.size.size(); ++k)
    spacings.push_back(body.size[k] / static_cast<double>(body.particles[k] - ends));
  const auto [least, most] = std::minmax_element(spacings.begin(), spacings.end());
  if (*most - *least <= divides * *most) return spacings.front();
  const bool fits = divides_all(body.size, spacings.front());
  throw InputError(
      fmt::format("particles {} give unequal spacings {} m", joined(body.particles), joined(spacings)),
      ends ? "they must be equal in all directions; on a node layout n particles span n - 1 spacings"
           : "they must be equal in all directions",
      fits ? fmt::format("use {}", joined(with_spacing(body, spacings.front()).particles)) : "");
}

}  // namespace

Body with_spacing(Body body, double d) {
  if (!body.file.empty())
    throw InputError("another spacing of the particles of a file", "they are where the file has them", "");
  if (!(d > 0.0) || !std::isfinite(d))
    throw InputError(fmt::format("spacing {} m is not positive and finite", d), "it must be", "");
  // volumes to the power of the dimension, and their squares in norms, must be numbers
  if (d < 1e-50 || d > 1e50)
    throw InputError(fmt::format("spacing {:g} m is beyond what can be computed with", d),
                     "it is from 1e-50 to 1e50 m", "check the units");
  const double shortest = *std::min_element(body.size.begin(), body.size.end());
  if (d > shortest * (1.0 + divides))
    throw InputError("the body is empty",
                     fmt::format("spacing {:.9g} m exceeds its size {} m", d, joined(body.size)),
                     nearest_spacings(body.size, d));
  if (body.shape == "box" && !divides_all(body.size, d))
    throw InputError(fmt::format("spacing {:.9g} m does not divide the size {} m", d, joined(body.size)),
                     "particles would not fill the body", nearest_spacings(body.size, d));
  const long ends = body.layout == Layout::node ? 1 : 0;
  double total = 1.0;
  for (const double length : body.size) total *= std::ceil(length / d - divides) + static_cast<double>(ends);
  if (total > most_particles)
    throw InputError(fmt::format("{:.3g} particles", total),
                     fmt::format("at most {:.0g} fit", most_particles), "use a larger spacing");
  body.spacing = d;
  body.particles.clear();
  for (const double length : body.size)
    body.particles.push_back(std::lround(std::ceil(length / d - divides)) + ends);
  return body;
}

void resolve_lattice(const Section& section, Body& body, int dimension) {
  const auto spacing = section.optional_number({"spacing", "distance of neighbours on the lattice"},
                                               quantity::length, Sign::positive);
  const bool counted = section.has("particles");
  if (!spacing && !counted)
    section.fail("spacing", "missing key", "the body has neither spacing nor particles",
                 "add spacing = .. or particles = [..]");
  if (counted && body.shape != "box")
    section.fail("particles", fmt::format("for a body of shape \"{}\"", body.shape),
                 "they are counted along the edges of a box", "give spacing");
  try {
    std::optional<double> of_counts;
    if (counted) {
      body.particles =
          section.integers({"particles", "numbers of particles along the edges, instead of the spacing"},
                           static_cast<std::size_t>(dimension), 1);
      for (const long n : body.particles)
        if (n < 2 && body.layout == Layout::node)
          section.fail("particles", fmt::format("{} is too small", n), "at least 2");
      of_counts = spacing_of_counts(body);
    }
    if (spacing && of_counts && std::abs(*spacing - *of_counts) > divides * *spacing)
      section.fail("spacing", "contradicts particles",
                   fmt::format("spacing {:.9g} m, but particles {} on this size give {:.9g} m", *spacing,
                               joined(body.particles), *of_counts),
                   "leave one of them out");
    body = with_spacing(body, spacing ? *spacing : *of_counts);
  } catch (const SceneError&) {
    throw;
  } catch (const InputError& error) {
    section.fail(spacing ? "spacing" : "particles", error.problem(), error.why(), error.suggestion());
  }
}

}  // namespace plumb
