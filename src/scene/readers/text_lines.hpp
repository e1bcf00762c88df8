#pragma once
/// Tools shared by the readers of text formats: lines, words, numbers, and error lines with a line number.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "scene/model/diagnostics.hpp"

namespace ligne {

/// The bytes as text, without a UTF-8 byte order mark. Throws InputError for UTF-16 text and for text with a zero byte.
std::string_view as_text(std::span<const std::byte> bytes, const std::string& name);

/// Reads a text line by line; lines end with \n, \r\n or \r.
class LineReader {
 public:
  explicit LineReader(std::string_view text) : rest_(text) {}
  /// Takes the next line, without its end; false if there is none.
  bool next(std::string_view& line);
  /// Number of the line taken last, from 1; 0 before the first.
  std::size_t number() const { return number_; }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

/// True for a blank, a tab, and the rarer white space within a line.
constexpr bool is_blank(char c) { return c <= ' ' && (c == ' ' || c == '\t' || c == '\v' || c == '\f'); }
std::string_view trimmed(std::string_view text);
/// Takes the next word off the front of a line; empty if there is none.
std::string_view take_word(std::string_view& line);
/// The text before a comment, which begins with a "#" that stands alone. A name may contain one ("#3", "a#b").
std::string_view without_comment(std::string_view text);
/// Compares letters without regard to case (ASCII).
bool equal_ignoring_case(std::string_view a, std::string_view b);
bool starts_with_ignoring_case(std::string_view text, std::string_view beginning);

/// The value of a word that is exactly a decimal number, correctly rounded. Numbers too small for a double are 0.
/// Nothing for other words, nan, inf and numbers too large for a double.
std::optional<double> number_in(std::string_view word);
/// The value of a word that is exactly a whole number.
std::optional<std::int64_t> parse_integer(std::string_view word);

/// "FILE:LINE: cause".
InputError error_at_line(const std::string& name, std::size_t line, const std::string& cause);

}  // namespace ligne
