#include "files/message_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>

#include <cstdint>

namespace ligne {
namespace {

constexpr std::string_view kCut = "...", kMiddleCut = " ... ";

/// Whether a character beyond ASCII is visible and affects no other. Excludes the second row of controls, line and
/// paragraph separators, marks of text direction, and characters of no width.
bool shows(std::uint32_t code) {
  const auto within = [code](std::uint32_t low, std::uint32_t high) { return code >= low && code <= high; };
  return !within(0x80, 0x9f) && !within(0x200b, 0x200f) && !within(0x2028, 0x202e) && !within(0x2060, 0x206f) &&
         code != 0xfeff;
}

/// Number of bytes of the first character if it can stand in a line unescaped, else 0. `text` is not empty.
std::size_t plain_character(std::string_view text) {
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
  const std::size_t length = first >= 0xc2 && first < 0xe0 ? 2 : first >= 0xe0 && first < 0xf0 ? 3 : first < 0xf5 ? 4 : 0;
  if (first < 0xc2 || length == 0 || length > text.size()) return 0;
  std::uint32_t code = first & (0xffu >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
    code = code << 6 | (byte(i) & 0x3fu);
  }
  // Overlong encoding, half of a UTF-16 pair, or beyond Unicode.
  if ((length == 3 && code < 0x800) || (length == 4 && (code < 0x10000 || code > 0x10ffff))) return 0;
  if (code >= 0xd800 && code <= 0xdfff) return 0;
  return shows(code) ? length : 0;
}

std::string escaped(char c) {
  if (c == '\n') return "\\n";
  if (c == '\r') return "\\r";
  if (c == '\t') return "\\t";
  constexpr std::string_view kDigits = "0123456789abcdef";
  const auto byte = static_cast<unsigned char>(c);
  return {'\\', 'x', kDigits[byte >> 4], kDigits[byte & 15u]};
}

/// Calls put(piece) for each character in turn until it returns false.
template <class Put>
void for_each_character(std::string_view text, const Put& put) {
  while (!text.empty()) {
    const std::size_t length = plain_character(text);
    if (!put(length > 0 ? std::string(text.substr(0, length)) : escaped(text[0]))) return;
    text.remove_prefix(length > 0 ? length : 1);
  }
}

/// The whole characters at the end of a printable text that fit into `most` bytes.
std::string_view end_of(std::string_view text, std::size_t most) {
  std::string_view end = text.substr(text.size() - most);
  while (!end.empty() && (static_cast<unsigned char>(end.front()) & 0xc0) == 0x80) end.remove_prefix(1);
  return end;
}

/// The singular of a plural noun; any other word unchanged.
std::string singular(const std::string& word) {
  const auto without = [&](std::size_t letters) { return word.substr(0, word.size() - letters); };
  if (word.starts_with('@') || word.ends_with("us") || word.ends_with("ss") || !word.ends_with('s')) return word;
  if (word.ends_with("ies")) return without(3) + "y";
  if (word.ends_with("vertices")) return without(4) + "ex";
  return without(word.ends_with("shes") ? 2 : 1);
}

}  // namespace

std::string printable(std::string_view text, std::size_t longest) {
  std::string out;
  for_each_character(text, [&](const std::string& piece) {
    const bool fits = out.size() + piece.size() <= longest;
    out += fits ? std::string_view(piece) : kCut;
    return fits;
  });
  return out;
}

std::string shown(std::string_view text, char quote) {
  return std::string(1, quote).append(printable(text)).append(1, quote);
}

std::string message_line(std::string_view text, std::size_t longest) {
  const std::size_t last = text.find_last_not_of(" \t\r\n");
  text = text.substr(0, last == std::string_view::npos ? 0 : last + 1);
  std::string line;
  for_each_character(text, [&](const std::string& piece) {
    line += piece;
    return true;
  });
  if (line.size() <= longest) return line;
  const std::size_t kept = longest - kMiddleCut.size(), behind = kept / 2;
  const std::string front = printable(line, kept - behind);
  return front.substr(0, front.size() - kCut.size()).append(kMiddleCut).append(end_of(line, behind));
}

std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return result;
}

std::string shortest(double value) {
  std::array<char, 64> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), end};
}

std::string rounded(double value, int digits) {
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.*g", digits, value);
  return buffer.data();
}

std::string counted(std::size_t n, std::string_view plural) {
  if (n != 1) return std::to_string(n) + " " + std::string(plural);
  constexpr int kMostWords = 3;
  std::string text = "1";
  for (int words = 1; !plural.empty(); ++words) {
    const std::size_t end = std::min(plural.find(' '), plural.size());
    const std::string word(plural.substr(0, end)), noun = singular(word);
    text += " " + noun;
    plural.remove_prefix(std::min(end + 1, plural.size()));
    if (noun != word || word == "of" || words == kMostWords) break;
  }
  if (!plural.empty()) text.append(" ").append(plural);
  constexpr std::string_view kThatAre = " that are ", kThatIs = " that is ";
  const std::size_t clause = text.find(kThatAre);
  if (clause != std::string::npos) text.replace(clause, kThatAre.size(), kThatIs);
  return text;
}

std::string duration(double seconds) {
  std::array<char, 64> buffer{};
  if (seconds < 1) {
    std::snprintf(buffer.data(), buffer.size(), "%.2f ms", seconds * 1000);
  } else {
    std::snprintf(buffer.data(), buffer.size(), "%.2f s", seconds);
  }
  return buffer.data();
}

}  // namespace ligne
