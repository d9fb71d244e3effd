#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <ostream>

#include "verification/plumb/commands.hpp"
#include "verification/plumb/keys/key_words.hpp"
#include "verification/plumb/keys/kind_option.hpp"
#include "verification/plumb/keys/known_files.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {
namespace {

/// A row for each key: "boundary.0.kind", where 0 stands for every one of a list.
nlohmann::ordered_json rows_of(const KeyNotes& notes) {
  auto rows = nlohmann::ordered_json::array();
  for (const KeyNote& key : notes.keys())
    if (!key.forms.empty())
      rows.push_back({{"key", key.path},
                      {"value", value_in_words(key)},
                      {"unit", unit_of(key)},
                      {"required", notes.required(key)},
                      {"default", default_in_words(key, "")},
                      {"meaning", key.meaning}});
  return rows;
}

}  // namespace

/// `plumb keys scene|study|stability-study|path`: the page of all keys that such a file may have.
void add_keys(CLI::App& program, Session& session) {
  const auto kind = std::make_shared<std::string>("scene");
  CLI::App& command = add_command(
      program, session,
      {"keys", "every key of a kind of file: values, unit, default and meaning, as the program reads it",
       "plumb keys study"},
      {.table = true}, [&session, kind] {
        const KeyNotes notes = keys_of_file(*kind);
        session.text() << keys_page(notes, "Keys of a " + *kind) << std::flush;
        session.write_csv(rows_of(notes));
        session.write_json({{"kind", *kind}, {"keys", rows_of(notes)}});
        return 0;
      });
  add_kind(command, kind, known_files());
}

}  // namespace plumb::app
