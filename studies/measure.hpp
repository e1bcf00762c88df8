#pragma once
/// Times and growth.

#include <algorithm>
#include <cmath>
#include <ctime>

namespace ligne::studies {

/// Seconds of the processor, which other work on the machine does not lengthen: the least of `times` runs. The work runs in
/// one thread.
template <class Work>
double least_seconds(int times, const Work& work) {
  double best = 1e300;
  for (int i = 0; i < times; ++i) {
    const std::clock_t start = std::clock();
    work();
    best = std::min(best, double(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return best;
}

/// Measures work that is shorter than the clock's step: it is repeated until it takes two thousandths of a second, or
/// very often. What it returns is looked at, so that no compiler leaves it out.
template <class Work>
double seconds_each(const Work& work) {
  constexpr int kMostRepeats = 1 << 20;
  [[maybe_unused]] volatile double sink = 0;
  for (int repeats = 1;; repeats *= 4) {
    const double all = least_seconds(1, [&] {
      double sum = 0;
      for (int i = 0; i < repeats; ++i) sum += static_cast<double>(work());
      sink = sum;
    });
    if (all >= 0.002 || repeats >= kMostRepeats) return all / repeats;
  }
}

/// How many times as long one time is as the other; a time that the clock shows as none counts as one of its steps.
inline double times_as_long(double seconds, double of) {
  constexpr double kStep = 1.0 / CLOCKS_PER_SEC;
  const auto seen = [](double time) { return time > 0 ? time : kStep; };
  return seen(seconds) / seen(of);
}

/// e where y grows as x^e from one point to the other.
inline double growth(double x0, double y0, double x1, double y1) { return std::log(y1 / y0) / std::log(x1 / x0); }

}  // namespace ligne::studies
