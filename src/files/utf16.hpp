#pragma once
/// Text in UTF-16, as spreadsheets and editors of Windows write it, and characters in UTF-8.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ligne {

/// Appends a character to a text in UTF-8, a container of bytes.
template <class Text>
void append_utf8(Text& text, std::uint32_t code) {
  const auto put = [&](std::uint32_t byte) { text.push_back(static_cast<typename Text::value_type>(byte)); };
  const auto put_last_bits = [&](int from) {
    for (int shift = from; shift >= 0; shift -= 6) put(0x80 | (code >> shift & 0x3f));
  };
  if (code < 0x80) {
    put(code);
  } else if (code < 0x800) {
    put(0xc0 | code >> 6);
    put_last_bits(0);
  } else if (code < 0x10000) {
    put(0xe0 | code >> 12);
    put_last_bits(6);
  } else {
    put(0xf0 | (code >> 18 & 7));
    put_last_bits(12);
  }
}

/// The bytes of a text in UTF-16 with a byte order mark, converted to UTF-8 without one. All other bytes stay as they are,
/// and so do texts with zero characters or halves of surrogate pairs: they are other data that begins alike.
std::vector<std::byte> as_utf8(std::vector<std::byte> bytes);

}  // namespace ligne
