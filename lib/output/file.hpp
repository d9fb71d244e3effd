#pragma once
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace plumb {

/// A file could not be written: the disk is full, the folder vanished. Not the user's input: exit code 1.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws OutputError with the file and the text of the system's error number.
[[noreturn]] void throw_write_error(const std::filesystem::path& path, int error);

/// InputError unless a file can be made at `path`: its folder exists and can be written, and it is no folder
/// itself. Nothing is written. `option` names what gave the path, for the message ("--json").
void require_writable(const std::filesystem::path& path, std::string_view option);

/// InputError unless `path` is a folder that can be written or could be made. Nothing is made.
void require_folder(const std::filesystem::path& path, std::string_view option);

/// Makes the folder and those above it. InputError if that fails: the place was given by `option`.
void make_folder(const std::filesystem::path& path, std::string_view option);

/// When a file reaches the disk itself: at once, or when the system gets to it. A killed program loses
/// nothing either way, a machine that loses its power may lose what was left to the system.
enum class Flush { now, later };

/// Replaces the file at `path` by `content`: writes a new file beside it, flushes it to the disk and renames
/// it, so that a reader sees the old content or the new one, never a part. Devices and pipes are written
/// directly. Throws OutputError, and leaves the old file, when that fails.
void replace_file(const std::filesystem::path& path, std::string_view content, Flush flush = Flush::now);

/// Puts a file on the disk that was left to the system. Throws OutputError.
void flush_file(const std::filesystem::path& path);

/// Removes what a killed program left of replace_file() for files of that folder whose name `is_ours`.
void remove_unfinished_files(const std::filesystem::path& folder,
                             const std::function<bool(const std::string&)>& is_ours);

}  // namespace plumb
