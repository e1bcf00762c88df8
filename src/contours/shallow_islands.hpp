#pragma once
/// Parts of a smooth surface that look away from the viewer by a hair.

#include <span>

#include "contours/smooth_patch.hpp"
#include "scene/creases/trace_creases.hpp"

namespace ligne {

/// On scans, turns areas round on which g has one sign, round which it has the other, and where the surface nowhere turns
/// far across the sight: they are its grain, and their contours would be rings, one beside the other where a side of the
/// body is seen edge on. O(corners of the patch).
void level_shallow_islands(SmoothPatch& patch, const Scene& scene, const Camera& camera, std::span<const ScanObject> scans);

}  // namespace ligne
