#include "lib/output/result_store.hpp"

#include <fmt/format.h>

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>
#include <fstream>
#include <sstream>

#include "lib/core/error.hpp"
#include "lib/output/file.hpp"
#include "lib/output/sealed.hpp"

namespace plumb {
namespace {

/// The text stands before the result: two texts of one name are told apart.
std::string heading_of(std::string_view text) {
  return fmt::format("{}\n{}", text.size(), text);
}

}  // namespace

std::string name_of_content(std::string_view text) {
  const boost::uuids::name_generator_sha1 name(boost::uuids::ns::oid());
  return to_string(name(text.data(), text.size()));
}

std::filesystem::path ResultStore::file_of(std::string_view text) const {
  return folder_ / (name_of_content(text) + ".kept");
}

std::optional<std::string> ResultStore::find(std::string_view text) const {
  if (!keeps()) return std::nullopt;
  std::ifstream in(file_of(text), std::ios::binary);
  if (!in) return std::nullopt;
  std::ostringstream content;
  content << in.rdbuf();
  try {
    const std::string_view whole = unsealed(content.view());
    const std::string heading = heading_of(text);
    if (!whole.starts_with(heading)) return std::nullopt;
    return std::string(whole.substr(heading.size()));
  } catch (const InputError&) {  // cut off or damaged: as if it were not there
    return std::nullopt;
  }
}

void ResultStore::keep(std::string_view text, std::string_view bytes, const std::string& folder) const {
  if (!keeps()) return;
  make_folder(folder_, folder);
  replace_file(file_of(text), sealed(heading_of(text).append(bytes)));
}

void ResultStore::remove(std::string_view text) const {
  if (!keeps()) return;
  std::error_code none;  // nothing was kept, or somebody else uses the folder: both are fine
  std::filesystem::remove(file_of(text), none);
  std::filesystem::remove(folder_, none);
}

}  // namespace plumb
