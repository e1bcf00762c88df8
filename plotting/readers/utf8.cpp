#include "plotting/readers/utf8.hpp"

#include <array>
#include <cstddef>

namespace ligne {
namespace {

constexpr char32_t kReplacement = 0xfffd;

struct Decoded {
  char32_t code;
  std::size_t bytes;
};

/// The character at the start of a text that is not empty.
Decoded first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const unsigned lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  if (lead < 0xc2 || lead > 0xf4) return {kReplacement, 1};
  const std::size_t count = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  char32_t code = lead & (0xffu >> (count + 1));
  for (std::size_t i = 1; i < count; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return {kReplacement, 1};
    code = code << 6 | (byte(i) & 0x3f);
  }
  constexpr std::array<char32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
  if (code < least[count] || code > 0x10ffff || (code >= 0xd800 && code < 0xe000)) return {kReplacement, 1};
  return {code, count};
}

bool control(char32_t c) { return c < 0x20 || (c >= 0x7f && c < 0xa0); }

void append(std::string& out, char32_t c) {
  const auto put = [&](char32_t byte) { out += static_cast<char>(static_cast<unsigned char>(byte)); };
  if (c < 0x80) return put(c);
  if (c < 0x800) {
    put(0xc0 | c >> 6);
  } else {
    if (c < 0x10000) {
      put(0xe0 | c >> 12);
    } else {
      put(0xf0 | c >> 18);
      put(0x80 | (c >> 12 & 0x3f));
    }
    put(0x80 | (c >> 6 & 0x3f));
  }
  put(0x80 | (c & 0x3f));
}

}  // namespace

std::u32string decode_utf8(std::string_view text) {
  std::u32string out;
  while (!text.empty()) {
    const Decoded c = first_character(text);
    out += control(c.code) ? U' ' : c.code;
    text.remove_prefix(c.bytes);
  }
  return out;
}

std::string clean_utf8(std::string_view text) {
  std::string out;
  for (const char32_t c : decode_utf8(text)) append(out, c);
  return out;
}

std::string xml_text(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const auto [c, bytes] = first_character(text);
    text.remove_prefix(bytes);
    if (c == U'&') {
      out += "&amp;";
    } else if (c == U'<') {
      out += "&lt;";
    } else if (c == U'>') {
      out += "&gt;";
    } else if (c == U'"') {
      out += "&quot;";
    } else {
      const bool is_known = c >= 0x20 ? c != 0xfffe && c != 0xffff : c == U'\t' || c == U'\n' || c == U'\r';
      append(out, is_known ? c : kReplacement);
    }
  }
  return out;
}

}  // namespace ligne
