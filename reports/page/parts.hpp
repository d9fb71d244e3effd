#pragma once
#include <string>
#include <vector>

#include "reports/page/page.hpp"

/// Pieces of the page. Every text that comes in is escaped.
namespace plumb::reports::page {

std::string table(const DataTable& table);
std::string figure(const Figure& figure);
std::string checks(const std::string& section_id, const std::vector<Check>& checks);
std::string section(const PageSection& section);
std::string first_screen(const Page& page);
/// Coloured tag with the name of a verdict.
std::string verdict(const std::string& name, const std::string& text);

}  // namespace plumb::reports::page
