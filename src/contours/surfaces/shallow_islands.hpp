#pragma once
/// Small parts of a scan that face the other way than their surroundings by a few degrees only.

#include <span>

#include "contours/surfaces/smooth_patch.hpp"
#include "scene/creases/trace_creases.hpp"

namespace ligne {

/// On scans, flips the sign of g on islands of the opposite sign if the surface there is nowhere inclined to the line
/// of sight by 4 degrees. These islands are noise of the scan; their contours would be many small rings where the body
/// is seen edge on. O(corners of the patch).
void level_shallow_islands(SmoothPatch& patch, const Scene& scene, const Camera& camera, std::span<const ScanObject> scans);

}  // namespace ligne
