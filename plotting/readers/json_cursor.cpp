#include "plotting/readers/json_cursor.hpp"

#include "base/portable.hpp"

namespace ligne {

std::string_view JsonCursor::string() {
  expect('"');
  const std::size_t begin = at_;
  for (; at_ < text_.size() && text_[at_] != '"'; ++at_) {
    if (text_[at_] == '\\') ++at_;
  }
  if (at_ >= text_.size()) throw JsonSyntaxError(begin);
  return text_.substr(begin, at_++ - begin);
}

double JsonCursor::number() {
  skip_blanks();
  double value = 0;
  const char* const begin = text_.data() + at_;
  const auto [end, error] = from_chars(begin, text_.data() + text_.size(), value);
  // The words inf and nan are numbers to from_chars, and not to JSON.
  const bool is_number =
      error == std::errc() && end != begin && (*begin == '-' || (*begin >= '0' && *begin <= '9')) && value - value == 0;
  if (!is_number) throw JsonSyntaxError(at_);
  at_ += static_cast<std::size_t>(end - begin);
  return value;
}

std::string_view JsonCursor::value() {
  skip_blanks();
  const std::size_t begin = at_;
  std::size_t open = 0;
  for (; at_ < text_.size(); ++at_) {
    const char c = text_[at_];
    if (c == '"') {
      string();
      --at_;
    } else if (c == '{' || c == '[') {
      ++open;
    } else if (c == '}' || c == ']') {
      if (open == 0) break;
      --open;
    } else if (c == ',' && open == 0) {
      break;
    }
  }
  if (open > 0 || at_ == begin) throw JsonSyntaxError(begin);
  return text_.substr(begin, at_ - begin);
}

}  // namespace ligne
