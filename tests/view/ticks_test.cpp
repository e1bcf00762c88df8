/// Ticks at round numbers, and their text.

#include "view/axes/ticks.hpp"

#include "main/script.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

/// Labels of the ticks of "FROM TO MOST": values/ticks.txt.
std::string labels(TickScale scale, const std::string& text, double (*end)(double)) {
  const std::vector<std::string> words = test::words_of(text);
  std::string all;
  for (const Tick& tick :
       round_ticks(scale, end(test::value_of(words.at(0))), end(test::value_of(words.at(1))), std::stoul(words.at(2))))
    all += (all.empty() ? "" : " ") + tick.label;
  return all;
}
double itself(double x) { return x; }
double exponent(double x) { return std::log10(x); }

const test::TextFunctions kFunctions{
    {"linear", [](auto& t) { return labels(TickScale::linear, t, itself); }},
    {"decades", [](auto& t) { return labels(TickScale::decades, t, itself); }},
    {"decades-of", [](auto& t) { return labels(TickScale::decades, t, exponent); }},
};

[[maybe_unused]] const bool values_are_added = test::add_function_scripts(LIGNE_SOURCE_DIR "/tests/view/values", kFunctions);

TEST(Ticks, EndsThatAreRoundButForRoundingCount) {
  const auto ticks = round_ticks(TickScale::linear, 0.1 + 0.2, 1.1 - 0.2, 7);
  EXPECT_GE(ticks.front().at, 0.1 + 0.2) << "never outside the range";
  EXPECT_LE(ticks.back().at, 1.1 - 0.2);
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
    for (const std::size_t most : {1u, 2u, 5u, 11u})
      for (const TickScale scale : {TickScale::linear, TickScale::decades})
        for (const Tick& tick : round_ticks(scale, from, to, most)) EXPECT_TRUE(from <= tick.at && tick.at <= to);
  }
}

TEST(Ticks, Decades) {
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
