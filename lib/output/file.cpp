#include "lib/output/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "lib/core/error.hpp"
#include "lib/output/pieces.hpp"

namespace plumb {
namespace {

namespace fs = std::filesystem;

using Make = std::function<void(const WritePiece& write)>;

/// Flushes an open file to the disk; the error number, 0 for none. A pipe or a device cannot be: no failure.
int flushed(int file) {
  return ::fsync(file) == 0 || errno == EINVAL || errno == EROFS ? 0 : errno;
}

/// Writes a piece to an open file; the error number, 0 for none.
int write_piece(int file, std::string_view piece) {
  while (!piece.empty()) {
    const ssize_t written = ::write(file, piece.data(), piece.size());
    if (written >= 0)
      piece.remove_prefix(static_cast<std::size_t>(written));
    else if (errno != EINTR)
      return errno;
  }
  return 0;
}

/// All pieces to the new or truncated file; the error number, 0 for none.
int write_all(const fs::path& path, const Make& make, Flush flush) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) return errno;
  int error = 0;
  make([&](std::string_view piece) {
    if (error == 0) error = write_piece(file, piece);
  });
  if (error == 0 && flush == Flush::now) error = flushed(file);
  if (::close(file) != 0 && error == 0) error = errno;
  return error;
}

bool is_special(const fs::path& path) {
  std::error_code ignored;
  const auto status = fs::status(path, ignored);
  return fs::exists(status) && !fs::is_regular_file(status);
}

}  // namespace

void throw_write_error(const fs::path& path, int error) {
  throw OutputError(fmt::format("cannot write {} ({})", path.string(), std::strerror(error)));
}

void require_writable(const fs::path& path, std::string_view option) {
  const auto refuse = [&](std::string why, std::string suggestion) {
    throw InputError(fmt::format("{}: cannot write \"{}\"", option, path.string()), std::move(why),
                     std::move(suggestion));
  };
  if (path.empty()) refuse("the file name is empty", "");
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) refuse("it is a folder", "give a file name");
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, ignored))
    refuse(fmt::format("there is no folder \"{}\"", folder.string()), "make it first");
  if (::access(fs::exists(path, ignored) ? path.c_str() : folder.c_str(), W_OK) != 0)
    refuse(std::strerror(errno), "choose another place");
}

void require_folder(const fs::path& path, std::string_view option) {
  std::error_code ignored;
  fs::path existing = fs::absolute(path, ignored);
  while (!fs::exists(existing, ignored) && existing.has_relative_path()) existing = existing.parent_path();
  const auto refuse = [&](std::string why) {
    throw InputError(fmt::format("{}: cannot write into \"{}\"", option, path.string()), std::move(why),
                     "choose another place");
  };
  if (!fs::is_directory(existing, ignored)) refuse(fmt::format("\"{}\" is not a folder", existing.string()));
  if (::access(existing.c_str(), W_OK) != 0) refuse(std::strerror(errno));
}

void make_folder(const fs::path& path, std::string_view option) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error)
    throw InputError(fmt::format("{}: cannot make the folder \"{}\"", option, path.string()), error.message(),
                     "choose another place");
}

void replace_file(const fs::path& path, std::string_view content, Flush flush) {
  replace_file_in_pieces(
      path, [content](const WritePiece& write) { write(content); }, flush);
}

void replace_file_in_pieces(const fs::path& path, const Make& make, Flush flush) {
  if (is_special(path)) {
    if (const int error = write_all(path, make, flush)) throw_write_error(path, error);
    return;
  }
  std::error_code ignored;
  const fs::path target = fs::is_symlink(path, ignored) ? fs::weakly_canonical(path, ignored) : path;
  fs::path temporary = target;
  temporary += fmt::format(".{}.tmp", ::gettid());  // threads may write the same file, as of a cache
  int error = write_all(temporary, make, flush);
  if (error == 0 && ::rename(temporary.c_str(), target.c_str()) != 0) error = errno;
  if (error == 0) return;
  ::unlink(temporary.c_str());
  throw_write_error(path, error);
}

void flush_file(const fs::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  int error = file < 0 ? errno : flushed(file);
  if (file >= 0 && ::close(file) != 0 && error == 0) error = errno;
  if (error != 0) throw_write_error(path, error);
}

void remove_unfinished_files(const fs::path& folder, const std::function<bool(const std::string&)>& is_ours) {
  std::error_code none;  // a folder that is not there has no such files
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    const fs::path number = entry.path().stem();  // NAME.PID of NAME.PID.tmp
    const std::string digits = number.extension().string();
    const bool of_a_process = entry.path().extension() == ".tmp" && digits.size() > 1 &&
                              digits.find_first_not_of("0123456789", 1) == std::string::npos;
    if (of_a_process && is_ours(number.stem().string())) fs::remove(entry.path(), none);
  }
}

}  // namespace plumb
