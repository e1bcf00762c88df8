#pragma once
/// The transparent faces in front of the visible face of each pixel.

#include "drawing/result_models.hpp"
#include "view/projected_scene.hpp"
#include "visibility/raster/depth_buffer.hpp"

namespace ligne::zbuffer {

/// Adds the transparent faces of a scene to the pixels of its opaque ones: PixelModel::layers and in_front. A face is in
/// front of the visible face if its stored depth is smaller, or equal with a lower number; transparent faces are sorted
/// likewise. Changes nothing if the scene has no transparent face. O(n + p log p) for p pixels of transparent faces.
void add_transparent_faces(const ProjectedScene& scene, const DepthScale& scale, PixelModel& pixels);

}  // namespace ligne::zbuffer
