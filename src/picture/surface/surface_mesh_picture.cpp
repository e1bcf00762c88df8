#include "picture/surface/surface_mesh_picture.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <utility>

#include <glm/common.hpp>

#include "files/message_text.hpp"
#include "picture/draw_scene.hpp"
#include "picture/errors.hpp"
#include "picture/hatching/form_field.hpp"
#include "picture/surface/surface_curves.hpp"
#include "picture/surface/surface_scale.hpp"
#include "picture/surface/surface_terrain.hpp"
#include "scene/clean/crossing_edges.hpp"
#include "scene/surfaces/contours/cut_cells.hpp"
#include "scene/surfaces/mesh_writer.hpp"
#include "scene/surfaces/surface_mesh.hpp"

namespace ligne {
namespace {

/// Default distance of the base below the lowest height, as a fraction of the range of heights.
constexpr double kSkirtDepth = 0.05;

/// Default number of curves of a grid in a picture with models, per family.
constexpr std::size_t kCurvesAmongModels = 60;

/// Crease angle in degrees. Adjacent cells of a surface differ by less, a surface and its skirt by more. Creases are
/// not drawn, but hatching ends there.
constexpr double kCrease = 75;

std::optional<double> base_of(const SurfaceRequest& request, const std::optional<std::array<double, 2>>& range) {
  if (!request.skirt || !range) return std::nullopt;
  const double lowest = (*range)[0], height = (*range)[1] - lowest;
  if (!request.skirt_base) return lowest - kSkirtDepth * height;
  if (*request.skirt_base > lowest) {
    throw RequestError("skirt", shortest(*request.skirt_base) + " is above the lowest height, " + shortest(lowest));
  }
  return request.skirt_base;
}

/// A mesh of a file is an object in space, and keeps its shape, if its sides differ by no more than this factor. Other
/// meshes are plots of different quantities.
constexpr double kMostUnlikeMesh = 16;

/// A single surface z = f(x, y) can not penetrate itself.
bool may_cross(const SurfaceRequest& request, const std::vector<Surface>& given) {
  return given.size() > 1 || !request.parametric.empty() || (!given.empty() && given.front().mesh);
}

bool keeps_shape(const SurfaceRequest& request, const std::vector<SurfacePoints>& surfaces, const AxesBox& box) {
  if (!request.parametric.empty()) return true;
  // Heights over degrees are not lengths in space.
  const auto may_keep = [](const SurfacePoints& s) { return s.parametric && s.unit != GroundUnit::degrees; };
  if (std::none_of(surfaces.begin(), surfaces.end(), may_keep)) return false;
  const Point3 size = box.high - box.low;
  return std::max({size.x, size.y, size.z}) <= kMostUnlikeMesh * std::min({size.x, size.y, size.z});
}

/// The first known ground holds for all surfaces.
GroundUnit unit_of(const std::vector<SurfacePoints>& surfaces) {
  for (const SurfacePoints& surface : surfaces) {
    if (surface.unit != GroundUnit::unknown) return surface.unit;
  }
  return GroundUnit::unknown;
}

/// Bounding box of all surfaces; empty without surfaces. For z = f(x, y) it includes the ground of all samples, also of
/// those without a height.
std::optional<AxesBox> box_of(const std::vector<SurfacePoints>& surfaces, const std::vector<SurfaceMesh>& meshes) {
  const auto range = height_range(meshes);
  if (!range) return std::nullopt;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  AxesBox box{{kInfinity, kInfinity, (*range)[0]}, {-kInfinity, -kInfinity, (*range)[1]}};
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

/// The surface of a formula ends where the formula ends, not at the last sample.
SurfaceMesh mesh_of_formula(const SurfaceRequest& request, const SurfacePoints& surface, RunReport& run) {
  HeightWindow window;
  if (request.z_range) window = {(*request.z_range)[0], (*request.z_range)[1]};
  const std::unique_ptr<HeightSource> heights = heights_of(surface);
  const Irregularity found = find_irregularity(*heights, *surface.function, window);
  if (found.empty) refuse_empty(request, surface.name, run);
  if (!found.breaks) return make_surface_mesh(surface);
  if (found.poles && !request.z_range && request.log_axes[2]) {
    window = window_of_samples(*heights);  // logarithms are unbounded for heights near zero
  } else if (found.poles && !request.z_range) {
    window = window_without_poles(*heights);
    run.warn(printable(surface.name) + " has poles: cut to " + short_number(window.low) + ":" + short_number(window.high) +
             "; --z-range A:B cuts elsewhere");
  }
  return make_cut_mesh(surface, *heights, window);
}

struct MeshPlot {
  Scene scene;
  std::optional<PlotBox> box;
  bool reaches_out = false;  ///< curves or points lie outside the box of the surfaces
  std::shared_ptr<LineGroups> groups;
  std::vector<LegendEntry> legend;
  std::shared_ptr<const SurfaceCurves> iso;  ///< if hatching follows the iso-curves
};

std::vector<SurfaceMesh> meshes_of(const SurfaceRequest& request, const std::vector<SurfacePoints>& surfaces,
                                   RunReport& run) {
  std::vector<SurfaceMesh> meshes;
  for (const SurfacePoints& surface : surfaces) {
    if (surface.function) {
      meshes.push_back(mesh_of_formula(request, surface, run));
      continue;
    }
    meshes.push_back(make_surface_mesh(surface));
    if (request.z_range) clip_heights(meshes.back(), (*request.z_range)[0], (*request.z_range)[1]);
  }
  return meshes;
}

/// Placement of the picture on the page before the scene exists.
PictureMarks place_box(const SurfaceRequest& request, const PlotBox& box) {
  const PictureRequest& picture = request.picture;
  const Scene extent = box_scene(box.in_model());
  return place_with_axes(box, picture_of(view_of(request), picture.page, extent), picture.page, picture.axes,
                         picture.output.title);
}

/// Range of the drawn samples in the units of the axes. Apart from borders between samples, the meshes will have the
/// same range.
std::optional<AxesBox> box_of_samples(const SurfaceRequest& request, const std::vector<SurfacePoints>& surfaces,
                                      const std::vector<std::optional<double>>& water) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const std::array<double, 2> window = request.z_range.value_or(std::array{-kInfinity, kInfinity});
  AxesBox box{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
  for (std::size_t k = 0; k < surfaces.size(); ++k) {
    for (const Point3& p : surfaces[k].points) {
      if (!std::isfinite(p.x + p.y + p.z)) continue;
      const Point3 cut{p.x, p.y, std::clamp(std::max(p.z, water[k].value_or(p.z)), window[0], window[1])};
      box.low = glm::min(box.low, cut);
      box.high = glm::max(box.high, cut);
    }
  }
  if (!(box.low.z <= box.high.z)) return std::nullopt;
  if (const auto base = base_of(request, std::array{box.low.z, box.high.z})) box.low.z = std::min(box.low.z, *base);
  return box;
}

/// Thins the curves of fine grids. Call it before the meshes are made, since they mark the edges that are curves.
void thin_curves(const SurfaceRequest& request, const std::vector<Surface>& given,
                 const std::vector<std::optional<double>>& water, std::vector<SurfacePoints>& surfaces, RunReport& run) {
  if (std::none_of(given.begin(), given.end(), [](const Surface& s) { return s.thinned; })) return;
  const std::optional<AxesBox> samples = box_of_samples(request, surfaces, water);
  if (!samples) return;
  RunReport choices;  // reported after the meshes are made
  const GroundUnit unit = unit_of(surfaces);
  const PlotBox box{*samples, plot_factor(request, *samples, unit, keeps_shape(request, surfaces, *samples), choices),
                    tick_scales(request), unit};
  const AxesBox drawn = box.in_model();
  const PictureMarks around = place_box(request, box);
  for (std::size_t k = 0; k < given.size(); ++k) {
    SurfacePoints& points = surfaces[k];
    if (!given[k].thinned || points.columns < 2 || points.rows < 2) continue;
    AxesBox ground = drawn;
    for (int axis = 0; axis < 2; ++axis) {
      ground.low[axis] = points.points.front()[axis] * box.factor[axis];
      ground.high[axis] = points.points.back()[axis] * box.factor[axis];
    }
    const Strides strides = strides_apart({ground, points.columns, points.rows, points.x_stride > 0, points.y_stride > 0},
                                          around.placement.view, request.picture.page.pen_width_mm);
    set_strides(strides, points, run);
  }
}

/// Water level by surface.
struct Water {
  std::vector<std::optional<double>> levels;
  std::vector<WaterTriangles> triangles;
};

/// Lines in layers of their own; null if there are none.
std::shared_ptr<LineGroups> groups_of(const SurfaceRequest& request, const std::vector<SurfaceMesh>& meshes,
                                      const Water& water, const std::vector<double>& contours, const DrawnCurves& curves,
                                      const PlotBox& box) {
  const TerrainRequest& terrain = request.terrain;
  const bool any_curves = !curves.curves.empty() || !curves.points.empty();
  if (!terrain.has_water() && terrain.hachures == HachureKind::none && !names_heights(request.curves) && !any_curves &&
      !request.bands && request.colors.empty()) {
    return nullptr;
  }
  auto groups = std::make_shared<LineGroups>();
  if (terrain.hachures != HachureKind::none || terrain.water_fill == WaterFill::hatch) {
    add_terrain_lines(request, meshes, water.triangles, box.factor, place_box(request, box).placement.view, *groups);
  }
  add_curves(curves, box.factor, *groups);
  add_contour_groups(request, contours, water.levels, box.factor.z, *groups);
  return groups;
}

/// Cuts the meshes along the limits of bands and returns the limits. The cuts are not drawn. If all surfaces have
/// water, bands begin at its level.
std::vector<double> cut_bands(const SurfaceRequest& request, const std::vector<std::optional<double>>& water,
                              std::vector<SurfaceMesh>& meshes) {
  auto range = height_range(meshes);
  if (!range || !request.bands) return {};
  const bool all_in_water = std::all_of(water.begin(), water.end(), [](const auto& level) { return level.has_value(); });
  if (all_in_water) (*range)[0] = std::max((*range)[0], **std::min_element(water.begin(), water.end()));
  std::vector<double> limits = band_limits(request, (*range)[0], (*range)[1]);
  for (SurfaceMesh& mesh : meshes) {
    cut_contours(mesh, limits);
    for (auto& flags : mesh.flags) {
      for (std::uint8_t& flag : flags) flag = static_cast<std::uint8_t>(flag & ~kCornerContour);
    }
  }
  return limits;
}

/// Per surface, the end of its faces, including its walls, in the scene.
std::vector<std::uint32_t> face_ends(const std::vector<SurfaceMesh>& meshes, bool walls, const Scene& scene) {
  std::vector<std::uint32_t> ends;
  std::size_t object = 0;
  std::uint32_t end = 0;
  for (const SurfaceMesh& mesh : meshes) {
    // A scene has no objects without faces.
    const auto is_of = [&](const Object& o) {
      return o.name == mesh.name || (walls && o.name.starts_with(mesh.name + ", "));
    };
    while (object < scene.objects.size() && is_of(scene.objects[object])) end = scene.objects[object++].face_end;
    ends.push_back(end);
  }
  return ends;
}

/// `with_lines`: cut along the contour lines, with the crossings marked.
MeshPlot make_meshes(const SurfaceRequest& request, const std::vector<Surface>& given, bool with_lines, RunReport& run) {
  std::vector<SurfacePoints> surfaces = points_of(request, given);
  Water water{water_levels(request, surfaces), {}};
  if (with_lines) thin_curves(request, given, water.levels, surfaces, run);
  std::vector<SurfaceMesh> meshes = meshes_of(request, surfaces, run);
  DrawnCurves curves = with_lines ? curves_of(request, surfaces, run) : DrawnCurves{};
  const std::vector<double> limits = with_lines ? cut_bands(request, water.levels, meshes) : std::vector<double>{};
  water.triangles = flood_all(meshes, water.levels);
  MeshPlot plot;
  Point3 factor{1, 1, 1};
  const std::optional<double> base = base_of(request, height_range(meshes));
  if (auto box = box_of(surfaces, meshes)) {
    const GroundUnit unit = unit_of(surfaces);
    factor = plot_factor(request, *box, unit, keeps_shape(request, surfaces, *box), run);
    if (base) box->low.z = std::min(box->low.z, *base);
    plot.reaches_out = fit_to_box(request, curves, *box, run);
    plot.box = PlotBox{*box, factor, tick_scales(request), unit};
  }
  if (const auto range = height_range(meshes); range && with_lines) {
    const std::vector<double> levels = levels_in_heights(request.curves, (*range)[0], (*range)[1], request.log_axes[2], run);
    if (plot.box) plot.groups = groups_of(request, meshes, water, levels, curves, *plot.box);
    for (SurfaceMesh& mesh : meshes) cut_contours(mesh, levels);
  }
  if (request.picture.hatch.direction.form == FormLines::iso)
    plot.iso = std::make_shared<SurfaceCurves>(surface_curves(surfaces, factor));
  plot.scene = surface_scene(meshes, factor, base);
  std::vector<std::string> names;
  names.reserve(surfaces.size());
  for (const SurfacePoints& surface : surfaces) names.push_back(surface.name);
  const std::vector<std::uint32_t> ends = face_ends(meshes, base.has_value(), plot.scene);
  std::vector<ColoredSurface> colored;
  colored.reserve(names.size());
  for (std::size_t k = 0; k < names.size(); ++k) colored.push_back({names[k], ends[k], water.levels[k]});
  color_faces(request, limits, factor.z, colored, plot.scene);
  if (plot.groups) add_surface_groups(request, limits, factor.z, ends, *plot.groups);
  plot.legend = legend_of(request, names, limits);
  Scene& scene = plot.scene;
  if (may_cross(request, given) && with_lines) {
    double precision = 0;
    for (const Object& object : scene.objects) precision = std::max(precision, object.precision);
    mark_crossing_edges(scene, precision);
  }
  return plot;
}

LineClasses classes_of(const SurfaceRequest& request, const std::vector<Surface>& surfaces) {
  LineClasses classes;
  for (const LineClass c : {LineClass::horizon, LineClass::contour}) classes.add(c);
  if (request.curves.outline.value_or(true)) {
    for (const LineClass c : {LineClass::outline, LineClass::border}) classes.add(c);
  }
  if (may_cross(request, surfaces)) classes.add(LineClass::intersection);
  return classes;
}

/// Extent of the surfaces with their curves and points on the drawing plane; in perspective, extent of the box.
Rect extent_with_curves(const MeshPlot& plot, const Camera& camera) {
  if (camera.perspective) return projected_extent(box_scene(plot.box->in_model()), camera);
  Rect extent = projected_extent(plot.scene, camera);
  const auto extend = [&](const Point3& p) {
    const Point3 c = camera_coordinates(camera, p);
    extent.extend({c.x, c.y});
  };
  for (const SpaceLine& line : plot.groups->lines) {
    for (const Point3& p : line.ends) extend(p);
  }
  for (const MarkedPoint& point : plot.groups->points) extend(point.at);
  return extent;
}

}  // namespace

SurfaceScene make_surface_scene(const SurfaceRequest& request, const std::vector<Surface>& surfaces, RunReport& run) {
  MeshPlot plot = timed(run.stages, "mesh", [&] { return make_meshes(request, surfaces, true, run); });
  PictureRequest picture = request.picture;
  picture.view = view_of(request);
  picture.lines.classes = classes_of(request, surfaces);
  picture.lines.crease_degrees = kCrease;
  picture.lines.quality = Quality::exact;  // the mesh is made here and needs no repair
  if (picture.output.format != OutputFormat::json) picture.heading = picture.output.title;
  picture.groups = plot.groups;
  picture.iso = plot.iso;
  picture.axes.legend = plot.legend;
  picture.contour_labels = request.curves.labels;
  picture.label_decades = request.log_axes[2];
  if (plot.reaches_out && !picture.axes.style) {
    picture.page.extent = extent_with_curves(plot, camera_of(picture.view, plot.scene));
  }
  return {std::move(plot.scene), plot.box, std::move(picture)};
}

Picture draw_surface_mesh(const SurfaceRequest& request, const std::vector<Surface>& surfaces, RunReport& run) {
  const SurfaceScene surface = make_surface_scene(request, surfaces, run);
  return draw_scene(surface.scene, surface.picture, run, surface.box);
}

Scene surface_objects(SurfaceRequest request, const std::array<Point3, 2>& ground, RunReport& run) {
  if (request.grids.empty() && height_count(request) > 0) {
    if (!request.x) request.x = CurveRange{ground[0].x, ground[1].x, {}};
    if (!request.y) request.y = CurveRange{ground[0].y, ground[1].y, {}};
  }
  std::vector<Surface> surfaces = surfaces_of(request, run);
  for (Surface& surface : surfaces) {
    if (!surface.thinned) continue;
    const std::size_t samples = std::max(surface.heights->x().size(), surface.heights->y().size());
    if (surface.x_stride > 0) surface.x_stride = samples / kCurvesAmongModels + 1;
    if (surface.y_stride > 0) surface.y_stride = samples / kCurvesAmongModels + 1;
  }
  const std::vector<SurfacePoints> points = points_of(request, surfaces);
  const std::vector<SurfaceMesh> meshes = meshes_of(request, points, run);
  return surface_scene(meshes, {1, 1, request.z_scale.value_or(1)}, base_of(request, height_range(meshes)));
}

MeshFormat mesh_format_of_suffix(const std::string& file) {
  const std::string suffix = lower_case(std::filesystem::path(file).extension().string());
  if (suffix == ".json") return MeshFormat::ligne_scene;
  if (suffix == ".obj") return MeshFormat::obj;
  throw std::invalid_argument(printable(file, kLongestPath) + " does not end in .json or .obj, which --as-mesh writes");
}

std::string write_surface_mesh(const SurfaceRequest& request, MeshFormat format, RunReport& run) {
  const MeshPlot plot =
      timed(run.stages, "read", [&] { return make_meshes(request, surfaces_of(request, run), false, run); });
  if (plot.scene.faces.empty()) {
    throw InputError(place_of_warnings(request), "has no cell without a hole: there is no mesh to write");
  }
  return timed(run.stages, "write",
               [&] { return format == MeshFormat::obj ? write_obj(plot.scene) : write_ligne_scene(plot.scene); });
}

}  // namespace ligne
