#include "files/utf16.hpp"

#include <cstdint>

namespace ligne {
namespace {

constexpr std::uint32_t kMark = 0xfeff, kMarkOfOtherOrder = 0xfffe;
/// First codes of the two halves of surrogate pairs, the code after these, and the first character that needs a pair.
constexpr std::uint32_t kHighHalf = 0xd800, kLowHalf = 0xdc00, kEndOfHalves = 0xe000, kFirstOfPairs = 0x10000;

void append_utf8(std::vector<std::byte>& text, std::uint32_t code) {
  const auto put = [&](std::uint32_t byte) { text.push_back(static_cast<std::byte>(byte)); };
  const auto put_last_bits = [&](int from) {
    for (int shift = from; shift >= 0; shift -= 6) put(0x80 | (code >> shift & 0x3f));
  };
  if (code < 0x80) {
    put(code);
  } else if (code < 0x800) {
    put(0xc0 | code >> 6);
    put_last_bits(0);
  } else if (code < kFirstOfPairs) {
    put(0xe0 | code >> 12);
    put_last_bits(6);
  } else {
    put(0xf0 | code >> 18);
    put_last_bits(12);
  }
}

}  // namespace

std::vector<std::byte> as_utf8(std::vector<std::byte> bytes) {
  if (bytes.size() < 2 || bytes.size() % 2 != 0) return bytes;
  const auto unit_at = [&](std::size_t i, bool swapped) {
    const auto first = std::to_integer<std::uint32_t>(bytes[i]), second = std::to_integer<std::uint32_t>(bytes[i + 1]);
    return swapped ? first << 8 | second : second << 8 | first;
  };
  const std::uint32_t mark = unit_at(0, false);
  if (mark != kMark && mark != kMarkOfOtherOrder) return bytes;
  const bool swapped = mark == kMarkOfOtherOrder;
  std::vector<std::byte> text;
  text.reserve(bytes.size() / 2);
  for (std::size_t i = 2; i < bytes.size(); i += 2) {
    std::uint32_t code = unit_at(i, swapped);
    if (code == 0 || (code >= kLowHalf && code < kEndOfHalves)) return bytes;
    if (code >= kHighHalf && code < kLowHalf) {
      i += 2;
      const std::uint32_t low = i < bytes.size() ? unit_at(i, swapped) : 0;
      if (low < kLowHalf || low >= kEndOfHalves) return bytes;
      code = kFirstOfPairs + ((code - kHighHalf) << 10) + (low - kLowHalf);
    }
    append_utf8(text, code);
  }
  return text;
}

}  // namespace ligne
