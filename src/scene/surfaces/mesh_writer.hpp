#pragma once
/// Writes scenes as mesh files. Numbers have the fewest digits that read back as the same double.

#include <string>

#include "scene/model/scene.hpp"

namespace ligne {

/// The format `ligne-scene` (docs/scene-format.md): objects, vertices, faces with holes, precision, up axis. Materials,
/// details and lights are not written.
std::string write_ligne_scene(const Scene& scene);

/// Wavefront OBJ. Its faces have no holes, so those of the scene must have none either. OBJ does not define the up
/// axis, so a comment states it.
std::string write_obj(const Scene& scene);

}  // namespace ligne
