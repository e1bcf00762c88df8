#include "cli/surface_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "cli/errors.hpp"
#include "cli/models.hpp"
#include "cli/scene_drawing.hpp"
#include "cli/surface_samples.hpp"
#include "cli/text.hpp"
#include "plotting/output_file.hpp"
#include "scene/crossing_edges.hpp"
#include "scene/mesh_writer.hpp"
#include "scene/surface_mesh.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

/// How far below the lowest height the base lies when nothing is said, as a part of the range of heights.
constexpr double kBaseDepth = 0.05;

/// The factor by which heights take half of the larger side of the ground; 1 where a surface is parametric.
double z_scale_of(const SurfaceOptions& options, const std::vector<SurfacePoints>& surfaces, const std::vector<SurfaceMesh>& meshes) {
  if (options.z_scale) return *options.z_scale;
  const auto range = height_range(meshes);
  if (!range || !options.parametric.empty()) return 1;
  double low_x = surfaces[0].points.front().x, high_x = low_x, low_y = surfaces[0].points.front().y, high_y = low_y;
  for (const SurfacePoints& surface : surfaces) {
    low_x = std::min(low_x, surface.points.front().x);
    low_y = std::min(low_y, surface.points.front().y);
    high_x = std::max(high_x, surface.points.back().x);
    high_y = std::max(high_y, surface.points.back().y);
  }
  const double height = (*range)[1] - (*range)[0];
  const double scale = std::max(high_x - low_x, high_y - low_y) / (2 * height);
  return height > 0 && std::isfinite(scale) && scale > 0 ? scale : 1;
}

std::optional<double> base_of(const SurfaceOptions& options, const std::vector<SurfaceMesh>& meshes) {
  const auto range = height_range(meshes);
  if (!options.skirt || !range) return std::nullopt;
  const double lowest = (*range)[0], height = (*range)[1] - lowest;
  if (!options.skirt_base) return lowest - kBaseDepth * height;
  if (*options.skirt_base > lowest) {
    throw UsageError("--skirt", shortest(*options.skirt_base) + " is above the lowest height, " + shortest(lowest));
  }
  return options.skirt_base;
}

/// One surface z = f(x, y) can not penetrate itself.
bool may_cross(const SurfaceOptions& options) {
  return options.formulas.size() + options.grids.size() > 1 || !options.parametric.empty();
}

Scene scene_of(const SurfaceOptions& options) {
  const std::vector<SurfacePoints> surfaces = points_of(options);
  std::vector<SurfaceMesh> meshes;
  for (const SurfacePoints& surface : surfaces) {
    meshes.push_back(make_surface_mesh(surface));
    if (options.z_range) clip_heights(meshes.back(), (*options.z_range)[0], (*options.z_range)[1]);
  }
  Scene scene = surface_scene(meshes, z_scale_of(options, surfaces, meshes), base_of(options, meshes));
  if (may_cross(options) && !options.as_mesh) {
    double precision = 0;
    for (const Object& object : scene.objects) precision = std::max(precision, object.precision);
    mark_crossing_edges(scene, precision);
  }
  return scene;
}

void write_mesh(const SurfaceOptions& options, const Scene& scene, RunReport& run) {
  if (scene.faces.empty()) throw InputError(place_of_warnings(options), "has no cell without a hole: there is no mesh to write");
  const std::string text = timed(run.stages, "write", [&] {
    return mesh_format_of(options.output) == MeshFormat::obj ? write_obj(scene) : write_ligne_scene(scene);
  });
  timed(run.stages, "output", [&] { write_output(*options.output.file, text); });
  report(options.run, run);
}

}  // namespace

void run_surface_mesh(const SurfaceOptions& options) {
  RunReport run;
  const Scene scene = timed(run.stages, "read", [&] { return scene_of(options); });
  if (options.as_mesh) return write_mesh(options, scene, run);

  MethodOptions choice;
  choice.method = options.method;
  LineClasses classes;
  for (const LineClass c : {LineClass::horizon, LineClass::outline, LineClass::border}) classes.add(c);
  if (may_cross(options)) classes.add(LineClass::intersection);
  const ViewOptions view = view_of(options);
  SceneDrawing drawing{method_of(choice), {}, classes, choice.crease_degrees, options.hidden, false, view, options.page, options.output, options.run,
                       options.dpi, options.title, place_of_warnings(options)};
  draw_scene(scene, drawing, run);
}

}  // namespace ligne
