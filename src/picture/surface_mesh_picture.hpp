#pragma once
/// Surfaces by the mesh methods: whatever the floating horizon can not draw, and the surface as a mesh file.

#include <optional>
#include <string>

#include "picture/axes.hpp"
#include "picture/surface_request.hpp"
#include "picture/write_picture.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

/// The surfaces as a scene, and the picture that is made of it.
struct SurfaceScene {
  Scene scene;
  std::optional<PlotBox> box;
  PictureRequest picture;
};
SurfaceScene make_surface_scene(const SurfaceRequest& request, RunReport& run);

/// Draws the surfaces as meshes. Throws RequestError, InputError, std::runtime_error.
Picture draw_surface_mesh(const SurfaceRequest& request, RunReport& run);

enum class MeshFormat { ligne_scene, obj };

/// The bytes of a mesh file. Throws RequestError, InputError.
std::string write_surface_mesh(const SurfaceRequest& request, MeshFormat format, RunReport& run);

}  // namespace ligne
