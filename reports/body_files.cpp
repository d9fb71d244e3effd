#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <sstream>

#include "reports/body.hpp"
#include "reports/results.hpp"

namespace plumb::reports {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in) throw MissingResult(fmt::format("there is no {}", file.filename().string()));
  return text.str();
}

/// What follows `key` up to `end`, from place `from` on; `from` moves behind it.
std::string between(const std::string& text, const std::string& key, const std::string& end,
                    std::size_t& from) {
  const std::size_t start = text.find(key, from);
  if (start == std::string::npos) return {};
  const std::size_t first = start + key.size(), last = text.find(end, first);
  if (last == std::string::npos) return {};
  from = last;
  return text.substr(first, last - first);
}

std::string bytes_of(const std::string& base64) {
  std::string bytes;
  std::uint32_t group = 0;
  int bits = 0;
  for (const char c : base64) {
    const int digit = c >= 'A' && c <= 'Z'   ? c - 'A'
                      : c >= 'a' && c <= 'z' ? c - 'a' + 26
                      : c >= '0' && c <= '9' ? c - '0' + 52
                      : c == '+'             ? 62
                      : c == '/'             ? 63
                                             : -1;
    if (digit < 0) continue;
    group = group << 6 | static_cast<std::uint32_t>(digit);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(group >> bits & 0xFF);
  }
  return bytes;
}

/// The array of that name: 8 bytes that say how many follow, and doubles.
std::vector<double> array_of(const std::string& vtp, const std::string& name, const fs::path& file) {
  std::size_t from = vtp.find("Name=\"" + name + "\"");
  const std::string bytes = from == std::string::npos ? "" : bytes_of(between(vtp, ">", "<", from));
  if (bytes.size() < 8 || bytes.size() % 8 != 0)
    throw MissingResult(fmt::format("{} has no \"{}\"", file.filename().string(), name));
  std::vector<double> values(bytes.size() / 8 - 1);
  std::memcpy(values.data(), bytes.data() + 8, bytes.size() - 8);
  return values;
}

BodyState state_of(const fs::path& file, double time, const std::string& field) {
  const std::string vtp = text_of(file);
  const auto points = array_of(vtp, "Points", file), moved = array_of(vtp, "displacement [m]", file);
  BodyState state{time, {}, {}, array_of(vtp, field, file)};
  if (moved.size() != points.size() || 3 * state.value.size() != points.size())
    throw MissingResult(fmt::format("the arrays of {} do not fit", file.filename().string()));
  for (std::size_t k = 0; k < points.size(); k += 3) {
    state.position.push_back({points[k], points[k + 1], points[k + 2]});
    state.reference.push_back(
        {points[k] - moved[k], points[k + 1] - moved[k + 1], points[k + 2] - moved[k + 2]});
  }
  return state;
}

}  // namespace

std::vector<BodyState> read_states(const fs::path& folder, const std::string& field) {
  const std::string index = text_of(folder / "particles.pvd");
  std::vector<BodyState> states;
  for (std::size_t at = 0;;) {
    const std::string time = between(index, "timestep=\"", "\"", at);
    const std::string file = time.empty() ? "" : between(index, "file=\"", "\"", at);
    if (file.empty()) break;
    states.push_back(state_of(folder / file, std::strtod(time.c_str(), nullptr), field));
  }
  if (states.empty()) throw MissingResult("a run wrote no particles");
  return states;
}

BodyState last_state(const std::map<std::string, std::vector<double>>& table, double time,
                     const std::string& field) {
  const auto column = [&table](const std::string& name) -> const std::vector<double>& {
    const auto found = table.find(name);
    if (found == table.end()) throw MissingResult("a table has no column \"" + name + "\"");
    return found->second;
  };
  BodyState state{time, {}, {}, column(field)};
  state.position.resize(state.value.size());
  state.reference.resize(state.value.size());
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string axis(1, "xyz"[k]);
    if (k == 2 && !table.contains("position z [m]")) break;
    const auto &x = column("position " + axis + " [m]"), &u = column("displacement " + axis + " [m]");
    for (std::size_t p = 0; p < state.value.size(); ++p) {
      state.position[p][k] = x[p];
      state.reference[p][k] = x[p] - u[p];
    }
  }
  return state;
}

}  // namespace plumb::reports
