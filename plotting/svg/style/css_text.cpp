#include "plotting/svg/style/css_text.hpp"

#include <algorithm>
#include <cstdint>

#include "files/utf16.hpp"
#include "plotting/svg/values.hpp"

namespace ligne::svg {
namespace {

bool name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}

bool hexadecimal(char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }

/// The position behind the string that begins at `at`. A line end ends the string too (CSS Syntax 3, 4.3.5).
std::size_t behind_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  for (++at; at < text.size() && text[at] != quote && text[at] != '\n'; ++at) {
    if (text[at] == '\\') ++at;
  }
  return std::min(at + 1, text.size());
}

}  // namespace

std::string without_comments(std::string_view css) {
  std::string text;
  while (!css.empty()) {
    const std::size_t begin = std::min(css.find("/*"), css.size());
    text += css.substr(0, begin);
    css.remove_prefix(begin);
    const std::size_t end = css.find("*/");
    css.remove_prefix(end == std::string_view::npos ? css.size() : end + 2);
  }
  return text;
}

std::size_t find_outside(std::string_view text, std::string_view wanted) {
  std::size_t open = 0;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (open == 0 && wanted.find(c) != std::string_view::npos) return i;
    if (c == '"' || c == '\'') {
      i = behind_string(text, i);
      continue;
    }
    if (c == '\\') ++i;
    if (c == '(' || c == '[' || c == '{') ++open;
    if ((c == ')' || c == ']' || c == '}') && open > 0) --open;
    ++i;
  }
  return std::string_view::npos;
}

std::string_view take_block(std::string_view& text, char closing) {
  const std::size_t end = std::min(find_outside(text, std::string_view(&closing, 1)), text.size());
  const std::string_view inside = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return inside;
}

std::string take_css_name(std::string_view& text) {
  std::string name;
  while (!text.empty() && (name_character(text[0]) || (text[0] == '\\' && text.size() > 1 && text[1] != '\n'))) {
    if (text[0] != '\\') {
      name += text[0];
      text.remove_prefix(1);
      continue;
    }
    text.remove_prefix(1);
    constexpr std::size_t kMostDigits = 6;
    std::size_t digits = 0;
    while (digits < std::min(text.size(), kMostDigits) && hexadecimal(text[digits])) ++digits;
    if (digits == 0) {
      name += text[0];
      text.remove_prefix(1);
      continue;
    }
    append_utf8(name, static_cast<std::uint32_t>(std::stoul(std::string(text.substr(0, digits)), nullptr, 16)));
    text.remove_prefix(digits);
    if (!text.empty() && kBlanks.find(text[0]) != std::string_view::npos) text.remove_prefix(1);
  }
  return name;
}

std::vector<Declaration> declarations(std::string_view text) {
  std::vector<Declaration> list;
  while (!text.empty()) {
    const std::size_t end = std::min(find_outside(text, ";{"), text.size());
    const std::string_view entry = text.substr(0, end);
    const bool is_rule = end < text.size() && text[end] == '{';
    text.remove_prefix(std::min(end + 1, text.size()));
    if (is_rule) {
      take_block(text, '}');
      continue;
    }
    const std::size_t colon = entry.find(':');
    if (colon == std::string_view::npos) continue;
    std::string_view value = trimmed(entry.substr(colon + 1));
    const std::size_t mark = find_outside(value, "!");
    const bool important = mark != std::string_view::npos && trimmed(value.substr(mark + 1)) == "important";
    if (mark != std::string_view::npos) value = trimmed(value.substr(0, mark));
    list.push_back({std::string(trimmed(entry.substr(0, colon))), std::string(value), important});
  }
  return list;
}

bool has_rules(std::string_view text) { return find_outside(text, "{") != std::string_view::npos; }

}  // namespace ligne::svg
