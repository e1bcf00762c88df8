/// Ticks at round numbers, and their text.

#include "view/axes/ticks.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

using Labels = std::vector<std::string>;

Labels labels(const std::vector<Tick>& ticks) {
  Labels texts;
  for (const Tick& tick : ticks) texts.push_back(tick.label);
  return texts;
}
Labels linear(double from, double to, std::size_t most) { return labels(round_ticks(TickScale::linear, from, to, most)); }
Labels decades(double from, double to, std::size_t most) { return labels(round_ticks(TickScale::decades, from, to, most)); }

TEST(Ticks, KnownAnswers) {
  EXPECT_EQ(linear(0, 1, 6), (Labels{"0", "0.2", "0.4", "0.6", "0.8", "1"}));
  EXPECT_EQ(linear(0, 1, 11), (Labels{"0", "0.1", "0.2", "0.3", "0.4", "0.5", "0.6", "0.7", "0.8", "0.9", "1"}));
  EXPECT_EQ(linear(0, 1, 5), (Labels{"0", "0.5", "1"}));
  EXPECT_EQ(linear(0, 1, 2), (Labels{"0", "1"}));
  EXPECT_EQ(linear(0, 1, 1), (Labels{"0"}));
  EXPECT_EQ(linear(-5, 5, 11), (Labels{"−5", "−4", "−3", "−2", "−1", "0", "1", "2", "3", "4", "5"}));
  EXPECT_EQ(linear(-5, 5, 10), (Labels{"−4", "−2", "0", "2", "4"}));
  EXPECT_EQ(linear(-0.25, 0.05, 4), (Labels{"−0.2", "−0.1", "0"}));
  EXPECT_EQ(linear(0.3, 0.7, 3), (Labels{"0.4", "0.6"}));
  EXPECT_EQ(linear(1999.5, 2010, 6), (Labels{"2000", "2002", "2004", "2006", "2008", "2010"}));
}

TEST(Ticks, EndsThatAreRoundButForRoundingCount) {
  EXPECT_EQ(linear(0.1 + 0.2, 0.7 + 0.1 + 0.1, 4), (Labels{"0.4", "0.6", "0.8"}));
  EXPECT_EQ(linear(0.1 + 0.2, 1.1 - 0.2, 7), (Labels{"0.3", "0.4", "0.5", "0.6", "0.7", "0.8", "0.9"}));
  const auto ticks = round_ticks(TickScale::linear, 0.1 + 0.2, 1.1 - 0.2, 7);
  EXPECT_GE(ticks.front().at, 0.1 + 0.2) << "never outside the range";
  EXPECT_LE(ticks.back().at, 1.1 - 0.2);
}

TEST(Ticks, LargeAndSmallNumbersHavePowersOfTen) {
  EXPECT_EQ(linear(0, 1e-7, 3), (Labels{"0", "5·10⁻⁸", "10⁻⁷"}));
  EXPECT_EQ(linear(-2e-7, 2e-7, 5), (Labels{"−2·10⁻⁷", "−10⁻⁷", "0", "10⁻⁷", "2·10⁻⁷"}));
  EXPECT_EQ(linear(0, 1e9, 6), (Labels{"0", "2·10⁸", "4·10⁸", "6·10⁸", "8·10⁸", "10⁹"}));
  EXPECT_EQ(linear(0, 1e6, 3), (Labels{"0", "5·10⁵", "10⁶"}));
  EXPECT_EQ(linear(0, 2.5e12, 6), (Labels{"0", "5·10¹¹", "10¹²", "1.5·10¹²", "2·10¹²", "2.5·10¹²"}));
  EXPECT_EQ(linear(0, 50000, 3), (Labels{"0", "20000", "40000"}));
  EXPECT_EQ(linear(1e9, 1e9 + 10, 3), (Labels{"1000000000", "1000000005", "1000000010"}))
      << "a power of ten would be longer";
  EXPECT_EQ(linear(-1e300, 1e300, 3), (Labels{"−10³⁰⁰", "0", "10³⁰⁰"}));
}

TEST(Ticks, OneNumberAndNone) {
  EXPECT_EQ(linear(3, 3, 5), (Labels{"3"}));
  EXPECT_EQ(linear(-0.1, -0.1, 5), (Labels{"−0.1"}));
  EXPECT_EQ(linear(0, 0, 5), (Labels{"0"}));
  EXPECT_EQ(linear(1.5e10, 1.5e10, 5), (Labels{"1.5·10¹⁰"}));
  EXPECT_EQ(linear(0.1 + 0.2, 0.1 + 0.2, 5), (Labels{"0.30000000000000004"})) << "that is what the number is";
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(linear(0, 1, 0), Labels{});
  EXPECT_EQ(linear(1, 0, 5), Labels{});
  EXPECT_EQ(linear(nan, 1, 5), Labels{});
  EXPECT_EQ(linear(0, infinity, 5), Labels{});
  EXPECT_EQ(linear(1, std::nextafter(1.0, 2.0), 5), Labels{}) << "doubles can not tell ticks apart there";
}

TEST(Ticks, TheExtremesOfDoublesEndInTime) {
  const double largest = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  for (const auto& [from, to] : {std::pair{-largest, largest},
                                 {0.0, largest},
                                 {0.0, least},
                                 {-least, least},
                                 {0.0, 1e-310},
                                 {-largest, 0.0},
                                 {largest / 2, largest},
                                 {-1.0, largest}}) {
    for (const std::size_t most : {1u, 2u, 5u, 11u}) {
      for (const TickScale scale : {TickScale::linear, TickScale::decades})
        for (const Tick& tick : round_ticks(scale, from, to, most)) EXPECT_TRUE(from <= tick.at && tick.at <= to);
    }
  }
}

TEST(Ticks, Decades) {
  EXPECT_EQ(decades(-3, 3, 7), (Labels{"10⁻³", "10⁻²", "10⁻¹", "10⁰", "10¹", "10²", "10³"}));
  EXPECT_EQ(decades(-3, 3, 5), (Labels{"10⁻²", "10⁰", "10²"}));
  EXPECT_EQ(decades(-300, 300, 8), (Labels{"10⁻³⁰⁰", "10⁻²⁰⁰", "10⁻¹⁰⁰", "10⁰", "10¹⁰⁰", "10²⁰⁰", "10³⁰⁰"}));
  EXPECT_EQ(decades(0, 2, 8), (Labels{"1", "2", "5", "10", "20", "50", "100"}));
  EXPECT_EQ(decades(5, 7, 8), (Labels{"10⁵", "2·10⁵", "5·10⁵", "10⁶", "2·10⁶", "5·10⁶", "10⁷"}));
  EXPECT_EQ(decades(std::log10(1.5), std::log10(4.5), 9), (Labels{"2", "3", "4"}));
  EXPECT_EQ(decades(std::log10(2.1), std::log10(2.9), 4), (Labels{"2.2", "2.4", "2.6", "2.8"}));
  const auto ticks = round_ticks(TickScale::decades, 0, 1, 5);
  ASSERT_EQ(ticks.size(), 4u);
  EXPECT_DOUBLE_EQ(ticks[1].at, std::log10(2));
  EXPECT_DOUBLE_EQ(ticks[3].at, 1);
}

TEST(Ticks, AscendWithinTheRangeAndAreNoMoreThanAsked) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> mantissa(-10, 10), exponent(-12, 12);
  for (int i = 0; i < 2000; ++i) {
    const double scale = std::pow(10, exponent(random));
    double a = mantissa(random) * scale, b = mantissa(random) * scale;
    if (a > b) std::swap(a, b);
    for (const std::size_t most : {1u, 3u, 4u, 7u, 11u}) {
      const auto ticks = round_ticks(TickScale::linear, a, b, most);
      EXPECT_LE(ticks.size(), most);
      if (most >= 4) {
        EXPECT_GE(2.5 * static_cast<double>(ticks.size() + 1), static_cast<double>(most))
            << a << " to " << b << ": a step of 1, 2 or 5 fills more";
      }
      for (std::size_t k = 0; k < ticks.size(); ++k) {
        EXPECT_TRUE(a <= ticks[k].at && ticks[k].at <= b);
        if (k > 0) {
          EXPECT_LT(ticks[k - 1].at, ticks[k].at);
        }
        test::expect_no_parts(ticks[k].label, {"000000"});
      }
    }
  }
}

}  // namespace
}  // namespace ligne
