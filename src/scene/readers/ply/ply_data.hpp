#pragma once
/// The data of a PLY file, read item by item and value by value from text or binary data.

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "scene/model/diagnostics.hpp"
#include "scene/model/precision.hpp"
#include "scene/readers/ply/ply_header.hpp"
#include "scene/readers/ply/ply_records.hpp"
#include "scene/readers/text_lines.hpp"

namespace ligne {

struct PlyValue {
  double number = 0;
  int digits = 0;  ///< significant digits as written; 0 in binary files
};

inline std::string of_element(const PlyElement& element, std::uint64_t item) {
  return printable(element.name) + " " + std::to_string(item) + " of " + std::to_string(element.count);
}

/// The data of a text file: one line per item.
class PlyTextData {
 public:
  PlyTextData(std::string_view text, std::size_t header_lines, const std::string& name, Warnings& warnings)
      : lines_(text), header_lines_(header_lines), name_(name), warnings_(warnings) {}

  void begin_item(const PlyElement& element, std::uint64_t item) {
    do {
      if (!lines_.next(line_)) throw error("the file ends before " + of_element(element, item));
    } while (!has_numbers());
  }
  PlyValue take(NumberType type) {
    const std::string_view word = take_word(line_);
    if (word.empty()) throw error("line with too few numbers");
    const std::optional<double> value = number_in(word);
    if (!value || (!is_float(type) && *value != std::trunc(*value))) {
      throw error(shown(word) + (is_float(type) ? " is not a number" : " is not a whole number"));
    }
    return {*value, significant_digits(word)};
  }
  /// Claimed lengths are not trusted: every skipped value must have a word.
  void pass_over(NumberType type, std::uint64_t n) {
    for (; n > 0; --n) take(type);
  }
  /// Skips further values, which MeshLab writes without naming them in the header.
  void end_item() {
    std::size_t n = 0;
    while (!take_word(line_).empty()) ++n;
    warnings_.leave_out("values at ends of lines", n);
  }
  void end() {
    while (lines_.next(line_)) {
      if (has_numbers()) throw error("more lines than the header declares elements");
    }
  }
  InputError error(const std::string& cause) const { return error_at_line(name_, header_lines_ + lines_.number(), cause); }
  std::span<const std::byte> rest() const { return {}; }
  void skip(const PlyRecords&) {}

 private:
  /// Whether the line is neither blank nor a comment.
  bool has_numbers() const {
    std::string_view rest = line_;
    const std::string_view word = take_word(rest);
    return !word.empty() && word != "comment";
  }

  LineReader lines_;
  std::size_t header_lines_;
  const std::string& name_;
  Warnings& warnings_;
  std::string_view line_;
};

/// The data of a binary file.
class PlyBinaryData {
 public:
  PlyBinaryData(std::span<const std::byte> bytes, std::endian order, const std::string& name)
      : rest_(bytes), order_(order), name_(name) {}

  void begin_item(const PlyElement& element, std::uint64_t item) {
    element_ = &element;
    item_ = item;
  }
  PlyValue take(NumberType type) {
    need(1, byte_size(type));
    const double value = load_number(rest_.data(), type, order_);
    rest_ = rest_.subspan(byte_size(type));
    return {value, 0};
  }
  void pass_over(NumberType type, std::uint64_t n) {
    need(n, byte_size(type));
    rest_ = rest_.subspan(static_cast<std::size_t>(n) * byte_size(type));
  }
  void end_item() const {}
  void end() const {
    if (!rest_.empty()) {
      throw InputError(name_, "has " + std::to_string(rest_.size()) + " bytes more than the header declares");
    }
  }
  InputError error(const std::string& cause) const { return InputError(name_, of_element(*element_, item_) + ": " + cause); }
  std::span<const std::byte> rest() const { return rest_; }
  void skip(const PlyRecords& records) { rest_ = rest_.subspan(records.count * records.size); }

 private:
  void need(std::uint64_t n, std::size_t size) const {
    if (n > rest_.size() / size) throw InputError(name_, "the file ends in " + of_element(*element_, item_));
  }

  std::span<const std::byte> rest_;
  std::endian order_;
  const std::string& name_;
  const PlyElement* element_ = nullptr;
  std::uint64_t item_ = 0;
};

}  // namespace ligne
