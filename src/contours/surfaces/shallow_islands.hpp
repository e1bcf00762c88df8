#pragma once
/// Parts of a smooth surface that look away from the viewer by a hair.

#include <span>

#include "contours/surfaces/smooth_patch.hpp"
#include "scene/creases/trace_creases.hpp"

namespace ligne {

/// On scans, flips the sign of g on small islands of the opposite sign where the surface nowhere turns far across the line
/// of sight. They are the grain of the scan: their contours would be rings side by side where the body is seen edge on.
/// O(corners of the patch).
void level_shallow_islands(SmoothPatch& patch, const Scene& scene, const Camera& camera, std::span<const ScanObject> scans);

}  // namespace ligne
