#pragma once
#include <string>
#include <utility>
#include <vector>

#include "reports/page/page.hpp"

/// Pieces of the page. Every text that comes in is escaped. "THEORY (5.3)" in a text
/// becomes a link.
namespace plumb::reports::page {

/// Its rows link to their picture and their command, as far as `section` has them.
std::string table(const DataTable& table, const PageSection& section);
std::string figure(const Figure& figure, const PageSection& section);
/// The checks with what was expected and found, each with a link to its command.
std::string checks(const PageSection& section);
std::string section(const PageSection& section);
std::string first_screen(const Page& page);
/// Command and JSON of one or two runs; the numbered commands of more.
std::string source_links(const std::vector<std::string>& jobs);
/// Text for people as HTML.
std::string text(const std::string& plain);
/// "12 pass", "1 fail" as coloured tags.
std::string tags(const std::vector<std::pair<std::string, std::size_t>>& counts);
/// Coloured tag with the name of a verdict.
std::string verdict(const std::string& name, const std::string& text);

}  // namespace plumb::reports::page
