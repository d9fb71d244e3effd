#include "lib/core/sentences.hpp"

namespace plumb {
namespace {

bool is_small(char c) {
  return c >= 'a' && c <= 'z';
}

/// Whether the text begins with a word that a sentence may begin with: no name, formula or number.
bool begins_with_a_word(std::string_view text) {
  std::size_t end = 0;
  while (end < text.size() && is_small(text[end])) ++end;
  const std::string_view rest = text.substr(end);
  return end > 0 &&
         (rest.empty() || std::string_view(" ,:;'-").find(rest.front()) != std::string_view::npos) &&
         !rest.starts_with(" = ");
}

void append_sentence(std::string& message, std::string_view text) {
  if (text.empty()) return;
  std::string sentence(text);
  if (!message.empty()) {
    message += ' ';
    if (begins_with_a_word(text)) sentence[0] = static_cast<char>(sentence[0] - 'a' + 'A');
  }
  message += sentence;
  if (std::string_view(".?!").find(message.back()) == std::string_view::npos) message += '.';
}

}  // namespace

std::string sentences(std::string_view problem, std::string_view why, std::string_view suggestion) {
  std::string message;
  for (const auto part : {problem, why, suggestion}) append_sentence(message, part);
  return message;
}

}  // namespace plumb
