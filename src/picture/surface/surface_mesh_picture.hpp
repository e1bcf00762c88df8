#pragma once
/// Draws surfaces by the mesh methods, if the floating horizon can not draw them, and writes them as mesh files.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "picture/marks/axes.hpp"
#include "picture/pages/write_picture.hpp"
#include "picture/surface/surface_request.hpp"
#include "picture/surface/surface_samples.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

/// Surfaces as a scene, with the request for its picture. `surfaces`: result of surfaces_of(), here and below.
struct SurfaceScene {
  Scene scene;
  std::optional<PlotBox> box;
  PictureRequest picture;
};
SurfaceScene make_surface_scene(const SurfaceRequest& request, const std::vector<Surface>& surfaces, RunReport& run);

/// Draws the surfaces as meshes. Throws RequestError, InputError, std::runtime_error.
Picture draw_surface_mesh(const SurfaceRequest& request, const std::vector<Surface>& surfaces, RunReport& run);

/// Returns the surfaces as objects of a scene with z up, in the units of their axes, with heights times --z-scale, for
/// a picture with models. `ground`: default range of formulas, low and high corner. Throws RequestError, InputError.
Scene surface_objects(SurfaceRequest request, const std::array<Point3, 2>& ground, RunReport& run);

enum class MeshFormat { ligne_scene, obj };

/// ".json" or ".obj". Throws std::invalid_argument.
MeshFormat mesh_format_of_suffix(const std::string& file);

/// Returns the bytes of a mesh file. Throws RequestError, InputError.
std::string write_surface_mesh(const SurfaceRequest& request, MeshFormat format, RunReport& run);

}  // namespace ligne
