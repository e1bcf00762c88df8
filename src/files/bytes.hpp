#pragma once
/// Our binary files: numbers in little-endian order, lists preceded by their length.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "files/input_error.hpp"

namespace ligne {

static_assert(std::endian::native == std::endian::little, "lists are written as they lie in memory");

class ByteWriter {
 public:
  template <class T>
  void number(T value) {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
    append(&value, sizeof value);
  }
  void text(std::string_view text) {
    number(static_cast<std::uint64_t>(text.size()));
    append(text.data(), text.size());
  }
  /// Writes numbers, or structures of numbers without padding.
  template <class T>
  void list(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T>);
    number(static_cast<std::uint64_t>(values.size()));
    append(values.data(), values.size_bytes());
  }

  const std::string& bytes() const { return bytes_; }
  std::string take() { return std::move(bytes_); }

 private:
  void append(const void* data, std::size_t size) { bytes_.append(static_cast<const char*>(data), size); }

  std::string bytes_;
};

/// Reads the output of a ByteWriter. Rejects lengths that exceed the remaining bytes. Every function throws InputError.
class ByteReader {
 public:
  /// `name` is used in error messages.
  ByteReader(std::span<const std::byte> bytes, std::string name) : bytes_(bytes), name_(std::move(name)) {}

  template <class T>
  T number() {
    T value;
    std::memcpy(&value, take(sizeof value), sizeof value);
    return value;
  }
  std::string text() {
    const std::size_t size = length(1);
    return {reinterpret_cast<const char*>(take(size)), size};
  }
  template <class T>
  std::vector<T> list() {
    const std::size_t count = length(sizeof(T));
    std::vector<T> values(count);
    const std::byte* const data = take(count * sizeof(T));
    if (count > 0) std::memcpy(values.data(), data, count * sizeof(T));
    return values;
  }

  /// Throws InputError with the cause unless `holds` is true.
  void need(bool holds, const char* cause) const {
    if (!holds) throw InputError(name_, "byte " + std::to_string(place_) + ": " + cause);
  }
  std::size_t left() const { return bytes_.size() - place_; }
  std::span<const std::byte> rest() const { return bytes_.subspan(place_); }

 private:
  std::size_t length(std::size_t item_size) {
    const auto count = number<std::uint64_t>();
    need(count <= left() / item_size, "a list is longer than the file");
    return static_cast<std::size_t>(count);
  }
  const std::byte* take(std::size_t size) {
    need(size <= left(), "the file ends early");
    const std::byte* const data = bytes_.data() + place_;
    place_ += size;
    return data;
  }

  std::span<const std::byte> bytes_;
  std::size_t place_ = 0;
  std::string name_;
};

}  // namespace ligne
