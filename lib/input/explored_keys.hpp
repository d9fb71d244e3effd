#pragma once
#include <functional>

#include "lib/input/document.hpp"
#include "lib/input/key_notes.hpp"

namespace plumb {

/// Reads a document with notes, as the readers of scenes do; may throw InputError.
using NotingReader = std::function<void(const TomlValue& document, KeyNotes& notes)>;

/// Finds every key that a reader can ask for, by letting it read. It begins with documents that the reader
/// takes; each key that is asked for is put into them with every word that its getter takes, or with small
/// numbers and formulas, and documents with which the reader asked for more are changed further. What a key
/// is, its unit, default and bounds are those of the getter that was called. Documents that are refused count,
/// too: their keys were asked for.
KeyNotes explored_keys(const std::vector<TomlValue>& first, const NotingReader& read);

}  // namespace plumb
