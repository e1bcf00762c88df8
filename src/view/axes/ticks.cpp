#include "view/axes/ticks.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string_view>

#include "base/portable.hpp"

namespace ligne {
namespace {

/// Largest number of digits of a number that is always written plainly. A longer one is written with a power of ten if
/// that is shorter.
constexpr std::size_t kShortNumber = 5;
/// Largest number of digits of a plain number before or after the point.
constexpr int kMostPlainDigits = 17;
/// Largest distance of a tick from the end of its axis, as a fraction of the axis, for which it stands at the end: less
/// than a pen shows on a page. Samples rarely meet the highest point of a surface, which is often a round number.
constexpr double kMissedEnd = 0.002;
/// Largest multiple of a step. Integers are exact in doubles up to here; beyond it neighbouring ticks could be equal.
constexpr double kMostSteps = 0x1p53 / 10;

constexpr std::string_view kMinus = "\u2212", kTimes = "\u00b7", kRaisedMinus = "\u207b";
constexpr std::string_view kRaisedDigits[] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                              "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};

/// The exact number n 10^exponent.
struct Decimal {
  std::int64_t n = 0;
  int exponent = 0;
};

/// Removes trailing zeros of n.
Decimal shortened(Decimal d) {
  if (d.n == 0) return {0, 0};
  for (; d.n % 10 == 0; d.n /= 10) ++d.exponent;
  return d;
}

double value_of(Decimal d) {
  const std::string text = std::to_string(d.n) + "e" + std::to_string(d.exponent);
  double value = 0;
  const auto result = from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec == std::errc{}) return value;
  return d.exponent < 0 ? 0 : std::copysign(std::numeric_limits<double>::infinity(), static_cast<double>(d.n));
}

/// The shortest decimal that reads back as the double.
Decimal decimal_of(double value) {
  char text[64];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::scientific).ptr;
  Decimal d;
  const char* p = text + (*text == '-');
  for (; p != end && *p != 'e'; ++p) {
    if (*p == '.') continue;
    d.n = 10 * d.n + (*p - '0');
    --d.exponent;
  }
  ++d.exponent;  // exponent of the digit before the point
  const char* const exponent = p + 1 + (p + 1 != end && p[1] == '+');
  int e = 0;
  std::from_chars(exponent, end, e);
  d.exponent += e;
  if (*text == '-') d.n = -d.n;
  return shortened(d);
}

std::string sign_of(Decimal d) { return d.n < 0 ? std::string(kMinus) : std::string(); }
std::string digits_of(Decimal d) { return std::to_string(std::abs(d.n)); }

std::string power_text(int exponent) {
  std::string text = "10";
  if (exponent < 0) text += kRaisedMinus;
  for (const char c : std::to_string(std::abs(exponent))) text += kRaisedDigits[c - '0'];
  return text;
}

/// Text of a decimal with few digits, such as "-0.025".
std::string plain_text(Decimal d) {
  std::string digits = digits_of(d);
  if (d.exponent >= 0) {
    if (d.n != 0) digits.append(static_cast<std::size_t>(d.exponent), '0');
  } else {
    const auto decimals = static_cast<std::size_t>(-d.exponent);
    if (digits.size() <= decimals) digits.insert(0, decimals + 1 - digits.size(), '0');
    digits.insert(digits.size() - decimals, ".");
  }
  return sign_of(d) + digits;
}

/// Text with a power of ten, such as "-2.5·10⁶" or "10⁶".
std::string scientific_text(Decimal d) {
  if (d.n == 0) return "0";
  std::string digits = digits_of(d);
  const int exponent = d.exponent + static_cast<int>(digits.size()) - 1;
  if (digits == "1") return sign_of(d) + power_text(exponent);
  if (digits.size() > 1) digits.insert(1, ".");
  return sign_of(d) + digits + std::string(kTimes) + power_text(exponent);
}

std::size_t characters(std::string_view utf8) {
  return static_cast<std::size_t>(std::count_if(utf8.begin(), utf8.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

/// Returns all texts plain or all with powers of ten, whichever is shorter in total.
std::vector<std::string> texts_of(const std::vector<Decimal>& numbers) {
  std::vector<std::string> plain, scientific;
  std::size_t longest = 0, plain_sum = 0, scientific_sum = 0;
  bool can_be_plain = true;
  for (const Decimal& d : numbers) {
    scientific.push_back(scientific_text(d));
    scientific_sum += characters(scientific.back());
    const int digits = static_cast<int>(digits_of(d).size());
    can_be_plain = can_be_plain && d.exponent + digits <= kMostPlainDigits && d.exponent >= -kMostPlainDigits;
    if (!can_be_plain) continue;
    plain.push_back(plain_text(d));
    longest = std::max(longest, characters(plain.back()) - (d.n < 0 ? 1 : 0));
    plain_sum += characters(plain.back());
  }
  return can_be_plain && (longest <= kShortNumber || plain_sum <= scientific_sum) ? plain : scientific;
}

/// A step of 1, 2 or 5 times a power of ten.
struct Step {
  int digit = 1, exponent = 0;
  double size() const { return value_of({digit, exponent}); }
  Step coarser() const {
    if (digit == 5) return {1, exponent + 1};
    return {digit == 1 ? 2 : 5, exponent};
  }
};

/// First and last integer multiple of a step in a range. The range has a slack: a fraction of it, and the rounding of
/// both ends and of the division.
struct Multiples {
  double first = 0, last = -1;
  Multiples(double from, double to, double step, double fraction = 0) {
    const double slack = 4 * std::numeric_limits<double>::epsilon() * std::max(std::abs(from), std::abs(to)) / step +
                         fraction * (to / step - from / step);
    first = std::ceil(from / step - slack);
    last = std::floor(to / step + slack);
  }
  double count() const { return last - first + 1; }
};

/// `missed`: fraction of the range by which the first and the last number may lie outside.
std::vector<Decimal> round_numbers(double from, double to, std::size_t most, double missed) {
  if (from == to) return {decimal_of(from)};
  // The half, since the whole span may overflow a double.
  const double half_span = to / 2 - from / 2;
  if (!(half_span > 0)) return {};
  Step step{1, static_cast<int>(std::floor(std::log10(half_span) - std::log10(static_cast<double>(most)))) - 1};
  const auto multiples_of = [&] { return Multiples(from, to, step.size(), missed); };
  while (step.size() == 0 || multiples_of().count() > static_cast<double>(most)) step = step.coarser();
  const Multiples multiples = multiples_of();
  if (!(std::abs(multiples.first) < kMostSteps && std::abs(multiples.last) < kMostSteps)) return {};
  std::vector<Decimal> numbers;
  const auto last = static_cast<std::int64_t>(multiples.last);
  for (auto k = static_cast<std::int64_t>(multiples.first); k <= last; ++k) {
    numbers.push_back(shortened({k * step.digit, step.exponent}));
  }
  return numbers;
}

/// One tick for each number, at position(number).
template <class Position>
std::vector<Tick> ticks_at(const std::vector<Decimal>& numbers, Position position) {
  std::vector<std::string> texts = texts_of(numbers);
  std::vector<Tick> ticks;
  for (std::size_t i = 0; i < numbers.size(); ++i) ticks.push_back({position(numbers[i]), std::move(texts[i])});
  return ticks;
}

double logarithm(Decimal d) { return d.exponent + std::log10(static_cast<double>(d.n)); }

std::vector<Tick> with_powers(const std::vector<int>& exponents) {
  std::vector<Tick> ticks;
  ticks.reserve(exponents.size());
  for (const int e : exponents) ticks.push_back({static_cast<double>(e), power_text(e)});
  return ticks;
}

/// Ticks at the digits times all powers of ten in the range of logarithms.
std::vector<Tick> digit_ticks(double from, double to, std::initializer_list<int> digits) {
  std::vector<Decimal> numbers;
  for (int e = static_cast<int>(std::floor(from)); e <= static_cast<int>(std::floor(to)); ++e) {
    for (const int d : digits) {
      const double at = e + std::log10(d);
      if (from <= at && at <= to) numbers.push_back({d, e});
    }
  }
  return ticks_at(numbers, logarithm);
}

std::vector<Tick> decade_ticks(double from, double to, std::size_t most) {
  // Powers of ten outside the range of doubles can not be labelled.
  constexpr double kLeast = std::numeric_limits<double>::min_exponent10,
                   kLargest = std::numeric_limits<double>::max_exponent10;
  from = std::max(from, kLeast);
  to = std::min(to, kLargest);
  if (from > to) return {};
  const double decades = std::floor(to) - std::ceil(from) + 1;
  if (decades < 2 || 3 * (decades - 1) + 1 <= static_cast<double>(most)) {
    std::vector<Tick> ticks = digit_ticks(from, to, {1, 2, 3, 4, 5, 6, 7, 8, 9});
    if (ticks.size() >= 2 && ticks.size() <= most) return ticks;
    ticks = digit_ticks(from, to, {1, 2, 5});
    if (ticks.size() >= 2 && ticks.size() <= most) return ticks;
  }
  if (decades < 1) {
    return ticks_at(round_numbers(std::pow(10, from), std::pow(10, to), most, 0),
                    [&](Decimal d) { return std::clamp(logarithm(d), from, to); });
  }
  for (Step step;; step = step.coarser()) {
    const int every = static_cast<int>(step.size());
    const Multiples multiples(from, to, every);
    if (multiples.count() > static_cast<double>(most)) continue;
    std::vector<int> exponents;
    for (double k = multiples.first; k <= multiples.last; ++k) exponents.push_back(static_cast<int>(k) * every);
    return with_powers(exponents);
  }
}

}  // namespace

std::vector<Tick> round_ticks(TickScale scale, double from, double to, std::size_t most) {
  if (!(std::isfinite(from) && std::isfinite(to) && from <= to) || most == 0) return {};
  if (scale == TickScale::decades) return decade_ticks(from, to, most);
  return ticks_at(round_numbers(from, to, most, kMissedEnd), [&](Decimal d) { return std::clamp(value_of(d), from, to); });
}

}  // namespace ligne
