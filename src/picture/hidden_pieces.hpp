#pragma once
/// Removes hidden pieces from a painting order, so that a painted picture does not contain the whole model.

#include <cstddef>
#include <cstdint>
#include <functional>

#include "drawing/result_models.hpp"
#include "geometry/point.hpp"

namespace ligne {

/// Removes pieces that opaque pieces in front hide, and returns their number. It tests points on the page at a distance
/// of kSampleMm: a piece stays if a point on it or next to it is not hidden. So visible pieces stay, except where they
/// are seen only through gaps between other pieces that are narrower than the rim with which these are painted.
/// `is_opaque` is called with a face. O(pieces + points under them / 64).
std::size_t drop_hidden_pieces(PaintOrder& order, const Rect& page, const std::function<bool(std::uint32_t)>& is_opaque);

}  // namespace ligne
