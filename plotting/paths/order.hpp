#pragma once
/// The order in which a pen draws its strokes.

#include <cstdint>
#include <vector>

#include "drawing/drawing.hpp"

namespace ligne {

struct OrderOptions {
  Point2 home{0, 0};          ///< where the pen comes from, page mm
  bool returns = false;       ///< it goes back there at the end
  bool inside_first = false;  ///< what lies in a closed stroke is drawn before it, even where the way up becomes longer
  /// The work that improving may do, in strokes moved: the same for the same input, whatever the machine.
  std::uint64_t most_work = 150'000'000;
};

/// Puts the strokes in an order, and each in a direction, that makes the way with the pen up short: nearest neighbour first,
/// then 2-opt and or-opt until nothing is gained or the work is done. Closed lines start where that is best.
/// The way with the pen up is never longer than in the given order. `order`, if not null, gets the given numbers of the
/// strokes in their new order.
Polylines order_strokes(const Polylines& lines, const OrderOptions& options, std::vector<std::uint32_t>* order = nullptr);

}  // namespace ligne
