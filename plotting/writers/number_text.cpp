#include "plotting/writers/number_text.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace ligne {
namespace {

constexpr int kMostDecimals = 15;

constexpr auto kPowers = [] {
  std::array<std::int64_t, kMostDecimals + 1> powers{1};
  for (int i = 1; i <= kMostDecimals; ++i) powers[i] = 10 * powers[i - 1];
  return powers;
}();

/// Largest scaled value that is written as an integer. A larger one would not fit into 64 bits, and is written in full.
constexpr double kLargestInteger = 9e18;

}  // namespace

std::int64_t power_of_ten(int n) { return kPowers[n]; }

char* write_fixed(char* out, std::int64_t value, int decimals, bool bare_point) {
  if (value < 0) *out++ = '-';
  const std::uint64_t magnitude = value < 0 ? -static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value);
  const auto power = static_cast<std::uint64_t>(kPowers[decimals]);
  const std::uint64_t whole = magnitude / power;
  std::uint64_t fraction = magnitude % power;
  if (whole != 0 || fraction == 0 || !bare_point) out = std::to_chars(out, out + kNumberBytes, whole).ptr;
  if (fraction == 0) return out;
  while (fraction % 10 == 0) {
    fraction /= 10;
    --decimals;
  }
  *out++ = '.';
  for (int i = decimals; i-- > 0; fraction /= 10) out[i] = static_cast<char>('0' + fraction % 10);
  return out + decimals;
}

void append_shortest(std::string& out, double value) {
  if (!std::isfinite(value)) {
    out += "null";
    return;
  }
  char text[kNumberBytes];
  out.append(text, std::to_chars(text, text + kNumberBytes, value).ptr);
}

void append_rounded(std::string& out, double value, int decimals) {
  const double scaled = value * static_cast<double>(kPowers[decimals]);
  if (!(std::abs(scaled) < kLargestInteger)) return append_shortest(out, value);
  char text[kNumberBytes];
  out.append(text, write_fixed(text, std::llround(scaled), decimals, false));
}

std::string decimal_text(double value, int decimals) {
  std::string text;
  append_rounded(text, value, decimals);
  return text;
}

/// Buffer size of fixed(), bytes: the largest double has 309 digits before the point, and callers ask for some twenty
/// decimals at most.
constexpr std::size_t kLongestFixed = 352;

std::string fixed(double value, int decimals) {
  char text[kLongestFixed];
  return {text, static_cast<std::size_t>(std::snprintf(text, sizeof text, "%.*f", decimals, value))};
}

}  // namespace ligne
