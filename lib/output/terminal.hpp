#pragma once
#include <string>

namespace plumb {

/// Columns of the terminal behind a file descriptor (1: standard output, 2: standard error); 80 if it is not
/// a terminal or does not say.
int terminal_columns(int descriptor);

/// Words in lines of at most `columns` characters; those after the first are indented. The first line begins
/// at column `start`. A word that is longer than a line stands alone. UTF-8 characters count once.
std::string wrapped(const std::string& text, std::size_t columns, std::size_t start, std::size_t indent);

/// The first `columns` characters of one line of UTF-8 text, with ".." at the end if some are left off.
std::string shortened(const std::string& line, std::size_t columns);

}  // namespace plumb
