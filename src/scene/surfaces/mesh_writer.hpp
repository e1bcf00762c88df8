#pragma once
/// Scenes as mesh files, all numbers as the shortest that read back as the same double.

#include <string>

#include "scene/model/scene.hpp"

namespace ligne {

/// The format `ligne-scene` (docs/scene-format.md): objects, vertices, faces with holes, precision, up axis. Materials,
/// details and lights are not written.
std::string write_ligne_scene(const Scene& scene);

/// Wavefront OBJ. Its faces have no holes, so the scene's must have none either; OBJ does not say which axis is up either, a
/// comment does.
std::string write_obj(const Scene& scene);

}  // namespace ligne
