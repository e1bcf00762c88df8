#pragma once
/// Orders the strokes of a pen so that the raised pen travels little.

#include <cstdint>
#include <vector>

#include "drawing/drawing.hpp"

namespace ligne {

struct OrderOptions {
  Point2 home{0, 0};          ///< start of the pen, page mm
  bool returns = false;       ///< whether the pen travels back there at the end
  bool inside_first = false;  ///< draw strokes inside a closed stroke before it, even if the raised pen travels farther
  /// Limit of the optimization, in moved strokes. It does not depend on time, so the result is the same on any machine.
  std::uint64_t most_work = 150'000'000;
};

/// Chooses order and directions of the strokes so that the travel of the raised pen is short: by nearest neighbours
/// first, then by 2-opt and or-opt until there is no gain or the limit is reached. Closed lines start at the best of
/// their points. The travel is never longer than in the given order. `order`, if not null, receives the original
/// indices of the strokes in the new order.
Polylines order_strokes(const Polylines& lines, const OrderOptions& options, std::vector<std::uint32_t>* order = nullptr);

}  // namespace ligne
