#include "lib/output/hdf5_image.hpp"

#include <fmt/format.h>
#include <hdf5.h>
#include <hdf5_hl.h>

#include <array>
#include <cstring>
#include <stdexcept>
#include <type_traits>

#include "lib/core/error.hpp"

namespace plumb {
namespace {

static_assert(sizeof(hid_t) == sizeof(std::int64_t));

/// HDF5 tells no errors of its own while it lives: they become exceptions here.
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

void require(herr_t status, const char* what) {
  if (status < 0) throw std::runtime_error(fmt::format("HDF5 cannot {}", what));
}

[[noreturn]] void refuse(const char* name, const char* problem) {
  throw InputError(fmt::format("its data set \"{}\" {}", name, problem), "", "");
}

/// The number of elements of a data set of one or two dimensions and of the class wanted.
std::size_t size_of(hid_t file, const char* name, H5T_class_t wanted, std::size_t most) {
  int rank = 0;
  std::array<hsize_t, 2> size{1, 1};
  H5T_class_t type = H5T_NO_CLASS;
  std::size_t bytes = 0;
  if (H5LTfind_dataset(file, name) != 1 || H5LTget_dataset_ndims(file, name, &rank) < 0)
    refuse(name, "is missing");
  if (rank > 2 || H5LTget_dataset_info(file, name, size.data(), &type, &bytes) < 0 || type != wanted)
    refuse(name, "has another type");
  if (size[0] > most || size[1] > most || size[0] * size[1] > most || bytes > most)
    refuse(name, "is larger than the file");
  return type == H5T_STRING ? bytes : size[0] * size[1];
}

template <class T>
std::vector<T> values_of(hid_t file, const char* name, std::size_t count, std::size_t most) {
  constexpr bool real = std::is_same_v<T, double>;
  const Quiet quiet;
  const std::size_t size = size_of(file, name, real ? H5T_FLOAT : H5T_INTEGER, most);
  if (count != 0 && size != count) refuse(name, "has another size");
  std::vector<T> values(size);
  if (H5LTread_dataset(file, name, real ? H5T_NATIVE_DOUBLE : H5T_NATIVE_INT64, values.data()) < 0)
    refuse(name, "cannot be read");
  return values;
}

std::uint64_t number_at(std::string_view bytes, std::size_t place) {
  std::uint64_t number = 0;
  std::memcpy(&number, bytes.data() + place, sizeof number);
  return number;
}

/// Whether a file begins as every file of this program does, an empty one too: superblock (version 0) and
/// header of the root group are the same but for the end of the file, and the group's names lie within the
/// file. HDF5 1.10 believes what stands there: it takes memory and seconds for names of any size, and for a
/// driver's block beyond the end.
bool begins_as_ours(std::string_view bytes) {
  constexpr std::size_t end = 40, heap = 88, length = 136;  // places in the file
  std::string expected = Hdf5Image().bytes().substr(0, length);
  const std::uint64_t size = bytes.size();
  std::memcpy(expected.data() + end, &size, sizeof size);
  if (!bytes.starts_with(expected)) return false;
  const std::uint64_t names = number_at(bytes, heap);
  if (names > size || size - names < 32) return false;
  const std::uint64_t taken = number_at(bytes, names + 8), place = number_at(bytes, names + 24);
  return taken <= size && place <= size - taken;
}

}  // namespace

Hdf5Image::Hdf5Image() {
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  constexpr std::size_t growth = std::size_t{1} << 16U;
  H5Pset_fapl_core(access, growth, false);
  // HDF5 takes files in memory of the same name for the same file: the address is another one for each that
  // lives
  const std::string name = fmt::format("image {}", static_cast<const void*>(this));
  file_ = H5Fcreate(name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
  H5Pclose(access);
  if (file_ < 0) throw std::runtime_error("HDF5 cannot make a file in memory");
}

Hdf5Image::Hdf5Image(std::string_view bytes) : most_(bytes.size()) {
  const Quiet quiet;
  if (!begins_as_ours(bytes))
    throw InputError("it is not an HDF5 file of this program", "its first block differs", "");
  std::string copy(bytes);  // HDF5 wants to be able to write to it
  file_ = H5LTopen_file_image(copy.data(), copy.size(), 0);
  if (file_ < 0) throw InputError("it is not an HDF5 file", "", "");
}

Hdf5Image::~Hdf5Image() {
  const Quiet quiet;
  H5Fclose(file_);
}

void Hdf5Image::write(const char* name, const std::string& text) const {
  require(H5LTmake_dataset_string(file_, name, text.c_str()), "write text");
}

void Hdf5Image::write(const char* name, const std::vector<std::int64_t>& values) const {
  const hsize_t size = values.size();
  require(H5LTmake_dataset(file_, name, 1, &size, H5T_NATIVE_INT64, values.data()), "write whole numbers");
}

void Hdf5Image::write(const char* name, const std::vector<double>& values, std::size_t columns) const {
  const std::array<hsize_t, 2> size{values.size() / columns, columns};
  require(H5LTmake_dataset(file_, name, columns > 1 ? 2 : 1, size.data(), H5T_NATIVE_DOUBLE, values.data()),
          "write numbers");
}

bool Hdf5Image::has(const char* name) const {
  const Quiet quiet;
  return H5LTfind_dataset(file_, name) == 1;
}

std::string Hdf5Image::text(const char* name) const {
  const Quiet quiet;
  std::string text(size_of(file_, name, H5T_STRING, most_), '\0');
  if (H5LTread_dataset_string(file_, name, text.data()) < 0) refuse(name, "cannot be read");
  while (!text.empty() && text.back() == '\0') text.pop_back();
  return text;
}

std::vector<double> Hdf5Image::numbers(const char* name, std::size_t count) const {
  return values_of<double>(file_, name, count, most_);
}

std::vector<std::int64_t> Hdf5Image::integers(const char* name, std::size_t count) const {
  return values_of<std::int64_t>(file_, name, count, most_);
}

std::string Hdf5Image::bytes() const {
  require(H5Fflush(file_, H5F_SCOPE_GLOBAL), "flush");
  const ssize_t size = H5Fget_file_image(file_, nullptr, 0);
  if (size <= 0) throw std::runtime_error("HDF5 has no file");
  std::string all(static_cast<std::size_t>(size), '\0');
  if (H5Fget_file_image(file_, all.data(), all.size()) != size)
    throw std::runtime_error("HDF5 cannot copy a file");
  return all;
}

}  // namespace plumb
