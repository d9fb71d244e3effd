#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "lib/measures/measures.hpp"
#include "lib/run/run.hpp"

namespace plumb {

/// Everything that a run needs to go on bit for bit: the same for any number of threads.
struct Checkpoint {
  std::string program;                       ///< version and build; other builds may give other bits
  std::map<std::string, std::string> scene;  ///< every setting of the scene, by its dotted key
  std::int64_t dimension = 0;
  SavedState state;
  RunRecord record;
};

/// Whether all numbers of the state are finite; one that is not cannot be read back.
bool is_finite(const Checkpoint& checkpoint);

/// The file's content: 512 bytes of text with length and CRC-64 of what follows, then an HDF5 file. HDF5
/// itself skips such a block, so h5dump and others read the file as it is.
std::string bytes_of(const Checkpoint& checkpoint);

/// Reads it back. The checksum is compared before HDF5 sees a byte. Throws InputError if the bytes are cut
/// off, changed, no checkpoint, or do not fit together; `name` is the file's, for the message.
Checkpoint checkpoint_of(std::string_view bytes, const std::string& name);

/// Replaces the file as a whole (replace_file): whatever happens, the old or the new content is there.
void write_checkpoint(const std::filesystem::path& file, const Checkpoint& checkpoint);
Checkpoint read_checkpoint(const std::filesystem::path& file);

/// Throws InputError that names the differences if the file of that name belongs to a scene with other
/// settings.
void require_same_settings(const std::string& name, const std::map<std::string, std::string>& here,
                           const std::map<std::string, std::string>& there);

/// Throws InputError that names the differences if the checkpoint is of another scene or another build.
void require_same_origin(const Checkpoint& checkpoint, const std::string& program,
                         const std::map<std::string, std::string>& scene, const std::string& name);

}  // namespace plumb
