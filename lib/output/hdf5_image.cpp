#include "plumbline/output/hdf5_image.hpp"

#include <fmt/format.h>
#include <hdf5.h>
#include <hdf5_hl.h>

#include <array>
#include <cstring>
#include <stdexcept>
#include <type_traits>

#include "plumbline/core/error.hpp"

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

/// The superblock (HDF5 file format, version 0) that this program writes: addresses of 8 bytes from 0, the
/// end of the file where it is, no free space and no driver's block. HDF5 1.10 believes an address beyond the
/// end, and takes memory and seconds for what is not there.
bool has_our_superblock(std::string_view bytes) {
  constexpr std::string_view signature = "\x89HDF\r\n\x1a\n";
  constexpr std::size_t addresses = 24, length = 96;
  constexpr std::uint64_t none = ~std::uint64_t{0};
  if (bytes.size() < length || !bytes.starts_with(signature)) return false;
  if (bytes.substr(8, 8) != std::string_view("\0\0\0\0\0\x08\x08\0", 8)) return false;
  std::array<std::uint64_t, 4> address{};  // base, free space, end, driver
  std::memcpy(address.data(), bytes.data() + addresses, sizeof address);
  return address == std::array<std::uint64_t, 4>{0, none, bytes.size(), none};
}

}  // namespace

Hdf5Image::Hdf5Image() {
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  constexpr std::size_t growth = std::size_t{1} << 16U;
  H5Pset_fapl_core(access, growth, false);
  file_ = H5Fcreate("checkpoint", H5F_ACC_TRUNC, H5P_DEFAULT, access);
  H5Pclose(access);
  if (file_ < 0) throw std::runtime_error("HDF5 cannot make a file in memory");
}

Hdf5Image::Hdf5Image(std::string_view bytes) : most_(bytes.size()) {
  const Quiet quiet;
  if (!has_our_superblock(bytes))
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
