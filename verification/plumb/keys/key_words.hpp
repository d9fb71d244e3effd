#pragma once
#include <string>
#include <vector>

#include "lib/input/key_notes.hpp"

namespace plumb::app {

/// Lists the keys right below a section that some getter reads; "" is the whole file.
std::vector<const KeyNote*> keys_in(const KeyNotes& notes, const std::string& section);

/// Returns "kind" of "boundary.0.kind".
std::string last_part(const std::string& path);

/// Returns the unit of a bare number; empty where there is none, or where it depends.
std::string unit_of(const KeyNote& key);

/// Says the default behind `before`: "default 0.9", "default 0.9 or 1.2"; empty where there is none.
std::string default_in_words(const KeyNote& key, const std::string& before);

/// Says what a value may be: "a length in m, positive", "one of box, ball".
std::string value_in_words(const KeyNote& key);

/// Writes the page of all keys, in Markdown: a table for each section.
std::string keys_page(const KeyNotes& notes, const std::string& title);

}  // namespace plumb::app
