#pragma once
/// Removes hidden pieces from a painting order, so that a painted picture does not contain the whole model.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "drawing/result_models.hpp"
#include "geometry/point.hpp"

namespace ligne {

/// Per piece 1 if opaque pieces in front hide it. It tests points on the page at a distance
/// of kSampleMm: a piece is hidden if no point on it or next to it is seen. So no visible piece is, except where it
/// is seen only through gaps between other pieces that are narrower than the rim with which these are painted.
/// `is_opaque` is called with a face. O(pieces + points under them / 64).
std::vector<std::uint8_t> find_hidden_pieces(const PaintOrder& order, const Rect& page,
                                             const std::function<bool(std::uint32_t)>& is_opaque);

/// Removes these pieces, and returns their number.
std::size_t drop_hidden_pieces(PaintOrder& order, const Rect& page, const std::function<bool(std::uint32_t)>& is_opaque);

}  // namespace ligne
