#include "files/utf16.hpp"

namespace ligne {
namespace {

constexpr std::uint32_t kMark = 0xfeff, kMarkOfOtherOrder = 0xfffe;
/// First codes of the two halves of surrogate pairs, the code after these, and the first character that needs a pair.
constexpr std::uint32_t kHighHalf = 0xd800, kLowHalf = 0xdc00, kEndOfHalves = 0xe000, kFirstOfPairs = 0x10000;

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
