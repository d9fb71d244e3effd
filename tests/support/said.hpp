#pragma once
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

/// What a program said, as lines that can be kept in a file and compared later: text to the letter, numbers
/// to a tolerance.
namespace plumb::test {

/// One line for each value of a document, "rows.0.l2 = 0.1"; lists of numbers in one line.
inline void append_lines(const nlohmann::json& value, const std::string& path,
                         std::vector<std::string>& lines) {
  const auto plain = [](const auto& entry) { return entry.is_primitive(); };
  if (value.is_object()) {
    for (const auto& [key, part] : value.items())
      append_lines(part, path.empty() ? key : path + "." + key, lines);
  } else if (value.is_array() && !std::all_of(value.begin(), value.end(), plain)) {
    for (std::size_t n = 0; n < value.size(); ++n)
      append_lines(value[n], path + "." + std::to_string(n), lines);
  } else {
    std::istringstream words(value.dump());
    std::string line;
    std::getline(words, line);
    lines.push_back(path + " = " + line);
  }
}

/// The lines of a text.
inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// The cells of a line: CSV, or a table whose columns stand apart by two blanks and more.
inline std::vector<std::string> cells_of(const std::string& line) {
  static const std::regex wide("  +"), comma(",");
  const std::regex& by = line.find("  ") == std::string::npos ? comma : wide;
  return {std::sregex_token_iterator(line.begin(), line.end(), by, -1), {}};
}

/// Tables without the columns of measured times.
inline std::vector<std::string> without_times(const std::vector<std::string>& lines) {
  static const std::regex time("cpu|wall|setup|solve|spread");
  std::vector<std::size_t> dropped;
  std::size_t width = 0;
  std::vector<std::string> kept;
  for (const auto& line : lines) {
    auto cells = cells_of(line);
    if (cells.size() > 2 && std::regex_search(line, time)) {  // a heading
      dropped.clear();
      width = cells.size();
      for (std::size_t n = width; n-- > 0;)
        if (std::regex_search(cells[n], time)) dropped.push_back(n);
    }
    if (dropped.empty() || cells.size() != width) {
      kept.push_back(line);
      continue;
    }
    for (const std::size_t n : dropped) cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(n));
    kept.push_back(fmt::format("{}", fmt::join(cells, "  ")));
  }
  return kept;
}

/// A text as its words and its numbers: "#" stands in the words for each number.
struct WordsAndNumbers {
  std::string words;
  std::vector<double> numbers;

  explicit WordsAndNumbers(const std::string& line) {
    static const std::regex number(R"((^|[^\w.])(-?\d+(\.\d*)?([eE][-+]?\d+)?)(?![\w]))");
    auto at = line.begin();
    for (std::sregex_iterator found(line.begin(), line.end(), number), end; found != end; ++found) {
      words.append(at, line.begin() + found->position(2));
      words += '#';
      numbers.push_back(std::stod(found->str(2)));
      at = line.begin() + found->position(2) + found->length(2);
    }
    words.append(at, line.end());
    static const std::regex blanks(" +");  // tables are as wide as their numbers
    words = std::regex_replace(words, blanks, " ");
  }
};

/// A line with as many digits as are compared.
inline std::string rounded(const std::string& line) {
  const WordsAndNumbers parts(line);
  std::string out;
  std::size_t next = 0;
  for (const char c : parts.words)
    if (c == '#' && next < parts.numbers.size())
      out += fmt::format("{:.8g}", parts.numbers[next++]);
    else
      out += c;
  return out;
}

/// Numbers agree to `relative`, or both are below `floor`: round-off differs from machine to machine.
inline bool agree(const std::string& line, const std::string& kept, double relative, double floor) {
  const WordsAndNumbers a(line), b(kept);
  if (a.words != b.words || a.numbers.size() != b.numbers.size()) return false;
  for (std::size_t n = 0; n < a.numbers.size(); ++n) {
    const double x = a.numbers[n], y = b.numbers[n], size = std::max(std::abs(x), std::abs(y));
    if (size > floor && std::abs(x - y) > relative * size) return false;
  }
  return true;
}

/// The first lines that differ, empty if none does.
inline std::string differences(const std::vector<std::string>& now, const std::vector<std::string>& kept,
                               double relative, double floor) {
  std::string all;
  int count = 0;
  for (std::size_t n = 0; n < std::max(now.size(), kept.size()) && count < 5; ++n) {
    const std::string line = n < now.size() ? now[n] : "(nothing)",
                      old = n < kept.size() ? kept[n] : "(nothing)";
    if (agree(line, old, relative, floor)) continue;
    all += fmt::format("line {}: {}\n  it was: {}\n", n + 1, line, old);
    ++count;
  }
  return all;
}

}  // namespace plumb::test
