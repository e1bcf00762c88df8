#include "plotting/svg/values.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "base/portable.hpp"
#include "files/message_text.hpp"

namespace ligne::svg {
namespace {

bool blank(char c) { return kBlanks.find(c) != std::string_view::npos; }

}  // namespace

void fail_value(std::string_view text, const std::string& cause) {
  throw std::invalid_argument(shown(text, '"') + " " + cause);
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

Matrix Matrix::operator*(const Matrix& o) const {
  return {a * o.a + c * o.b, b * o.a + d * o.b,     a * o.c + c * o.d,
          b * o.c + d * o.d, a * o.e + c * o.f + e, b * o.e + d * o.f + f};
}

double Matrix::stretch() const {
  const double sum = a * a + b * b + c * c + d * d, det = a * d - b * c;
  return std::sqrt((sum + std::sqrt(std::max(sum * sum - 4 * det * det, 0.0))) / 2);
}

double Matrix::mean_stretch() const { return std::sqrt(std::abs(a * d - b * c)); }

bool Matrix::is_similarity() const {
  constexpr double kRelative = 1e-6;  // numbers in SVG are often written with six digits
  const double size = stretch() * kRelative;
  return std::abs(a - d) <= size && std::abs(b + c) <= size && a * d - b * c > 0;
}

bool Matrix::finite() const {
  for (const double v : {a, b, c, d, e, f}) {
    if (!std::isfinite(v)) return false;
  }
  return true;
}

std::optional<Matrix> Matrix::inverse() const {
  const double det = a * d - b * c;
  const Matrix back{d / det, -b / det, -c / det, a / det, (c * f - d * e) / det, (b * e - a * f) / det};
  return back.finite() ? std::optional(back) : std::nullopt;
}

void Scanner::skip_blanks() {
  while (!text_.empty() && blank(text_.front())) text_.remove_prefix(1);
}

void Scanner::skip_separator() {
  skip_blanks();
  if (peek() != ',') return;
  text_.remove_prefix(1);
  skip_blanks();
}

bool Scanner::done() {
  skip_blanks();
  return text_.empty();
}

char Scanner::take() {
  const char c = peek();
  if (!text_.empty()) text_.remove_prefix(1);
  return c;
}

bool Scanner::at_number() const {
  const char c = peek();
  return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+';
}

double Scanner::number() {
  std::string_view rest = text_;
  if (peek() == '+') rest.remove_prefix(1);
  double value = 0;
  // from_chars knows "inf" and "nan", SVG does not.
  const bool starts = !rest.empty() && ((rest[0] >= '0' && rest[0] <= '9') || rest[0] == '.' ||
                                        (rest[0] == '-' && rest.data() == text_.data()));
  const auto [end, error] = from_chars(rest.data(), rest.data() + rest.size(), value);
  if (!starts || error != std::errc() || !std::isfinite(value)) fail_value(text_, "does not begin with a number");
  text_.remove_prefix(static_cast<std::size_t>(end - text_.data()));
  return value;
}

bool Scanner::flag() {
  const char c = take();
  if (c != '0' && c != '1') throw std::invalid_argument("a flag of an arc is neither 0 nor 1");
  return c == '1';
}

std::string_view Scanner::word() {
  std::size_t n = 0;
  while (n < text_.size() && ((text_[n] >= 'a' && text_[n] <= 'z') || (text_[n] >= 'A' && text_[n] <= 'Z'))) ++n;
  const std::string_view found = text_.substr(0, n);
  text_.remove_prefix(n);
  return found;
}

std::vector<double> numbers(std::string_view text) {
  std::vector<double> values;
  Scanner scanner(text);
  while (!scanner.done()) {
    values.push_back(scanner.number());
    scanner.skip_separator();
  }
  return values;
}

double length_px(std::string_view text, const Viewport& port, double whole) {
  // Values of CSS for a font that does not give them.
  constexpr double kExOfEm = 0.5, kChOfEm = 0.5, kIcOfEm = 1, kLineOfEm = 1.2;
  const double inch = port.px_per_inch, vw = port.page_width / 100, vh = port.page_height / 100;
  const std::pair<std::string_view, double> units[] = {
      {"", 1},
      {"px", 1},
      {"%", whole / 100},
      {"mm", inch / kMmPerInch},
      {"cm", inch / 2.54},
      {"in", inch},
      {"pt", inch / 72},
      {"pc", inch / 6},
      {"q", inch / 101.6},
      {"em", port.em},
      {"ex", port.em * kExOfEm},
      {"ch", port.em * kChOfEm},
      {"ic", port.em * kIcOfEm},
      {"lh", port.em * kLineOfEm},
      {"rem", port.rem},
      {"rlh", port.rem * kLineOfEm},
      {"vw", vw},
      {"vh", vh},
      {"vi", vw},
      {"vb", vh},
      {"vmin", std::min(vw, vh)},
      {"vmax", std::max(vw, vh)},
  };
  const std::string_view clean = trimmed(text);
  Scanner scanner(clean);
  const double value = scanner.number();
  const std::string unit = scanner.peek() == '%' ? std::string(1, scanner.take()) : lower_case(scanner.word());
  for (const auto& [name, px] : units) {
    if (name == unit && scanner.done()) return value * px;
  }
  fail_value(clean,
             "is not a length in px, mm, cm, in, pt, pc, Q, em, ex, ch, ic, lh, rem, rlh, vw, vh, vi, vb, vmin, vmax or %");
}

}  // namespace ligne::svg
