#include "base/portable.hpp"

#include <locale.h>
#include <stdlib.h>
#if __has_include(<xlocale.h>)
#include <xlocale.h>
#endif

#include <cmath>
#include <limits>
#include <string>
#include <string_view>

namespace ligne::library_fallback {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity(), kNotANumber = std::numeric_limits<double>::quiet_NaN();

bool is_digit(char c) { return c >= '0' && c <= '9'; }

const char* after_digits(const char* p, const char* last) {
  while (p != last && is_digit(*p)) ++p;
  return p;
}

/// End of the word in any case of letters; `first` if the text does not begin with it.
const char* after_word(const char* first, const char* last, std::string_view word) {
  const char* p = first;
  for (const char expected : word) {
    if (p == last || (*p | 0x20) != expected) return first;
    ++p;
  }
  return p;
}

/// End of "inf", "infinity", "nan" or "nan(...)"; `first` if the text begins with none.
const char* after_special(const char* first, const char* last) {
  if (const char* const infinity = after_word(first, last, "infinity"); infinity != first) return infinity;
  if (const char* const inf = after_word(first, last, "inf"); inf != first) return inf;
  const char* const nan = after_word(first, last, "nan");
  if (nan == first || nan == last || *nan != '(') return nan;
  const char* p = nan + 1;
  while (p != last && (is_digit(*p) || *p == '_' || ((*p | 0x20) >= 'a' && (*p | 0x20) <= 'z'))) ++p;
  return p != last && *p == ')' ? p + 1 : nan;
}

/// End of digits with at most one point among them; `first` if there are none.
const char* after_mantissa(const char* first, const char* last) {
  const char* const whole = after_digits(first, last);
  if (whole == last || *whole != '.') return whole;
  const char* const fraction = after_digits(whole + 1, last);
  return fraction == first + 1 ? first : fraction;
}

/// End of "e5", "e+5" or "e-5"; `first` if the text does not begin so.
const char* after_exponent(const char* first, const char* last) {
  if (first == last || (*first | 0x20) != 'e') return first;
  const char* p = first + 1;
  if (p != last && (*p == '+' || *p == '-')) ++p;
  const char* const end = after_digits(p, last);
  return end == p ? first : end;
}

}  // namespace

std::from_chars_result from_chars(const char* first, const char* last, double& value) {
  const char* const number = first != last && *first == '-' ? first + 1 : first;
  const char* const mantissa = after_mantissa(number, last);
  const char* const end = mantissa != number ? after_exponent(mantissa, last) : after_special(number, last);
  if (end == number) return {first, std::errc::invalid_argument};
  if (mantissa == number) {
    value = std::copysign((*number | 0x20) == 'i' ? kInfinity : kNotANumber, number == first ? 1.0 : -1.0);
    return {end, std::errc{}};
  }
  static const locale_t c_locale = newlocale(LC_ALL_MASK, "C", nullptr);
  const double parsed = strtod_l(std::string(first, end).c_str(), nullptr, c_locale);
  const bool underflows =
      parsed == 0 && std::string_view(number, mantissa).find_first_of("123456789") != std::string_view::npos;
  if (underflows || std::isinf(parsed)) return {end, std::errc::result_out_of_range};
  value = parsed;
  return {end, std::errc{}};
}

}  // namespace ligne::library_fallback
