#pragma once
/// The chunks of a binary 3D Studio file: each has a number of two bytes, its length with this header, and its contents,
/// which may end in further chunks. Numbers are little-endian.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "scene/model/diagnostics.hpp"
#include "scene/model/scene.hpp"
#include "scene/readers/load_bytes.hpp"

namespace ligne {

/// Reads the contents of a chunk from front to back. Errors name the byte of the file.
class ChunkReader {
 public:
  /// The whole file.
  ChunkReader(std::span<const std::byte> file, const std::string& name) : file_(file), end_(file.size()), name_(name) {}

  bool empty() const { return at_ == end_; }
  InputError error(const std::string& cause) const {
    return InputError(name_, "byte " + std::to_string(at_) + ": " + cause);
  }

  template <typename T>
  T take() {
    if (end_ - at_ < sizeof(T)) throw error("the chunk ends within a number");
    const T value = load_bytes<T>(file_.data() + at_, std::endian::little);
    at_ += sizeof(T);
    return value;
  }
  /// A finite number of four bytes.
  double take_float();
  Point3 take_point();
  /// Text up to a zero byte, from the code page of Western Europe to UTF-8.
  std::string take_text();
  void skip(std::size_t bytes);

  /// Calls visit(number, reader of the contents) for each chunk that is left.
  template <typename Visit>
  void for_chunks(Visit visit) {
    // Some writers fill the end of a chunk with bytes that are no chunk.
    while (end_ - at_ >= kHeader) {
      ChunkReader chunk = *this;
      const auto number = chunk.take<std::uint16_t>();
      const auto length = chunk.take<std::uint32_t>();
      if (length < kHeader || length > end_ - at_)
        throw error("a chunk of " + std::to_string(length) + " bytes does not fit");
      at_ += length;
      chunk.end_ = at_;
      visit(number, chunk);
    }
  }

 private:
  static constexpr std::size_t kHeader = 6;

  std::span<const std::byte> file_;
  std::size_t at_ = 0, end_;
  const std::string& name_;
};

}  // namespace ligne
