#pragma once
/// Positions of axis ticks at round numbers, and their labels.

#include <cstddef>
#include <string>
#include <vector>

namespace ligne {

struct Tick {
  double at = 0;
  std::string label;  ///< UTF-8: true minus sign, 2·10⁶
};

enum class TickScale {
  linear,
  decades,  ///< logarithmic: positions are decimal logarithms of the numbers in the labels
};

/// At most `most` ticks in [from, to], ascending. The number of a linear tick at an end may miss the end by a five
/// hundredth of the range.
/// - linear: at multiples of 1, 2 or 5 times a power of ten, as close as `most` permits.
/// - decades: at powers of ten, all of them or every 2nd, 5th, 10th and so on; if `most` permits, at 1, 2 and 5 times
///   or at 1 to 9 times the powers; in a range of less than a decade, at round numbers.
///
/// A range of one number has a tick there. There are no ticks if the ends are not finite, descend, or are too close to
/// be distinguished by doubles.
std::vector<Tick> round_ticks(TickScale scale, double from, double to, std::size_t most);

}  // namespace ligne
