#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace plumb {

/// A table in time, written as it grows: a CSV file with a heading line ("time [s],energy [J]") and one line
/// a call. Every line reaches the operating system as a whole before append() returns, so that a killed run
/// loses none; when the disk is full the last part line is taken back and OutputError is thrown.
class CsvSeries {
 public:
  /// Starts the file anew.
  CsvSeries(const std::filesystem::path& file, const std::vector<std::string>& columns);
  /// Continues a file that another run left: cuts it to its first `bytes` bytes. Throws InputError if it is
  /// shorter or has other columns.
  CsvSeries(const std::filesystem::path& file, const std::vector<std::string>& columns, std::int64_t bytes);
  ~CsvSeries();
  CsvSeries(const CsvSeries&) = delete;
  CsvSeries& operator=(const CsvSeries&) = delete;

  /// Adds one line with 17 significant digits. std::invalid_argument if the number of values is not that of
  /// columns.
  void append(std::span<const double> values);
  /// Flushes what there is to the disk; the number of bytes.
  std::int64_t flush();

 private:
  void add_line(const std::string& line);

  std::filesystem::path file_name_;
  std::size_t columns_;
  int file_ = -1;
};

}  // namespace plumb
