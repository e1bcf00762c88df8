#pragma once
/// An order of painting without what is painted over: a picture that is painted holds what is seen, and not the whole model.

#include <cstddef>
#include <cstdint>
#include <functional>

#include "drawing/result_models.hpp"
#include "geometry/point.hpp"

namespace ligne {

/// Leaves out pieces that opaque pieces before them hide, and returns their number. Points of the page `kSampleMm` apart are
/// looked at: a piece stays when one of those on it, or next to it, is not hidden. So what is seen stays, but for gaps
/// between other pieces that are narrower than the rim that these are painted with. `is_opaque`: by face.
/// O(pieces + points under them / 64).
std::size_t drop_hidden_pieces(PaintOrder& order, const Rect& page, const std::function<bool(std::uint32_t)>& is_opaque);

}  // namespace ligne
