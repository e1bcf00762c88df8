#include "base/portable.hpp"

#include <charconv>
#include <clocale>
#include <thread>

#include "support/test.hpp"

namespace ligne {
namespace {

/// Both readers take the same characters and give the same bits, or the same error and leave the value alone.
void expect_equal_reading(const std::string& text) {
  double ours = -17, library = -17;
  const auto [our_end, our_error] = library_fallback::from_chars(text.data(), text.data() + text.size(), ours);
  const auto [library_end, library_error] = std::from_chars(text.data(), text.data() + text.size(), library);
  EXPECT_EQ(our_end - text.data(), library_end - text.data()) << text;
  EXPECT_EQ(our_error, library_error) << text;
  EXPECT_EQ(std::bit_cast<std::uint64_t>(ours), std::bit_cast<std::uint64_t>(library)) << text;
}

TEST(StandInFromChars, ReadsTheGrammarOfTheStandardLibrary) {
  std::istringstream texts(
      "- +1 1 -1 -0 0 00012 1. .5 -.5 . -. .e5 1..2 1.5.2 1e5 1E5 1e+5 1e-5 1e 1e+ 1e-x 1ex 1.e3 1e5e5 0x10 0x1p3 1,5 1_000 "
      "12abc inf -inf INF infinity Infinity7 infinit in nan -nan nanx nan( nan(7) --1 e5 1e400 -1e400 1e-400 -1e-400 0e400 "
      "0e999999999999999999 1e99999999999999999999 1e-99999999999999999999 4.9e-324 2.2250738585072011e-308 "
      "1.7976931348623157e308 1.7976931348623159e308 9007199254740993 0.1");
  for (std::string text; texts >> text;) expect_equal_reading(text);
  expect_equal_reading("");
  expect_equal_reading(" 1");
}

TEST(StandInFromChars, RoundsToTheNearestDouble) {
  std::mt19937_64 random(42);
  for (int i = 0; i < 20'000; ++i) {
    // Halfway between two doubles, and a little beside that: more digits than a double has.
    const double value = std::bit_cast<double>(random() & 0x7fefffffffffffffu);
    std::array<char, 1200> digits;
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::scientific, 17 + i % 40).ptr;
    expect_equal_reading({digits.data(), end});
  }
  for (int i = 0; i < 20'000; ++i)
    expect_equal_reading(std::to_string(random()) + "." + std::to_string(random()) + "e" +
                         std::to_string(static_cast<int>(random() % 700) - 350));
}

TEST(StandInFromChars, GivesBackEveryDoubleThatWasWritten) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 50'000; ++i) {
    const double value = std::bit_cast<double>(random() & 0xffefffffffffffffu);
    std::array<char, 40> text;
    const auto written = std::to_chars(text.data(), text.data() + text.size(), value);
    double read = 0;
    const auto [end, error] = library_fallback::from_chars(text.data(), written.ptr, read);
    ASSERT_EQ(error, std::errc{});
    ASSERT_EQ(end, written.ptr);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(read), std::bit_cast<std::uint64_t>(value));
  }
}

TEST(StandInFromChars, ReadsThePointWhateverTheLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "C.UTF-8"}) {
    std::setlocale(LC_ALL, name);
    expect_equal_reading("1.5");
    expect_equal_reading("1,5");
  }
  std::setlocale(LC_ALL, before.c_str());
}

TEST(StandInAtomicRef, CountsWhatSeveralThreadsTake) {
  constexpr int kThreads = 4, kEach = 20'000;
  std::uint32_t left = kThreads * kEach, lowest = 1'000'000;
  std::vector<std::thread> threads;
  for (int t = 0; t < kThreads; ++t)
    threads.emplace_back([&, t] {
      const library_fallback::AtomicRef<std::uint32_t> counter(left), minimum(lowest);
      for (int i = 0; i < kEach; ++i) {
        counter.fetch_sub(1, std::memory_order_relaxed);
        const auto number = static_cast<std::uint32_t>(7 + t + kThreads * (kEach - i));
        std::uint32_t known = minimum.load(std::memory_order_relaxed);
        while (number < known && !minimum.compare_exchange_weak(known, number, std::memory_order_relaxed)) {
        }
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(left, 0u);
  EXPECT_EQ(lowest, 7u + kThreads);
}

TEST(StandInAtomicRef, StoresAndExchangesAnEnumerator) {
  enum class Mark : std::uint8_t { none, some };
  Mark mark = Mark::none;
  const library_fallback::AtomicRef<Mark> reference(mark);
  EXPECT_EQ(reference.exchange(Mark::some), Mark::none);
  EXPECT_EQ(reference.load(), Mark::some);
  reference.store(Mark::none, std::memory_order_release);
  EXPECT_EQ(mark, Mark::none);
  const std::uint32_t constant = 5;
  EXPECT_EQ(library_fallback::AtomicRef<const std::uint32_t>(constant).load(std::memory_order_relaxed), 5u);
}

}  // namespace
}  // namespace ligne
