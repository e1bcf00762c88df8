#pragma once
/// Removes hidden pieces from a painting order, so that a painted picture does not contain the whole model.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "drawing/result_models.hpp"
#include "geometry/point.hpp"

namespace ligne {

/// Per piece 1 if opaque pieces in front hide it, tested at points of the page at a distance of kSampleMm. A piece is
/// hidden if no point on it or next to it is visible. So no visible piece is removed, except one visible only through
/// gaps narrower than the rim that pieces are painted with. `is_opaque` is called with a face. O(pieces + points under
/// them / 64).
std::vector<std::uint8_t> find_hidden_pieces(const PaintOrder& order, const Rect& page,
                                             const std::function<bool(std::uint32_t)>& is_opaque);

/// Removes these pieces and returns their number.
std::size_t drop_hidden_pieces(PaintOrder& order, const Rect& page, const std::function<bool(std::uint32_t)>& is_opaque);

}  // namespace ligne
