#include "plotting/svg/values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "files/message_text.hpp"
#include "geometry/portable.hpp"
#include "plotting/pens.hpp"

namespace ligne::svg {
namespace {

[[noreturn]] void fail(std::string_view text, const std::string& cause) {
  throw std::invalid_argument(shown(text, '"') + " " + cause);
}

bool blank(char c) { return kBlanks.find(c) != std::string_view::npos; }

}  // namespace

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
  if (!starts || error != std::errc() || !std::isfinite(value)) fail(text_, "does not begin with a number");
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

double length_px(std::string_view text, std::optional<double> whole, std::optional<double> em) {
  constexpr std::pair<std::string_view, double> units[] = {{"", 1},           {"px", 1},        {"mm", 96 / kMmPerInch},
                                                           {"cm", 96 / 2.54}, {"in", 96},       {"pt", 96.0 / 72},
                                                           {"pc", 16},        {"Q", 96 / 101.6}};
  const std::string_view clean = trimmed(text);
  Scanner scanner(clean);
  const double value = scanner.number();
  if (scanner.peek() == '%' && whole) {
    scanner.take();
    if (scanner.done()) return value * *whole / 100;
  }
  constexpr double kExOfEm = 0.5;  // as CSS has it where the font does not tell
  if (em && scanner.peek() == 'e') {
    const std::string_view of_font = scanner.word();
    if (of_font == "em" && scanner.done()) return value * *em;
    if (of_font == "ex" && scanner.done()) return value * *em * kExOfEm;
  }
  const std::string_view unit = scanner.word();
  for (const auto& [name, px] : units) {
    if (name == unit && scanner.done()) return value * px;
  }
  fail(clean, "is not a length in px, mm, cm, in, pt, pc or Q");
}

Matrix transform(std::string_view text) {
  constexpr double kDegree = std::numbers::pi / 180;
  Matrix result;
  Scanner scanner(text);
  while (!scanner.done()) {
    const std::string_view name = scanner.word();
    scanner.skip_blanks();
    if (scanner.take() != '(') fail(text, "is not a list of transforms");
    std::vector<double> v;
    for (scanner.skip_blanks(); scanner.peek() != ')'; scanner.skip_separator()) {
      if (v.size() == 6) fail(text, "is a transform of too many numbers");
      v.push_back(scanner.number());
    }
    scanner.take();
    scanner.skip_separator();
    const std::size_t n = v.size();
    Matrix m;
    if (name == "matrix" && n == 6) {
      m = {v[0], v[1], v[2], v[3], v[4], v[5]};
    } else if (name == "translate" && (n == 1 || n == 2)) {
      m = {1, 0, 0, 1, v[0], n == 2 ? v[1] : 0};
    } else if (name == "scale" && (n == 1 || n == 2)) {
      m = {v[0], 0, 0, n == 2 ? v[1] : v[0], 0, 0};
    } else if (name == "rotate" && (n == 1 || n == 3)) {
      const double c = std::cos(v[0] * kDegree), s = std::sin(v[0] * kDegree);
      m = {c, s, -s, c, 0, 0};
      if (n == 3) m = Matrix{1, 0, 0, 1, v[1], v[2]} * m * Matrix{1, 0, 0, 1, -v[1], -v[2]};
    } else if (name == "skewX" && n == 1) {
      m.c = std::tan(v[0] * kDegree);
    } else if (name == "skewY" && n == 1) {
      m.b = std::tan(v[0] * kDegree);
    } else {
      fail(text, "is not a list of transforms");
    }
    result = result * m;
  }
  if (!result.finite()) fail(text, "is a transform beyond all numbers");
  return result;
}

namespace {

/// "hsl(210, 50%, 40%)", with "deg", slashes and an opacity or without.
std::optional<std::string> hsl(std::string_view text) {
  const std::size_t open = text.find('(');
  if (!text.ends_with(')')) fail(text, "is not a colour that is known");
  Scanner scanner(text.substr(open + 1, text.size() - open - 2));
  std::array<double, 4> values{0, 0, 0, 1};
  for (std::size_t i = 0; i < values.size() && !scanner.done(); ++i) {
    if (scanner.peek() == '/') scanner.take();
    scanner.skip_blanks();
    values[i] = scanner.number();
    const bool percent = scanner.peek() == '%';
    if (percent) scanner.take();
    const std::string_view unit = scanner.word();
    if (!unit.empty() && unit != "deg") fail(text, "is not a colour that is known");
    if (i == 3 && percent) values[i] /= 100;
    scanner.skip_separator();
  }
  if (values[3] == 0) return std::nullopt;
  const double hue = values[0] - 360 * std::floor(values[0] / 360), full = std::clamp(values[1], 0.0, 100.0) / 100,
               light = std::clamp(values[2], 0.0, 100.0) / 100;
  // CSS Color 3, 4.2.4.
  const auto level = [&](double n) {
    const double k = std::fmod(n + hue / 30, 12), a = full * std::min(light, 1 - light);
    return light - a * std::max(-1.0, std::min({k - 3, 9 - k, 1.0}));
  };
  return color_code({level(0), level(8), level(4)});
}

}  // namespace

std::optional<std::string> paint(std::string_view text) {
  const std::string_view clean = trimmed(text);
  if (clean == "none" || clean == "transparent") return std::nullopt;
  if (clean == "currentColor" || clean == "currentcolor") return "currentColor";
  // With an opacity behind the colour.
  if (clean.starts_with('#') && (clean.size() == 5 || clean.size() == 9)) {
    const std::size_t digits = clean.size() == 5 ? 1 : 2;
    const bool clear = clean.substr(clean.size() - digits).find_first_not_of('0') == std::string_view::npos;
    return clear ? std::nullopt : paint(clean.substr(0, clean.size() - digits));
  }
  if (clean.starts_with("hsl(") || clean.starts_with("hsla(")) return hsl(clean);
  const bool alpha = clean.starts_with("rgba(");
  if ((clean.starts_with("rgb(") || alpha) && clean.ends_with(")")) {
    const std::size_t head = alpha ? 5 : 4;
    Scanner scanner(clean.substr(head, clean.size() - head - 1));
    std::array<double, 3> levels{};
    for (double& level : levels) {
      scanner.skip_separator();
      level = scanner.number();
      const bool percent = scanner.peek() == '%';
      if (percent) scanner.take();
      level = std::clamp(level / (percent ? 100 : 255), 0.0, 1.0);
    }
    scanner.skip_separator();
    if (alpha && scanner.number() == 0) return std::nullopt;
    return color_code(levels);
  }
  try {
    return color_code(parse_color(lower_case(clean)));  // SVG does not tell large letters of names from small ones
  } catch (const std::invalid_argument&) {
    // Other names of colours are names of layers as they stand.
    if (!clean.empty() &&
        std::all_of(clean.begin(), clean.end(), [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }))
      return std::string(clean);
    fail(clean, "is not a colour that is known");
  }
}

double brightness(const std::string& color) {
  try {
    const std::array<double, 3> rgb = parse_color(color);
    return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];  // ITU-R BT.709
  } catch (const std::invalid_argument&) {
    return 0;
  }
}

}  // namespace ligne::svg
