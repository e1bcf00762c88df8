#pragma once
/// Round numbers along an axis, and their text.

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
  decades,  ///< positions are decimal logarithms of what the labels say
};

/// Ticks in [from, to] at whole multiples of 1, 2 or 5 times a power of ten, the finest with no more than `most`, ascending.
/// A range of one number has a tick there. None when the ends are not finite or descend, or are too near to each other to be
/// distinguished by doubles. On the scale of decades: at powers of ten, every one or every 2nd, 5th, 10th ...; with room
/// enough at 1, 2 and 5 times or at 1 to 9 times the powers; within less than a decade at round numbers.
std::vector<Tick> round_ticks(TickScale scale, double from, double to, std::size_t most);

}  // namespace ligne
