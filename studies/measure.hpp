#pragma once
/// Time measurement and growth rates.

#include <algorithm>
#include <cmath>
#include <ctime>

namespace ligne::studies {

/// Processor seconds of one run, least of `times` runs. Other processes do not lengthen them. The work runs in one thread.
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

/// Seconds of work shorter than the clock's step. Repeats it until it takes two milliseconds, at most kMostRepeats times.
/// The results are summed into a volatile variable so that the compiler can not drop the work.
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

/// Ratio of two times. A time that the clock shows as zero counts as one clock step.
inline double times_as_long(double seconds, double of) {
  constexpr double kStep = 1.0 / CLOCKS_PER_SEC;
  const auto seen = [](double time) { return time > 0 ? time : kStep; };
  return seen(seconds) / seen(of);
}

/// The exponent e of y ~ x^e through the two points.
inline double growth(double x0, double y0, double x1, double y1) { return std::log(y1 / y0) / std::log(x1 / x0); }

}  // namespace ligne::studies
