#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <ostream>

#include "lib/input/document.hpp"
#include "lib/output/json.hpp"
#include "verification/plumb/commands.hpp"
#include "verification/plumb/data_folder.hpp"
#include "verification/plumb/keys/key_schema.hpp"
#include "verification/plumb/keys/kind_option.hpp"
#include "verification/plumb/keys/known_files.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {
namespace {

/// That of results is written by hand: results are many things, and the tests hold them to it.
nlohmann::ordered_json schema_named(const std::string& kind) {
  if (kind == "result")
    return nlohmann::ordered_json::parse(
        read_text((data_folder() / "verification" / "schema" / "result.json").string()));
  return schema_of(keys_of_file(kind), "A " + kind + " of Plumbline");
}

std::vector<std::string> kinds() {
  std::vector<std::string> all = known_files();
  all.emplace_back("result");
  return all;
}

}  // namespace

/// `plumb schema scene|study|stability-study|path|result`: what an editor needs to complete and check a file.
void add_schema(CLI::App& program, Session& session) {
  const auto kind = std::make_shared<std::string>("scene");
  CLI::App& command =
      add_command(program, session,
                  {"schema",
                   "JSON schema of a kind of file; with \"#:schema scene.schema.json\" as the "
                   "first line of a scene, editors (Taplo, Even Better TOML) complete and "
                   "check it",
                   "plumb schema scene > scene.schema.json"},
                  {}, [&session, kind] {
                    const auto schema = schema_named(*kind);
                    session.text() << json_text(schema) << std::flush;
                    session.write_json({{"kind", *kind}, {"schema", schema}});
                    return 0;
                  });
  add_kind(command, kind, kinds());
}

}  // namespace plumb::app
