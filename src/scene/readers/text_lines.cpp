#include "scene/readers/text_lines.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include "base/portable.hpp"

namespace ligne {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Removes a plus sign, which from_chars does not accept.
std::string_view without_plus(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  return word;
}

}  // namespace

std::string_view as_text(std::span<const std::byte> bytes, const std::string& name) {
  std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    throw InputError(name, "is UTF-16 text; UTF-8 is needed");
  }
  if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(zero), '\n');
    throw error_at_line(name, static_cast<std::size_t>(line), "zero byte in a text file");
  }
  return text;
}

bool LineReader::next(std::string_view& line) {
  if (rest_.empty()) return false;
  ++number_;
  // find_first_of() would call memchr() for each character.
  std::size_t end = 0;
  while (end < rest_.size() && (rest_[end] > '\r' || (rest_[end] != '\n' && rest_[end] != '\r'))) ++end;
  line = rest_.substr(0, end);
  if (end == rest_.size()) {
    rest_ = {};
    return true;
  }
  const bool pair = rest_[end] == '\r' && end + 1 < rest_.size() && rest_[end + 1] == '\n';
  rest_.remove_prefix(end + (pair ? 2 : 1));
  return true;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string_view without_comment(std::string_view text) {
  for (std::size_t i = text.find('#'); i != std::string_view::npos; i = text.find('#', i + 1)) {
    const bool begins = i == 0 || is_blank(text[i - 1]), ends = i + 1 == text.size() || is_blank(text[i + 1]);
    if (begins && ends) return text.substr(0, i);
  }
  return text;
}

std::string_view take_word(std::string_view& line) {
  std::size_t begin = 0;
  while (begin < line.size() && is_blank(line[begin])) ++begin;
  std::size_t end = begin;
  while (end < line.size() && !is_blank(line[end])) ++end;
  const std::string_view word = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return word;
}

bool equal_ignoring_case(std::string_view a, std::string_view b) {
  return a.size() == b.size() && starts_with_ignoring_case(a, b);
}

bool starts_with_ignoring_case(std::string_view text, std::string_view beginning) {
  return text.size() >= beginning.size() &&
         std::equal(beginning.begin(), beginning.end(), text.begin(), [](char a, char b) { return lower(a) == lower(b); });
}

std::optional<double> number_in(std::string_view word) {
  word = without_plus(word);
  double value = 0;
  const auto [end, error] = from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty() || end != word.data() + word.size()) return {};
  if (error == std::errc::result_out_of_range) {
    // A number too large for a double has a positive exponent, or hundreds of digits before the point.
    const std::size_t e = word.find_first_of("eE");
    const bool tiny = e != std::string_view::npos
                          ? word.substr(e + 1).starts_with('-')
                          : word.starts_with("0.") || word.starts_with("-0.") || word.starts_with('.');
    if (tiny) return 0.0;
    return {};
  }
  if (error != std::errc{} || !std::isfinite(value)) return {};
  return value;
}

std::optional<std::int64_t> parse_integer(std::string_view word) {
  word = without_plus(word);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size()) return {};
  return value;
}

InputError error_at_line(const std::string& name, std::size_t line, const std::string& cause) {
  return InputError(name + ":" + std::to_string(line), cause);
}

}  // namespace ligne
