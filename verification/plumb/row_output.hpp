#pragma once
#include <cstddef>
#include <functional>
#include <nlohmann/json_fwd.hpp>

namespace plumb::app {
struct Session;

/// The rows of a result, each made where it is written: millions of them need no memory.
struct Rows {
  std::size_t count;
  std::function<nlohmann::ordered_json(std::size_t k)> row;  ///< a flat object; the same keys in all
};

/// Shows the rows as a table, and writes them to --csv and, as "rows" of `result`, to --json: the same text
/// as Session::write_table and Session::write_json.
void write_rows(const Session& session, nlohmann::ordered_json result, const Rows& rows);

/// The two halves of write_rows: for people, and to --csv and --json.
void show_rows(const Session& session, const Rows& rows);
void write_files(const Session& session, nlohmann::ordered_json result, const Rows& rows);

}  // namespace plumb::app
