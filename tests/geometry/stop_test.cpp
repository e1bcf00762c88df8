// Work that is told to end does so in its loops, in all threads, and other work goes on.

#include <gtest/gtest.h>

#include <atomic>

#include "geometry/stop.hpp"

namespace ligne {
namespace {

constexpr std::size_t kMany = 1'000'000;

TEST(Stop, LoopsEndSoonAfterTheyAreTold) {
  std::atomic<bool> stop = false;
  std::atomic<std::size_t> done = 0;
  const auto work = [&] {
    parallel_tasks(kMany, [&](std::size_t) {
      if (++done == 1000) stop = true;
    });
  };
  EXPECT_THROW(run_until(stop, work), Stopped);
  EXPECT_GE(done, 1000u);
  EXPECT_LT(done, kMany / 2);
}

TEST(Stop, LoopsInsideLoopsKnowIt) {
  std::atomic<bool> stop = false;
  std::atomic<std::size_t> inner = 0;
  const auto work = [&] {
    parallel_tasks(1, [&](std::size_t) {
      stop = true;
      parallel_for(8, [&](std::size_t) { ++inner; });
    });
  };
  EXPECT_THROW(run_until(stop, work), Stopped);
  EXPECT_EQ(inner, 0u);
}

TEST(Stop, WorkThatIsToldBeforeDoesNotBegin) {
  const std::atomic<bool> stop = true;
  EXPECT_THROW(run_until(stop, [] { FAIL(); }), Stopped);
}

TEST(Stop, OtherWorkGoesOn) {
  std::atomic<bool> stop = false, other_stop = true;
  std::atomic<std::size_t> done = 0;
  run_until(stop, [&] {
    EXPECT_THROW(run_until(other_stop, [] {}), Stopped);
    parallel_for(1000, [&](std::size_t) { ++done; });
    check_stop();
  });
  EXPECT_EQ(done, 1000u);
  // Outside nobody tells it to end.
  stop = true;
  check_stop();
  parallel_for(1000, [&](std::size_t) { ++done; });
  EXPECT_EQ(done, 2000u);
}

TEST(Stop, SerialLoopsAsk) {
  std::atomic<bool> stop = false;
  EXPECT_THROW(run_until(stop,
                         [&] {
                           check_stop();
                           stop = true;
                           check_stop();
                         }),
               Stopped);
}

}  // namespace
}  // namespace ligne
