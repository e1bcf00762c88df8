#include "cli/surface_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "cli/errors.hpp"
#include "cli/models.hpp"
#include "cli/scene_drawing.hpp"
#include "cli/surface_samples.hpp"
#include "cli/text.hpp"
#include "scene/clean/crossing_edges.hpp"
#include "scene/surfaces/mesh_writer.hpp"
#include "scene/surfaces/surface_mesh.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

/// How far below the lowest height the base lies when nothing is said, as a part of the range of heights.
constexpr double kBaseDepth = 0.05;

/// Degrees: surfaces turn over their cells by less, and by more into their skirts. Creases are not drawn; hatching ends
/// there.
constexpr double kCrease = 75;

/// The factor by which heights take half of the larger side of the ground; 1 where a surface is parametric.
double z_scale_of(const SurfaceOptions& options, const std::vector<SurfacePoints>& surfaces,
                  const std::vector<SurfaceMesh>& meshes) {
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

/// What all surfaces take together, with the base; nothing where there are none. Of z = f(x, y) it is the ground of all
/// samples, whether there is a height or not.
std::optional<AxesBox> box_of(const std::vector<SurfacePoints>& surfaces, const std::vector<SurfaceMesh>& meshes,
                              std::optional<double> base) {
  const auto range = height_range(meshes);
  if (!range) return std::nullopt;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  AxesBox box{{kInfinity, kInfinity, (*range)[0]}, {-kInfinity, -kInfinity, (*range)[1]}};
  if (base) box.low.z = std::min(box.low.z, *base);
  const auto extend = [&](const Point3& p) {
    for (int k = 0; k < 2; ++k) {
      box.low[k] = std::min(box.low[k], p[k]);
      box.high[k] = std::max(box.high[k], p[k]);
    }
  };
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (!surfaces[i].parametric) {
      extend(surfaces[i].points.front());
      extend(surfaces[i].points.back());
      continue;
    }
    for (const auto& triangle : meshes[i].triangles) {
      for (const std::uint32_t v : triangle) extend(meshes[i].vertices[v]);
    }
  }
  return box;
}

struct Plot {
  Scene scene;
  std::optional<PlotBox> box;
};

Plot plot_of(const SurfaceOptions& options, RunFiles& files) {
  const std::vector<SurfacePoints> surfaces = points_of(options, files);
  std::vector<SurfaceMesh> meshes;
  for (const SurfacePoints& surface : surfaces) {
    meshes.push_back(make_surface_mesh(surface));
    if (options.z_range) clip_heights(meshes.back(), (*options.z_range)[0], (*options.z_range)[1]);
  }
  const double z_scale = z_scale_of(options, surfaces, meshes);
  const std::optional<double> base = base_of(options, meshes);
  Plot plot;
  if (const auto box = box_of(surfaces, meshes, base)) plot.box = PlotBox{*box, z_scale};
  if (const auto range = height_range(meshes); range && !options.as_mesh) {
    const std::vector<double> levels = contour_levels(options.curves, (*range)[0], (*range)[1]);
    for (SurfaceMesh& mesh : meshes) cut_contours(mesh, levels);
  }
  plot.scene = surface_scene(meshes, z_scale, base);
  Scene& scene = plot.scene;
  if (may_cross(options) && !options.as_mesh) {
    double precision = 0;
    for (const Object& object : scene.objects) precision = std::max(precision, object.precision);
    mark_crossing_edges(scene, precision);
  }
  return plot;
}

void write_mesh(const SurfaceOptions& options, const Scene& scene, RunFiles& files, RunReport& run) {
  if (scene.faces.empty())
    throw InputError(place_of_warnings(options), "has no cell without a hole: there is no mesh to write");
  std::string text = timed(run.stages, "write", [&] {
    return mesh_format_of(options.output) == MeshFormat::obj ? write_obj(scene) : write_ligne_scene(scene);
  });
  timed(run.stages, "output", [&] { files.write(*options.output.file, std::move(text)); });
  finish(options.run, run, files);
}

}  // namespace

void run_surface_mesh(const SurfaceOptions& options, RunFiles& files) {
  RunReport run;
  PlotterSetup plotter;
  if (!options.as_mesh) plotter = plotter_setup(options.plotter, format_of(options.output), files);
  const Plot plot = timed(run.stages, "read", [&] { return plot_of(options, files); });
  if (options.as_mesh) return write_mesh(options, plot.scene, files, run);

  LineClasses classes;
  for (const LineClass c : {LineClass::horizon, LineClass::contour}) classes.add(c);
  if (options.curves.outline.value_or(true)) {
    for (const LineClass c : {LineClass::outline, LineClass::border}) classes.add(c);
  }
  if (may_cross(options)) classes.add(LineClass::intersection);
  const ViewOptions view = view_of(options);
  const PlotFrame frame{options.axes, plot.box};
  SceneDrawing drawing{mesh_method_of(options),
                       {},
                       classes,
                       kCrease,
                       options.hidden,
                       false,
                       view,
                       options.page,
                       options.output,
                       options.run,
                       options.dpi,
                       options.title,
                       place_of_warnings(options),
                       format_of(options.output) == OutputFormat::json ? nullptr : &frame,
                       {},
                       plotter,
                       {},
                       options.hatch};
  draw_scene(plot.scene, drawing, files, run);
}

}  // namespace ligne
