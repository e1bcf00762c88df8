#pragma once
/// Drawings that tell parts apart: lines by their objects, colours and materials.

#include <string>
#include <vector>

#include "drawing/drawing.hpp"
#include "picture/requests.hpp"
#include "picture/scene_visibility.hpp"

namespace ligne {

/// Whether lines of different objects or materials are drawn apart.
bool tells_parts(const PictureRequest& request);

/// The names of all objects; those without one have their number.
std::vector<std::string> object_names(const Scene& scene);

/// Layers by class, and inside a class by what is told apart. A line belongs to the first face of its source edge.
Drawing drawing_by_parts(const SceneVisibility& study, const Scene& scene, const PictureRequest& request);

}  // namespace ligne
