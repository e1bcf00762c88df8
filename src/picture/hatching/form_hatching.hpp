#pragma once
/// Hatching that follows the form.

#include <vector>

#include "picture/hatching/hatching.hpp"

namespace ligne {

inline bool follows_form(const HatchRequest& request) {
  return request.asked() && request.direction.form != FormLines::none;
}

/// Strokes along the field of the request over the regions that are seen directly, the closer the darker; where it is
/// darkest others cross them. Throws RequestError.
std::vector<Layer> hatch_form(const HatchScene& hatch, const std::vector<Region>& regions);

}  // namespace ligne
