#include "lib/output/particles.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <stdexcept>

#include "lib/core/error.hpp"
#include "lib/output/file.hpp"

namespace plumb {
namespace {

static_assert(std::endian::native == std::endian::little, "the files are declared little-endian");

std::string base64(const std::string& bytes) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - k);
    std::uint32_t group = 0;
    for (std::size_t m = 0; m < 3; ++m)
      group = group << 8 | (m < count ? static_cast<unsigned char>(bytes[k + m]) : 0U);
    for (std::size_t m = 0; m < 4; ++m) text += m <= count ? digits[group >> (18 - 6 * m) & 63] : '=';
  }
  return text;
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  return result;
}

/// One <DataArray>: VTK wants the number of bytes (UInt64) and the data encoded in one go.
template <class T>
std::string data_array(const std::string& name, int components, const std::vector<T>& values) {
  const std::uint64_t size = values.size() * sizeof(T);
  std::string bytes(sizeof size + size, '\0');
  std::memcpy(bytes.data(), &size, sizeof size);
  if (size > 0) std::memcpy(bytes.data() + sizeof size, values.data(), size);
  const char* type = std::is_same_v<T, double> ? "Float64" : "Int64";
  return fmt::format(
      "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">\n{}\n</DataArray>\n",
      type, escaped(name), components, base64(bytes));
}

std::string field_array(const PointField& field, std::size_t particles) {
  if (field.components < 1 || field.values.size() != particles * field.components)
    throw std::invalid_argument(
        fmt::format("field \"{}\" has {} numbers for {} particles with {} components each", field.name,
                    field.values.size(), particles, field.components));
  if (field.components == 2) return data_array(field.name, 3, padded_to_three(field.values, 2));
  return data_array(field.name, field.components,
                    std::vector<double>(field.values.begin(), field.values.end()));
}

}  // namespace

std::vector<double> padded_to_three(std::span<const double> values, int components) {
  std::vector<double> padded(values.size() / components * 3, 0.0);
  for (std::size_t k = 0; k < values.size(); ++k) padded[k / components * 3 + k % components] = values[k];
  return padded;
}

std::string vtp_text(const ParticleFrame& frame) {
  if (frame.dimension < 1 || frame.dimension > 3 || frame.positions.size() % frame.dimension != 0)
    throw std::invalid_argument("positions do not fit the dimension");
  const std::size_t count = frame.positions.size() / frame.dimension;
  std::vector<std::int64_t> numbers(count), ends(count);
  for (std::size_t i = 0; i < count; ++i) {
    numbers[i] = static_cast<std::int64_t>(i);
    ends[i] = static_cast<std::int64_t>(i) + 1;
  }
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<PolyData>\n<FieldData>\n";
  text += fmt::format(
      "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
      "format=\"ascii\">{:.17g}</DataArray>\n"
      "</FieldData>\n<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"0\" "
      "NumberOfStrips=\"0\" "
      "NumberOfPolys=\"0\">\n<PointData>\n",
      frame.time, count, count);
  text += data_array("id", 1, numbers);
  for (const auto& field : frame.fields) text += field_array(field, count);
  text += "</PointData>\n<Points>\n" +
          data_array("Points", 3, padded_to_three(frame.positions, frame.dimension)) +
          "</Points>\n<Verts>\n" + data_array("connectivity", 1, numbers) + data_array("offsets", 1, ends) +
          "</Verts>\n</Piece>\n</PolyData>\n</VTKFile>\n";
  return text;
}

std::string ParticleSeries::file_name(std::size_t number) const {
  return fmt::format("{}_{:06}.vtp", name_, number);
}

void ParticleSeries::write(const ParticleFrame& frame) {
  replace_file(folder_ / file_name(times_.size()), vtp_text(frame), Flush::later);
  times_.push_back(frame.time);
  write_index();
}

void ParticleSeries::resume(std::vector<double> times) {
  for (std::size_t k = 0; k < times.size(); ++k)
    if (std::error_code none; !(std::filesystem::file_size(folder_ / file_name(k), none) > 0) || none)
      throw InputError(fmt::format("{} cannot be continued", index_file().string()),
                       fmt::format("there is no {}", file_name(k)), "start the run anew, without --resume");
  times_ = std::move(times);
  flushed_ = times_.size();
  remove_from(times_.size());
  write_index();
}

void ParticleSeries::clear() {
  std::filesystem::remove(index_file());
  remove_from(0);
}

void ParticleSeries::flush() {
  for (; flushed_ < times_.size(); ++flushed_) flush_file(folder_ / file_name(flushed_));
  if (!times_.empty()) flush_file(index_file());
}

void ParticleSeries::finish() {
  if (times_.empty()) return;
  flush_file(folder_ / file_name(times_.size() - 1));
  flush_file(index_file());
}

/// Removes the files of this name whose number is at least that: NAME_ and digits, nothing else.
void ParticleSeries::remove_from(std::size_t number) const {
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder_, none)) {
    const std::string file = entry.path().filename().string();
    if (!file.starts_with(name_ + "_") || entry.path().extension() != ".vtp") continue;
    const std::string digits = entry.path().stem().string().substr(name_.size() + 1);
    if (digits.size() < 6 || digits.size() > 18 ||
        digits.find_first_not_of("0123456789") != std::string::npos)
      continue;
    if (std::stoull(digits) >= number) std::filesystem::remove(entry.path(), none);
  }
}

void ParticleSeries::write_index() const {
  std::string index =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      "<Collection>\n";
  for (std::size_t k = 0; k < times_.size(); ++k)
    index += fmt::format("<DataSet timestep=\"{:.17g}\" group=\"\" part=\"0\" file=\"{}\"/>\n", times_[k],
                         escaped(file_name(k)));
  replace_file(index_file(), index + "</Collection>\n</VTKFile>\n", Flush::later);
}

}  // namespace plumb
