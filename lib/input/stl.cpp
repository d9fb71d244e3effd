// STL: https://www.loc.gov/preservation/digital/formats/fdd/fdd000505.shtml (binary) and fdd000506.shtml
// (text).
#include "lib/input/stl.hpp"

#include <fmt/format.h>

#include <boost/algorithm/string.hpp>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <sstream>

#include "lib/core/error.hpp"

namespace plumb {
namespace {

constexpr std::size_t header = 84, record = 50;  // bytes of a binary file: before the triangles, of each

[[noreturn]] void refuse(const std::string& place, const std::string& problem, const std::string& why = "") {
  throw InputError(fmt::format("{}: {}", place, problem), why, "");
}

void add(std::vector<Triangle>& triangles, const Triangle& next, const std::string& place) {
  for (const Vec<3>& corner : next)
    if (!corner.allFinite()) refuse(place, "a corner is not finite");
  if (next[0] != next[1] && next[1] != next[2] && next[2] != next[0]) triangles.push_back(next);
}

/// Triangles that a binary file says it has; nothing if its length is another.
std::optional<std::size_t> binary_count(const std::string& bytes) {
  if (bytes.size() < header) return std::nullopt;
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + header - sizeof count, sizeof count);
  if (bytes.size() != header + record * count) return std::nullopt;
  return count;
}

std::vector<Triangle> parse_binary(const std::string& bytes, std::size_t count,
                                   const std::string& file_name) {
  std::vector<Triangle> triangles;
  for (std::size_t k = 0; k < count; ++k) {
    std::array<float, 9> numbers;
    constexpr std::size_t normal = 12;
    std::memcpy(numbers.data(), bytes.data() + header + record * k + normal, sizeof numbers);
    Triangle next;
    for (std::size_t c = 0; c < 3; ++c)
      next[c] = Vec<3>(numbers[3 * c], numbers[3 * c + 1], numbers[3 * c + 2]);
    add(triangles, next, fmt::format("{}: triangle {}", file_name, k + 1));
  }
  return triangles;
}

double number_in(const std::string& word, const std::string& place) {
  double value = 0;
  const auto [end, error] =
      std::from_chars(word.data() + word.starts_with('+'), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size())
    refuse(place, fmt::format("\"{}\" is no number", word.substr(0, 20)));
  return value;
}

std::vector<Triangle> parse_text(const std::string& text, const std::string& file_name) {
  std::vector<Triangle> triangles;
  std::istringstream lines(text);
  Triangle next;
  std::size_t corners = 0, number = 0;
  bool inside = false, ended = false;  // within a facet; after an endsolid
  for (std::string line; std::getline(lines, line);) {
    const std::string place = fmt::format("{}:{}", file_name, ++number);
    boost::trim(line);
    if (line.empty()) continue;
    std::vector<std::string> words;
    boost::split(words, line, boost::is_space(), boost::token_compress_on);
    const std::string word = boost::to_lower_copy(words.front());
    if (word == "vertex") {
      if (!inside || corners == 3) refuse(place, "a vertex outside of a facet", "a facet has three");
      if (words.size() != 4)
        refuse(place, fmt::format("a vertex of {} numbers", words.size() - 1), "it has three");
      for (int k = 0; k < 3; ++k) next[corners][k] = number_in(words[static_cast<std::size_t>(k) + 1], place);
      ++corners;
    } else if (word == "facet") {
      if (inside) refuse(place, "a facet within a facet");
      inside = true;
      corners = 0;
    } else if (word == "endfacet") {
      if (!inside || corners != 3)
        refuse(place, fmt::format("a facet of {} vertices", corners), "it has three");
      add(triangles, next, place);
      inside = false;
    } else if (word == "endsolid") {
      ended = true;
    } else if (word == "solid") {
      ended = false;
    } else if (word != "outer" && word != "endloop") {
      refuse(place, fmt::format("\"{}\" is no word of STL", words.front().substr(0, 20)));
    }
  }
  if (inside || !ended) refuse(file_name, "it is cut off", "a solid ends with endsolid");
  return triangles;
}

}  // namespace

std::vector<Triangle> parse_stl(const std::string& bytes, const std::string& file_name) {
  const auto count = binary_count(bytes);  // first: binary files may begin with "solid" too
  const bool text = boost::istarts_with(bytes, "solid");
  if (!count && !text)
    refuse(
        file_name, "it is no STL, or is cut off",
        "text begins with \"solid\"; a binary file has 84 bytes and 50 more for each triangle it announces");
  const auto triangles = count ? parse_binary(bytes, *count, file_name) : parse_text(bytes, file_name);
  if (triangles.empty()) refuse(file_name, "it holds no triangles");
  return triangles;
}

}  // namespace plumb
