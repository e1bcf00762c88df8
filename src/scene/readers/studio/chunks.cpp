#include "scene/readers/studio/chunks.hpp"

#include <cmath>

namespace ligne {

double ChunkReader::take_float() {
  const double value = take<float>();
  if (!std::isfinite(value)) throw error("a number is not finite");
  return value;
}

Point3 ChunkReader::take_point() {
  Point3 p;
  for (int k = 0; k < 3; ++k) p[k] = take_float();
  return p;
}

std::string ChunkReader::take_text() {
  std::string text;
  for (;;) {
    const auto c = take<std::uint8_t>();
    if (c == 0) return text;
    if (c < 0x80) {
      text += c < ' ' ? '?' : static_cast<char>(c);
    } else {
      text += static_cast<char>(0xC0 | (c >> 6));
      text += static_cast<char>(0x80 | (c & 0x3F));
    }
  }
}

void ChunkReader::skip(std::size_t bytes) {
  if (end_ - at_ < bytes) throw error("the chunk ends too early");
  at_ += bytes;
}

}  // namespace ligne
