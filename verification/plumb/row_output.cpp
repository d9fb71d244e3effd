#include "verification/plumb/row_output.hpp"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "lib/output/file.hpp"
#include "lib/output/json.hpp"
#include "lib/output/pieces.hpp"
#include "lib/output/table_parts.hpp"
#include "verification/plumb/result.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

/// Calls take(table, is_first) with the rows, some at a time.
template <class Take>
void in_parts(const Rows& rows, Take&& take) {
  constexpr std::size_t together = 4096;
  for (std::size_t from = 0; from == 0 || from < rows.count; from += together) {
    Json part = Json::array();
    for (std::size_t k = from; k < std::min(from + together, rows.count); ++k) part.push_back(rows.row(k));
    take(table_of(part), from == 0);
  }
}

void show(std::ostream& out, const Rows& rows) {
  std::vector<std::size_t> widths;
  in_parts(rows, [&](const Table& table, bool first) {
    const auto these = column_widths(table);
    if (first) widths = these;
    for (std::size_t k = 0; k < these.size(); ++k) widths[k] = std::max(widths[k], these[k]);
  });
  in_parts(rows, [&](const Table& table, bool first) {
    if (first) out << plain_heading(table, widths);
    out << plain_rows(table, widths);
  });
  out << std::flush;
}

void write_csv(const Rows& rows, const WritePiece& write) {
  in_parts(rows, [&](const Table& table, bool first) {
    const std::string text = csv_text(table);
    write(first ? text : text.substr(text.find('\n') + 1));
  });
}

/// The text of one row among others: json_text, indented by two.
std::string row_text(const Json& row) {
  std::string text = json_text(row);
  text.pop_back();
  std::string indented = "\n  ";
  for (const char c : text) {
    indented += c;
    if (c == '\n') indented += "  ";
  }
  return indented;
}

void write_json(const Json& whole, const Rows& rows, const WritePiece& write) {
  const std::string text = json_text(whole), empty = "\"rows\": []";
  const std::size_t at = text.rfind(empty) + empty.size() - 1;
  write(std::string_view(text).substr(0, at));
  for (std::size_t k = 0; k < rows.count; ++k) write((k ? "," : "") + row_text(rows.row(k)));
  write((rows.count ? "\n " : "") + text.substr(at));
}

void to_file(const std::string& file, const std::function<void(const WritePiece&)>& make) {
  if (file != "-") return replace_file_in_pieces(file, make);
  make([](std::string_view piece) { std::cout << piece; });
  std::cout << std::flush;
  if (!std::cout) throw OutputError("cannot write to standard output");
}

}  // namespace

void show_rows(const Session& session, const Rows& rows) {
  if (session.text().rdbuf() != nullptr) show(session.text(), rows);
}

void write_rows(const Session& session, Json result, const Rows& rows) {
  show_rows(session, rows);
  write_files(session, std::move(result), rows);
}

void write_files(const Session& session, Json result, const Rows& rows) {
  if (!session.csv.empty()) to_file(session.csv, [&](const WritePiece& write) { write_csv(rows, write); });
  if (session.json.empty()) return;
  result["rows"] = Json::array();
  const Json whole = document(result, {session.kind, session.command_line, 0});
  to_file(session.json, [&](const WritePiece& write) { write_json(whole, rows, write); });
}

}  // namespace plumb::app
