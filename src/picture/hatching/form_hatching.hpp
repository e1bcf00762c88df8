#pragma once
/// Hatching along the curves of surfaces.

#include <vector>

#include "picture/hatching/hatching.hpp"

namespace ligne {

inline bool follows_form(const HatchRequest& request) {
  return request.is_requested() && request.direction.form != FormLines::none;
}

/// Draws strokes along the requested field over the regions that are visible directly, the closer the darker; crossed
/// in the darkest places. Throws RequestError.
std::vector<Layer> hatch_form(const HatchScene& hatch, const std::vector<Region>& regions);

}  // namespace ligne
