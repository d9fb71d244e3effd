// VTK's XML files of points: PolyData (.vtp) and UnstructuredGrid (.vtu); ascii, base64 and raw, with zlib or
// not.
#include <fmt/format.h>

#include <bit>
#include <boost/algorithm/string.hpp>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <set>

#include "lib/input/point_formats.hpp"
#include "lib/input/vtk_text.hpp"

namespace plumb {
namespace {

static_assert(std::endian::native == std::endian::little, "files are read as little-endian");

/// What is said once in a file about all its arrays.
struct Encoding {
  bool wide = false;    ///< header_type UInt64
  bool packed = false;  ///< zlib
};

std::size_t size_of_type(const std::string& type) {
  if (type.ends_with("64")) return 8;
  if (type.ends_with("32")) return 4;
  if (type.ends_with("16")) return 2;
  return type.ends_with("8") ? 1 : 0;
}

template <class T>
void append(std::string_view bytes, std::vector<double>& values) {
  for (std::size_t k = 0; k + sizeof(T) <= bytes.size(); k += sizeof(T)) {
    T value;
    std::memcpy(&value, bytes.data() + k, sizeof value);
    values.push_back(static_cast<double>(value));
  }
}

bool append_as(const std::string& type, std::string_view bytes, std::vector<double>& values) {
  if (type == "Float64") return append<double>(bytes, values), true;
  if (type == "Float32") return append<float>(bytes, values), true;
  if (type == "Int64") return append<std::int64_t>(bytes, values), true;
  if (type == "UInt64") return append<std::uint64_t>(bytes, values), true;
  if (type == "Int32") return append<std::int32_t>(bytes, values), true;
  if (type == "UInt32") return append<std::uint32_t>(bytes, values), true;
  if (type == "Int16") return append<std::int16_t>(bytes, values), true;
  if (type == "UInt16") return append<std::uint16_t>(bytes, values), true;
  if (type == "Int8") return append<std::int8_t>(bytes, values), true;
  if (type == "UInt8") return append<std::uint8_t>(bytes, values), true;
  return false;
}

/// The header's next number; the bytes behind it remain. Too short: a size that cannot be.
std::uint64_t header_number(std::string_view& bytes, bool wide) {
  const std::size_t size = wide ? 8 : 4;
  std::uint64_t value = 0;
  if (bytes.size() < size) return ~std::uint64_t{0};
  std::memcpy(&value, bytes.data(), size);
  bytes.remove_prefix(size);
  return value;
}

/// The array's own bytes, of which there must be `wanted`.
std::string content_of(std::string_view bytes, const Encoding& encoding, std::size_t wanted,
                       const VtkText& file) {
  if (!encoding.packed) {
    const std::uint64_t size = header_number(bytes, encoding.wide);
    if (size != wanted || bytes.size() < wanted)
      file.fail(fmt::format("an array holds {} bytes, {} are expected",
                            std::min<std::uint64_t>(size, bytes.size()), wanted));
    return std::string(bytes.substr(0, wanted));
  }
  const std::uint64_t blocks = header_number(bytes, encoding.wide),
                      whole = header_number(bytes, encoding.wide), last = header_number(bytes, encoding.wide);
  // zlib packs at most by 1032: what claims more is no zlib
  if (blocks > bytes.size() || wanted / 1100 > bytes.size()) file.fail("a packed array is cut off");
  std::vector<std::uint64_t> sizes;
  for (std::uint64_t k = 0; k < blocks; ++k) sizes.push_back(header_number(bytes, encoding.wide));
  std::string content;
  for (std::uint64_t k = 0; k < blocks; ++k) {
    const std::uint64_t size = k + 1 == blocks && last != 0 ? last : whole;
    if (sizes[k] > bytes.size() || size > wanted - content.size()) file.fail("a packed array is cut off");
    if (!inflate_exactly(bytes.substr(0, sizes[k]), size, content)) file.fail("a packed array is damaged");
    bytes.remove_prefix(sizes[k]);
  }
  if (content.size() != wanted)
    file.fail(fmt::format("an array holds {} bytes, {} are expected", content.size(), wanted));
  return content;
}

std::vector<double> ascii_numbers(std::string_view text, const VtkText& file) {
  std::vector<double> values;
  for (std::size_t at = 0; (at = text.find_first_not_of(" \t\r\n", at)) != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(" \t\r\n", at), text.size());
    double value = 0;
    const auto [rest, error] = std::from_chars(text.data() + at, text.data() + end, value);
    if (error != std::errc() || rest != text.data() + end)
      file.fail(fmt::format("\"{}\" is no number", text.substr(at, std::min<std::size_t>(end - at, 20))));
    values.push_back(value);
    at = end;
  }
  return values;
}

std::size_t whole_number(const std::string& text, std::size_t otherwise) {
  std::size_t value = otherwise;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// The part of the appended data from an offset to where the next array begins.
std::string_view appended_part(const VtkText& file, const std::set<std::size_t>& offsets,
                               std::size_t offset) {
  const std::string_view all = file.appended();
  if (offset > all.size()) file.fail("an array begins beyond the end of the file");
  const auto next = offsets.upper_bound(offset);
  return all.substr(offset, (next == offsets.end() ? all.size() : std::min(*next, all.size())) - offset);
}

PointColumn column_of(const Tag& tag, std::size_t points, const Encoding& encoding, const VtkText& file,
                      const std::set<std::size_t>& offsets) {
  std::string name = tag.attribute("Name", "unnamed");
  name = boost::trim_copy(name.substr(0, name.find('[')));
  const std::size_t components = whole_number(tag.attribute("NumberOfComponents"), 1);
  const std::string type = tag.attribute("type"), format = tag.attribute("format", "ascii");
  if (components < 1 || components > 100) file.fail(fmt::format("{} has {} components", name, components));
  PointColumn column{name, static_cast<int>(components), {}};
  if (format == "ascii") {
    column.values = ascii_numbers(tag.text, file);
  } else {
    const std::size_t wanted = points * components * size_of_type(type);
    if (wanted == 0 && points > 0) file.fail(fmt::format("{} has the unknown type {}", name, type));
    const bool appended = format == "appended";
    const std::string_view text =
        appended ? appended_part(file, offsets, whole_number(tag.attribute("offset"), ~std::size_t{0}))
                 : tag.text;
    std::string bytes;
    if (!(appended && file.raw()) && !decode_base64(text, bytes))
      file.fail(fmt::format("{} is no base64", name));
    append_as(type, content_of(appended && file.raw() ? text : bytes, encoding, wanted, file), column.values);
  }
  if (column.values.size() != points * components)
    file.fail(fmt::format("{} has {} numbers for {} points of {} components", name, column.values.size(),
                          points, components));
  return column;
}

/// Puts the column of a further piece behind that of the pieces before.
void join_column(PointFile& out, PointColumn column) {
  for (PointColumn& known : out.columns)
    if (known.name == column.name && known.components == column.components) {
      known.values.insert(known.values.end(), column.values.begin(), column.values.end());
      return;
    }
  out.columns.push_back(std::move(column));
}

/// Where the arrays of the file begin in the appended data.
std::set<std::size_t> offsets_of(VtkText file) {
  std::set<std::size_t> offsets;
  for (Tag tag; file.next(tag);)
    if (tag.name == "DataArray" && tag.attributes.contains("offset"))
      offsets.insert(whole_number(tag.attribute("offset"), 0));
  return offsets;
}

Encoding encoding_of(const Tag& tag, const VtkText& file) {
  const std::string compressor = tag.attribute("compressor");
  if (tag.attribute("byte_order", "LittleEndian") != "LittleEndian") file.fail("it is big-endian");
  if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
    file.fail(fmt::format("it is packed by {}; write it with zlib or unpacked", compressor));
  return {tag.attribute("header_type", "UInt32") == "UInt64", !compressor.empty()};
}

}  // namespace

PointFile parse_vtk(const std::string& bytes, const std::string& file_name) {
  VtkText file(bytes, file_name);
  const std::set<std::size_t> offsets = offsets_of(file);
  PointFile out;
  Encoding encoding;
  std::string inside;  // PointData, Points, FieldData or what does not matter
  std::size_t points = 0;
  bool vtk = false;
  for (Tag tag; file.next(tag);) {
    if (tag.name == "VTKFile") {
      encoding = encoding_of(tag, file);
      vtk = true;
    } else if (tag.name == "Piece") {
      points = whole_number(tag.attribute("NumberOfPoints"), 0);
      if (points > bytes.size() * 1100) file.fail(fmt::format("{} points in {} bytes", points, bytes.size()));
      out.count += points;
    } else if (tag.name == "PointData" || tag.name == "Points" || tag.name == "FieldData" ||
               tag.name == "CellData" || tag.name == "Cells" || tag.name == "Verts") {
      inside = tag.empty ? "" : tag.name;
    } else if (tag.name.starts_with('/') && tag.name.substr(1) == inside) {
      inside.clear();
    } else if (tag.name == "DataArray" && inside == "Points") {
      const PointColumn column = column_of(tag, points, encoding, file, offsets);
      if (column.components != 3) file.fail("positions have not three components");
      out.positions.insert(out.positions.end(), column.values.begin(), column.values.end());
    } else if (tag.name == "DataArray" && inside == "PointData" && tag.attribute("type") != "String") {
      join_column(out, column_of(tag, points, encoding, file, offsets));
    } else if (tag.name == "DataArray" && inside == "FieldData" && tag.attribute("Name") == "TimeValue") {
      out.time = column_of(tag, 1, encoding, file, offsets).values.front();
    }
  }
  if (!vtk) file.fail("there is no VTKFile in it");
  for (const PointColumn& column : out.columns)
    if (column.values.size() != out.count * static_cast<std::size_t>(column.components))
      file.fail(fmt::format("{} is not in every piece", column.name));
  if (out.positions.size() != 3 * out.count) file.fail("there are no positions");
  return out;
}

}  // namespace plumb
