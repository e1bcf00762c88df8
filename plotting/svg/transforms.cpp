#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "plotting/svg/values.hpp"

namespace ligne::svg {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

constexpr std::pair<std::string_view, double> kAngles[] = {{"deg", 1}, {"grad", 0.9}, {"rad", 1 / kDegree}, {"turn", 360}};

/// One number of a transform, which in CSS may be a length or an angle.
double argument(Scanner& scanner, const Viewport* port, double whole) {
  const double value = scanner.number();
  if (!port) return value;
  const std::string unit = scanner.peek() == '%' ? std::string(1, scanner.take()) : std::string(scanner.word());
  for (const auto& [name, degrees] : kAngles) {
    if (name == unit) return value * degrees;
  }
  return unit.empty() ? value : value * length_px("1" + unit, *port, whole);
}

/// The transform of this name; nothing if there is none with this number of arguments.
std::optional<Matrix> transform_of(std::string_view name, const std::vector<double>& v) {
  const std::size_t n = v.size();
  if (name == "matrix" && n == 6) return Matrix{v[0], v[1], v[2], v[3], v[4], v[5]};
  if (name == "translate" && (n == 1 || n == 2)) return Matrix{1, 0, 0, 1, v[0], n == 2 ? v[1] : 0};
  if (name == "scale" && (n == 1 || n == 2)) return Matrix{v[0], 0, 0, n == 2 ? v[1] : v[0], 0, 0};
  if (name == "rotate" && n == 1) return turn(v[0]);
  if (name == "rotate" && n == 3) return Matrix{1, 0, 0, 1, v[1], v[2]} * turn(v[0]) * Matrix{1, 0, 0, 1, -v[1], -v[2]};
  if (name == "skewX" && n == 1) return Matrix{1, 0, std::tan(v[0] * kDegree), 1, 0, 0};
  if (name == "skewY" && n == 1) return Matrix{1, std::tan(v[0] * kDegree), 0, 1, 0, 0};
  return {};
}

/// Transforms that only CSS has (CSS Transforms 1, 12).
std::optional<Matrix> css_transform_of(std::string_view name, const std::vector<double>& v) {
  const std::size_t n = v.size();
  if (name == "translateX" && n == 1) return Matrix{1, 0, 0, 1, v[0], 0};
  if (name == "translateY" && n == 1) return Matrix{1, 0, 0, 1, 0, v[0]};
  if (name == "scaleX" && n == 1) return Matrix{v[0], 0, 0, 1, 0, 0};
  if (name == "scaleY" && n == 1) return Matrix{1, 0, 0, v[0], 0, 0};
  if (name == "rotateZ" && n == 1) return turn(v[0]);
  if (name == "skew" && (n == 1 || n == 2))
    return Matrix{1, n == 2 ? std::tan(v[1] * kDegree) : 0, std::tan(v[0] * kDegree), 1, 0, 0};
  return {};
}

}  // namespace

Matrix turn(double degrees) {
  const double c = std::cos(degrees * kDegree), s = std::sin(degrees * kDegree);
  return {c, s, -s, c, 0, 0};
}

std::optional<double> angle_degrees(std::string_view text) {
  Scanner scanner(trimmed(text));
  if (!scanner.at_number()) return {};
  const double value = scanner.number();
  if (scanner.done()) return value;
  const std::string_view unit = scanner.word();
  for (const auto& [name, degrees] : kAngles) {
    if (name == unit && scanner.done()) return value * degrees;
  }
  return {};
}

Matrix transform(std::string_view text, const Viewport* port) {
  Matrix result;
  if (trimmed(text) == "none") return result;
  Scanner scanner(text);
  while (!scanner.done()) {
    const std::string_view name = scanner.word();
    scanner.skip_blanks();
    if (scanner.take() != '(') fail_value(text, "is not a list of transforms");
    std::vector<double> v;
    for (scanner.skip_blanks(); scanner.peek() != ')'; scanner.skip_separator()) {
      if (v.size() == 6) fail_value(text, "is a transform of too many numbers");
      const bool down = name == "translateY" || v.size() == 1;
      v.push_back(argument(scanner, port, !port ? 0 : down ? port->height : port->width));
    }
    scanner.take();
    scanner.skip_separator();
    std::optional<Matrix> m = transform_of(name, v);
    if (!m && port) m = css_transform_of(name, v);
    if (!m) fail_value(text, "is not a list of transforms");
    result = result * *m;
  }
  if (!result.finite()) fail_value(text, "is a transform out of the range of numbers");
  return result;
}

Point2 transform_origin(std::string_view text, const Viewport& port, const Matrix& box) {
  std::vector<std::string_view> words;
  while (!(text = trimmed(text)).empty()) {
    const std::size_t end = std::min(text.find_first_of(kBlanks), text.size());
    words.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  const auto is_down = [](std::string_view word) { return word == "top" || word == "bottom"; };
  const auto is_across = [](std::string_view word) { return word == "left" || word == "right"; };
  if (words.size() == 1) words.push_back("center");
  if (words.size() >= 2 && (is_down(words[0]) || is_across(words[1]))) std::swap(words[0], words[1]);
  if (words.size() < 2) throw std::invalid_argument("is not a position");
  const auto at = [&](std::string_view word, double whole) {
    if (word == "left" || word == "top") return 0.0;
    if (word == "center") return whole / 2;
    return word == "right" || word == "bottom" ? whole : length_px(word, port, whole);
  };
  return {box.e + at(words[0], box.a), box.f + at(words[1], box.d)};
}

}  // namespace ligne::svg
