#include "lib/output/series.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "lib/core/error.hpp"
#include "lib/output/file.hpp"
#include "lib/output/table.hpp"

namespace plumb {
namespace {

std::string heading_of(const std::vector<std::string>& columns) {
  std::string heading;
  for (const auto& column : columns) heading += (heading.empty() ? "" : ",") + csv_cell(column);
  return heading + "\n";
}

}  // namespace

CsvSeries::CsvSeries(const std::filesystem::path& file, const std::vector<std::string>& columns)
    : file_name_(file),
      columns_(columns.size()),
      file_(::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0666)) {
  if (file_ < 0) throw_write_error(file_name_, errno);
  try {
    add_line(heading_of(columns));
  } catch (...) {
    ::close(file_);
    throw;
  }
}

CsvSeries::CsvSeries(const std::filesystem::path& file, const std::vector<std::string>& columns,
                     std::int64_t bytes)
    : file_name_(file), columns_(columns.size()) {
  const auto refuse = [&file](const std::string& why) {
    throw InputError(fmt::format("{} cannot be continued", file.string()), why,
                     "start the run anew, without --resume");
  };
  const std::string heading = heading_of(columns);
  std::error_code none;
  const auto size = std::filesystem::file_size(file, none);
  if (none) refuse(none.message());
  if (bytes < static_cast<std::int64_t>(heading.size()) || size < static_cast<std::uintmax_t>(bytes))
    refuse(fmt::format("it has {} bytes, the checkpoint says {}", size, bytes));
  std::string first(heading.size(), '\0');
  std::ifstream(file, std::ios::binary).read(first.data(), static_cast<std::streamsize>(first.size()));
  if (first != heading) refuse("it has other columns");
  file_ = ::open(file.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (file_ < 0) throw_write_error(file_name_, errno);
  if (::ftruncate(file_, bytes) == 0) return;
  const int error = errno;
  ::close(file_);
  throw_write_error(file_name_, error);
}

std::int64_t CsvSeries::flush() {
  if (::fsync(file_) != 0 && errno != EINVAL && errno != EROFS) throw_write_error(file_name_, errno);
  return ::lseek(file_, 0, SEEK_END);
}

CsvSeries::~CsvSeries() {
  ::fsync(file_);
  ::close(file_);
}

void CsvSeries::append(std::span<const double> values) {
  if (values.size() != columns_)
    throw std::invalid_argument(fmt::format("{} values for {} columns", values.size(), columns_));
  std::string line;
  for (const double value : values) line += fmt::format("{}{:.17g}", line.empty() ? "" : ",", value);
  add_line(line + "\n");
}

void CsvSeries::add_line(const std::string& line) {
  const off_t before = ::lseek(file_, 0, SEEK_END);
  ssize_t written = 0;
  do written = ::write(file_, line.data(), line.size());
  while (written < 0 && errno == EINTR);
  if (written == static_cast<ssize_t>(line.size())) return;
  const int error = written < 0 ? errno : ENOSPC;
  const bool whole = written <= 0 || (before >= 0 && ::ftruncate(file_, before) == 0);
  if (!whole)
    throw OutputError(
        fmt::format("{}: the last line is incomplete ({})", file_name_.string(), std::strerror(error)));
  throw_write_error(file_name_, error);
}

}  // namespace plumb
