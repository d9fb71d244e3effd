#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace plumb {

/// Names a text by 122 bits: the same text has the same name, another text has another.
std::string name_of_content(std::string_view text);

/// Keeps results in the files of a folder, each under the text that decides it. A file is sealed (sealed.hpp) and replaced
/// as a whole: what is cut off, damaged or belongs to another text is as if it were not there. Files may be removed at any
/// time. Safe to use from several threads and programs.
class ResultStore {
 public:
  /// Keeps nothing.
  ResultStore() = default;
  /// The folder is made when there is something to keep.
  explicit ResultStore(std::filesystem::path folder) : folder_(std::move(folder)) {}

  bool keeps() const { return !folder_.empty(); }
  /// Where the result of this text is kept.
  std::filesystem::path file_of(std::string_view text) const;
  /// Returns what was kept under this text; nullopt if nothing is.
  std::optional<std::string> find(std::string_view text) const;
  /// Keeps the bytes under this text. `folder` says what the folder is, for the message of an InputError if it cannot be
  /// made; OutputError if the file cannot be written.
  void keep(std::string_view text, std::string_view bytes, const std::string& folder) const;
  /// Removes what was kept under this text, and the folder if it is then empty.
  void remove(std::string_view text) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace plumb
