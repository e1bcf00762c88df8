#include "picture/surface/mixed_scene.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "picture/errors.hpp"
#include "picture/surface/surface_mesh_picture.hpp"
#include "scene/readers/reader.hpp"

namespace ligne {
namespace {

/// Converts a point of a scene with z up to a scene with another up axis.
Point3 turned(const Point3& p, Axis up) {
  return up == Axis::z ? p : up == Axis::y ? Point3{p.x, p.z, -p.y} : Point3{p.z, p.x, p.y};
}
Point3 turned_back(const Point3& p, Axis up) {
  return up == Axis::z ? p : up == Axis::y ? Point3{p.x, -p.z, p.y} : Point3{p.y, p.z, p.x};
}

/// Corners of the bounding box of a scene, rotated so that z is up.
std::array<Point3, 2> extent(const Scene& scene, Axis up) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::array<Point3, 2> box{Point3{kInfinity, kInfinity, kInfinity}, Point3{-kInfinity, -kInfinity, -kInfinity}};
  for (const Point3& vertex : scene.vertices) {
    const Point3 p = turned_back(vertex, up);
    for (int k = 0; k < 3; ++k) {
      box[0][k] = std::min(box[0][k], p[k]);
      box[1][k] = std::max(box[1][k], p[k]);
    }
  }
  return box;
}

}  // namespace

void check_mixed_scene(const SurfaceRequest& request) {
  if (std::max(request.u.size(), request.v.size()) > request.parametric.size()) {
    throw RequestError("", request.parametric.empty() ? "-u, -v: need --parametric"
                                                      : "-u, -v: there are more ranges than parametric surfaces");
  }
  if (height_count(request) == 0 && (request.x || request.y || request.every))
    throw RequestError("", "-x, -y, --every: need --surface or --grid");
  if (has_surfaces(request)) return;
  if (request.samples || request.z_scale || request.z_range)
    throw RequestError("", "--samples, --z-scale, --z-range: need --surface, --grid or --parametric");
}

void add_surfaces(const SurfaceRequest& request, LoadedModels& models, PictureRequest& picture, RunReport& run) {
  if (!has_surfaces(request)) return;
  picture.lines.classes.add(LineClass::horizon);
  const Axis up = picture.view.up_axis.value_or(models.scene.up_axis);
  Scene surfaces = surface_objects(request, extent(models.scene, up), run);
  for (Point3& p : surfaces.vertices) p = turned(p, up);
  for (const Object& object : surfaces.objects) models.object_names.push_back(object.name);
  const Axis model_up = models.scene.up_axis;
  const double unit_mm = models.scene.unit_mm;
  append_scene(models.scene, std::move(surfaces));
  models.scene.up_axis = model_up;
  models.scene.unit_mm = unit_mm;
  models.topology.reset();
  models.compiled_for = nullptr;  // a tree of the models alone
}

}  // namespace ligne
