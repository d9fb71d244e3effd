// HDF5 with named data sets: of each point a row. H5MD's "position/value" of one frame is read too.
#include <fmt/format.h>
#include <hdf5.h>
#include <hdf5_hl.h>

#include <algorithm>
#include <boost/algorithm/string.hpp>
#include <cstring>
#include <map>

#include "lib/core/error.hpp"
#include "lib/input/own_process.hpp"
#include "lib/input/point_bytes.hpp"
#include "lib/input/point_formats.hpp"

namespace plumb {
namespace {

[[noreturn]] void refuse(const std::string& file_name, const std::string& problem,
                         const std::string& why = "", const std::string& suggestion = "") {
  throw InputError(fmt::format("{}: {}", file_name, problem), why, suggestion);
}

/// HDF5 prints no errors of its own while it lives.
class Quiet {
 public:
  Quiet() {
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Quiet() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

 private:
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

/// An open file, closed with all that is open in it.
class File {
 public:
  explicit File(const std::string& bytes, const std::string& file_name) {
    std::string copy = bytes;  // HDF5 wants to be able to write to it
    id_ = H5LTopen_file_image(copy.data(), copy.size(), 0);
    if (id_ < 0) refuse(file_name, "HDF5 cannot open it", "it is damaged or cut off");
  }
  ~File() { H5Fclose(id_); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  hid_t id() const { return id_; }

 private:
  hid_t id_ = -1;
};

/// Whether the first block fits the file: its end is that of the bytes, and no driver is named. HDF5 1.10
/// believes what stands there, and takes seconds or memory without end for what does not fit.
bool first_block_fits(const std::string& bytes) {
  constexpr std::size_t length = 56;  // of the shorter ones that matter here
  if (bytes.size() < length) return false;
  const auto number_at = [&](std::size_t place) {
    std::uint64_t number = 0;
    std::memcpy(&number, bytes.data() + place, sizeof number);
    return number;
  };
  const auto version = static_cast<unsigned char>(bytes[8]);
  if (version == 0)
    return number_at(24) == 0 && number_at(40) == bytes.size() && number_at(48) == ~std::uint64_t{0};
  return (version == 2 || version == 3) && number_at(12) == 0 && number_at(28) == bytes.size();
}

/// A data set of numbers: one for each row, or a vector.
struct DataSet {
  std::string path, group, name;
  std::size_t rows = 0, columns = 1;
};

/// The group and name of a path; of "../position/value" (H5MD) the name is "position".
void name_of(DataSet& set) {
  std::vector<std::string> parts;
  boost::split(parts, set.path, [](char c) { return c == '/'; });
  if (parts.size() > 1 && parts.back() == "value") parts.pop_back();
  set.name = boost::trim_copy(parts.back().substr(0, parts.back().find('[')));
  parts.pop_back();
  set.group = boost::join(parts, "/");
}

struct Search {
  std::size_t most = 0;  ///< numbers that a file of this length can hold
  std::vector<DataSet> sets;
};

/// Takes the data sets of numbers with one or two dimensions (three where the first is one frame).
herr_t look_at(hid_t file, const char* path, const H5O_info_t* info, void* data) {
  auto& search = *static_cast<Search*>(data);
  if (info->type != H5O_TYPE_DATASET) return 0;
  int rank = 0;
  std::array<hsize_t, 3> size{1, 1, 1};
  H5T_class_t type = H5T_NO_CLASS;
  std::size_t bytes = 0;
  if (H5LTget_dataset_ndims(file, path, &rank) < 0 || rank < 1 || rank > 3) return 0;
  if (H5LTget_dataset_info(file, path, size.data(), &type, &bytes) < 0) return 0;
  if (type != H5T_FLOAT && type != H5T_INTEGER) return 0;
  if (rank == 3 && size[0] != 1) return 0;
  if (rank == 3) size = {size[1], size[2], 1};
  if (size[0] == 0 || size[1] == 0 || size[1] > 100 || size[0] > search.most / size[1]) return 0;
  DataSet set{path, {}, {}, size[0], size[1]};
  name_of(set);
  search.sets.push_back(set);
  return 0;
}

std::vector<double> values_of(hid_t file, const DataSet& set, const std::string& file_name) {
  std::vector<double> values(set.rows * set.columns);
  if (H5LTread_dataset(file, set.path.c_str(), H5T_NATIVE_DOUBLE, values.data()) < 0)
    refuse(file_name, fmt::format("its data set {} cannot be read", set.path));
  return values;
}

/// The columns of a group: vectors as they stand, and neighbouring ones such as ux, uy put together.
std::vector<PointColumn> columns_of(hid_t file, const std::vector<DataSet>& group, std::size_t rows,
                                    const std::string& file_name) {
  std::vector<PointColumn> columns;
  std::vector<std::string> names;
  std::vector<std::vector<double>> table(rows);
  for (const DataSet& set : group) {
    if (set.rows != rows) continue;
    std::vector<double> values = values_of(file, set, file_name);
    if (set.columns > 1) {
      columns.push_back({set.name, static_cast<int>(set.columns), std::move(values)});
      continue;
    }
    names.push_back(set.name);
    for (std::size_t k = 0; k < rows; ++k) table[k].push_back(values[k]);
  }
  for (PointColumn& column : grouped_columns(names, table)) columns.push_back(std::move(column));
  return columns;
}

/// Rows of the positions of a group, which may stand in x, y, z; nothing if it has none.
std::size_t rows_of(const std::vector<DataSet>& group) {
  const auto& known = position_names();
  for (const DataSet& set : group)
    if (set.columns >= 2 && set.columns <= 3 &&
        std::any_of(known.begin(), known.end(),
                    [&](const auto& name) { return boost::iequals(name, set.name); }))
      return set.rows;
  for (const DataSet& x : group)
    for (const DataSet& y : group)
      if (x.columns == 1 && boost::iequals(x.name, "x") && boost::iequals(y.name, "y") && x.rows == y.rows)
        return x.rows;
  return 0;
}

std::optional<double> time_of(hid_t file, const std::string& group) {
  for (const std::string& place : {group.empty() ? std::string("/") : group, std::string("/")})
    for (const char* name : {"time", "Time", "TimeValue"}) {
      if (H5Aexists_by_name(file, place.c_str(), name, H5P_DEFAULT) <= 0) continue;
      int rank = 0;
      std::array<hsize_t, 32> size{};
      H5T_class_t type = H5T_NO_CLASS;
      std::size_t bytes = 0;
      if (H5LTget_attribute_ndims(file, place.c_str(), name, &rank) < 0 || rank > 1) continue;
      if (H5LTget_attribute_info(file, place.c_str(), name, size.data(), &type, &bytes) < 0) continue;
      if ((type != H5T_FLOAT && type != H5T_INTEGER) || (rank == 1 && size[0] != 1)) continue;
      double time = 0;
      if (H5LTget_attribute_double(file, place.c_str(), name, &time) >= 0) return time;
    }
  return std::nullopt;
}

/// All data sets, for messages.
std::string listed(const std::vector<DataSet>& sets) {
  std::vector<std::string> words;
  for (const DataSet& set : sets)
    words.push_back(fmt::format("{} ({} x {})", set.path, set.rows, set.columns));
  return words.empty() ? "it has no data sets of numbers" : "its data sets are " + join(words);
}

constexpr std::size_t packing = 1100;  // zlib packs at most by 1032

/// In the process that may break.
PointFile read_here(const std::string& bytes, const std::string& file_name) {
  const Quiet quiet;
  const File file(bytes, file_name);
  Search search{bytes.size() * packing / sizeof(double), {}};
  if (H5Ovisit2(file.id(), H5_INDEX_NAME, H5_ITER_INC, look_at, &search, H5O_INFO_BASIC) < 0)
    refuse(file_name, "HDF5 cannot read its groups", "it is damaged");
  std::map<std::string, std::vector<DataSet>> groups;
  for (const DataSet& set : search.sets) groups[set.group].push_back(set);
  std::erase_if(groups, [](const auto& group) { return rows_of(group.second) == 0; });
  if (groups.empty())
    refuse(file_name, "it has no positions", listed(search.sets),
           "they stand in a data set \"position\" of one row for each point, or in x, y and, in 3D, z");
  if (groups.size() > 1)
    refuse(file_name,
           fmt::format("positions stand in the groups {} and {}", groups.begin()->first,
                       std::next(groups.begin())->first),
           "a file is read as one body", "write each to its own");
  const auto& [group, sets] = *groups.begin();
  PointFile out;
  out.count = rows_of(sets);
  out.columns = columns_of(file.id(), sets, out.count, file_name);
  out.time = time_of(file.id(), group);
  return out;
}

}  // namespace

bool is_hdf5(const std::string& bytes) {
  return bytes.starts_with("\x89HDF\r\n\x1a\n");
}

/// HDF5 1.10 believes the sizes and kinds in a file's headers: of damaged ones it takes memory and time without
/// end, and some end it.
PointFile parse_hdf5(const std::string& bytes, const std::string& file_name) {
  if (!first_block_fits(bytes)) refuse(file_name, "HDF5 cannot open it", "it is damaged or cut off");
  constexpr std::size_t own = 256 << 20;       // of the library, and of an allocator's arenas
  constexpr std::size_t per_second = 1 << 20;  // less than any disc gives
  const auto read = made_in_own_process(
      [&] {
        try {
          return bytes_of(read_here(bytes, file_name));
        } catch (const InputError& error) {
          return bytes_of(error);
        }
      },
      {own + packing * bytes.size(), 10 + bytes.size() / per_second});
  if (!read) refuse(file_name, "HDF5 cannot read it", "it is damaged");
  return points_of(*read);
}

}  // namespace plumb
