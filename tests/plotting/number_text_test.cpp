#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "plotting/number_text.hpp"

namespace ligne {
namespace {

std::string fixed(std::int64_t value, int decimals, bool bare_point = true) {
  char text[kNumberBytes];
  return {text, write_fixed(text, value, decimals, bare_point)};
}
std::string rounded(double value, int decimals) {
  std::string text;
  append_rounded(text, value, decimals);
  return text;
}

TEST(NumberText, Fixed) {
  EXPECT_EQ(fixed(0, 4), "0");
  EXPECT_EQ(fixed(1, 4), ".0001");
  EXPECT_EQ(fixed(-5000, 4), "-.5");
  EXPECT_EQ(fixed(-5000, 4, false), "-0.5");
  EXPECT_EQ(fixed(10000, 4), "1");
  EXPECT_EQ(fixed(-1234567, 4), "-123.4567");
  EXPECT_EQ(fixed(1230000, 4), "123");
  EXPECT_EQ(fixed(1230400, 4), "123.04");
  EXPECT_EQ(fixed(42, 0), "42");
  EXPECT_EQ(fixed(std::numeric_limits<std::int64_t>::min(), 4), "-922337203685477.5808");
}

TEST(NumberText, FixedAgreesWithTheLibrary) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 20000; ++i) {
    const auto value = static_cast<std::int64_t>(random() % 100000000) - 50000000;
    EXPECT_EQ(std::llround(std::strtod(fixed(value, 4, i % 2).c_str(), nullptr) * 1e4), value);
  }
}

TEST(NumberText, Rounded) {
  EXPECT_EQ(rounded(0.245, 6), "0.245");
  EXPECT_EQ(rounded(0.7 * 0.35, 6), "0.245");
  EXPECT_EQ(rounded(-1e-9, 6), "0");
  EXPECT_EQ(rounded(1e300, 6), "1e+300");
  EXPECT_EQ(rounded(std::nan(""), 6), "null");
}

}  // namespace
}  // namespace ligne
