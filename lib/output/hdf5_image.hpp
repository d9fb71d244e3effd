#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace plumb {

/// An HDF5 file in memory with data sets of numbers and text in its root group. Nothing is written to disk
/// here, so a full disk is met in one place only (replace_file). Getters throw InputError that names the data
/// set.
class Hdf5Image {
 public:
  Hdf5Image();                                 ///< a new one, to be written to
  explicit Hdf5Image(std::string_view bytes);  ///< one to read. InputError if it is no HDF5 file
  ~Hdf5Image();
  Hdf5Image(const Hdf5Image&) = delete;
  Hdf5Image& operator=(const Hdf5Image&) = delete;

  void write(const char* name, const std::string& text) const;
  void write(const char* name, const std::vector<std::int64_t>& values) const;
  /// `columns` > 1: as a table with so many numbers a row.
  void write(const char* name, const std::vector<double>& values, std::size_t columns = 1) const;

  bool has(const char* name) const;
  std::string text(const char* name) const;
  /// All numbers, row after row; `count`: how many there must be, 0 for any.
  std::vector<double> numbers(const char* name, std::size_t count = 0) const;
  std::vector<std::int64_t> integers(const char* name, std::size_t count) const;

  std::string bytes() const;

 private:
  std::int64_t file_;
  std::size_t most_ = 0;  ///< no data set can have more elements: the bytes of the file that is read
};

}  // namespace plumb
