#pragma once
#include <fmt/format.h>

#include <boost/algorithm/string.hpp>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "lib/core/error.hpp"

namespace plumb {

/// A tag with its attributes and the text behind it, to the next tag.
struct Tag {
  std::string name;  ///< "/Piece" for an end
  std::map<std::string, std::string> attributes;
  std::string_view text;
  bool empty = false;  ///< <.. />

  std::string attribute(const std::string& key, const std::string& otherwise = "") const {
    const auto found = attributes.find(key);
    return found == attributes.end() ? otherwise : found->second;
  }
};

/// The file in parts: its tags up to the appended data, and those.
class VtkText {
 public:
  VtkText(std::string_view bytes, std::string file_name) : rest_(bytes), file_(std::move(file_name)) {
    const std::size_t at = bytes.find("<AppendedData");
    if (at == std::string_view::npos) return;
    rest_ = bytes.substr(0, at);
    const std::size_t close = bytes.find('>', at), mark = bytes.find('_', close);
    if (close == std::string_view::npos || mark == std::string_view::npos)
      fail("the appended data have no beginning");
    raw_ = bytes.substr(at, close - at).find("raw") != std::string_view::npos;
    appended_ = bytes.substr(mark + 1);
    if (!raw_) appended_ = appended_.substr(0, appended_.find('<'));
  }

  bool next(Tag& tag) {
    const std::size_t open = rest_.find('<');
    if (open == std::string_view::npos) return false;
    const std::size_t close = rest_.find('>', open);
    if (close == std::string_view::npos) fail("a tag has no end");
    std::string_view inside = rest_.substr(open + 1, close - open - 1);
    tag = {};
    tag.empty = inside.ends_with('/');
    if (tag.empty) inside.remove_suffix(1);
    const std::size_t blank = inside.find_first_of(" \t\r\n");
    tag.name = std::string(inside.substr(0, blank));
    if (blank != std::string_view::npos) read_attributes(inside.substr(blank), tag);
    rest_.remove_prefix(close + 1);
    tag.text = rest_.substr(0, rest_.find('<'));
    return true;
  }

  bool raw() const { return raw_; }
  std::string_view appended() const { return appended_; }
  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError(fmt::format("{}: {}", file_, problem), "it must be a .vtp or .vtu file of VTK", "");
  }

 private:
  void read_attributes(std::string_view inside, Tag& tag) const {
    while (true) {
      const std::size_t equals = inside.find('=');
      if (equals == std::string_view::npos) return;
      const std::size_t open = inside.find_first_of("\"'", equals);
      const std::size_t close = open == std::string_view::npos ? open : inside.find(inside[open], open + 1);
      if (close == std::string_view::npos) return;
      std::string key(inside.substr(0, equals)), value(inside.substr(open + 1, close - open - 1));
      boost::trim(key);
      for (const auto& [code, sign] :
           {std::pair("&lt;", "<"), {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}})
        boost::replace_all(value, code, sign);
      tag.attributes[key] = value;
      inside.remove_prefix(close + 1);
    }
  }

  std::string_view rest_, appended_;
  bool raw_ = false;
  std::string file_;
};

}  // namespace plumb
