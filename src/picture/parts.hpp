#pragma once
/// Drawings whose layers are divided by object, colour and material.

#include <string>
#include <vector>

#include "drawing/drawing.hpp"
#include "picture/requests.hpp"
#include "picture/scene_visibility.hpp"

namespace ligne {

/// Whether the request divides lines by object, colour or material.
bool has_parts(const PictureRequest& request);

/// The names of all objects. An object without a name is named by its number.
std::vector<std::string> object_names(const Scene& scene);

/// A drawing with layers by line class, each divided by the objects, colours and materials that the request
/// distinguishes. A line belongs to the first face of its source edge.
Drawing drawing_by_parts(const SceneVisibility& study, const Scene& scene, const PictureRequest& request);

}  // namespace ligne
