#pragma once
/// Writes numbers as text, fast and the same on every machine.

#include <cstdint>
#include <string>

namespace ligne {

/// Most bytes that write_fixed and append_shortest write.
inline constexpr std::size_t kNumberBytes = 32;

/// 10^n, 0 <= n <= 15.
std::int64_t power_of_ten(int n);

/// Writes value / 10^decimals without trailing zeros, and returns the end. A leading zero before the point is left out when
/// `bare_point`: "-.5" instead of "-0.5".
char* write_fixed(char* out, std::int64_t value, int decimals, bool bare_point);

/// Appends the shortest decimal number that reads back as the same double; "null" for infinities and NaN.
void append_shortest(std::string& out, double value);

/// The number with exactly this many decimals.
std::string fixed(double value, int decimals);

/// The number rounded to this many decimals, without trailing zeros but with the leading one.
void append_rounded(std::string& out, double value, int decimals);
std::string decimal_text(double value, int decimals);

}  // namespace ligne
