#include "picture/surface/surface_picture.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "picture/errors.hpp"
#include "picture/marks/axes.hpp"
#include "picture/surface/surface_mesh_picture.hpp"
#include "picture/surface/surface_scale.hpp"
#include "picture/surface/surface_terrain.hpp"
#include "plotting/writers/writers.hpp"
#include "scene/surfaces/contours/cut_cells.hpp"
#include "scene/surfaces/height_filters.hpp"
#include "scene/surfaces/surface_points.hpp"
#include "visibility/horizon/horizon.hpp"

namespace ligne {
namespace {

AxesBox box_of(const HeightSource& heights, const HeightSurvey& found) {
  return {{heights.x().front(), heights.y().front(), found.low}, {heights.x().back(), heights.y().back(), found.high}};
}

/// Adds the ground rectangle at a height.
void add_rectangle(Scene& scene, const HeightSource& heights, double z) {
  const auto first = static_cast<std::uint32_t>(scene.vertices.size());
  for (const double y : {heights.y().front(), heights.y().back()}) {
    for (const double x : {heights.x().front(), heights.x().back()}) scene.vertices.push_back({x, y, z});
  }
  scene.faces.add_triangle(first, first + 1, first + 2);
  scene.faces.add_triangle(first + 1, first + 3, first + 2);
}

/// The parts of a surface that the horizon draws, and their placement.
struct HorizonRequest {
  HorizonOptions options;
  Camera camera;
  Scene extent;                ///< geometry that must fit the page
  std::optional<PlotBox> box;  ///< the box that the axes measure
};

/// Height of a ridgeline plot as a fraction of its width. The elevation of its view shows it as high as its rows are
/// lifted.
constexpr double kRidgelineHeight = 1.2;
const Point3 kRidgelineElevation{0, 1, -1};

/// Converts the heights to those of a ridgeline plot if one is requested.
HorizonRequest horizon_request(const SurfaceRequest& surfaces, Surface& surface, RunReport& run) {
  HorizonRequest request;
  HorizonOptions& horizon = request.options;
  horizon.x_stride = surface.x_stride;
  horizon.y_stride = surface.y_stride;
  if (surfaces.pixel_columns) horizon.resolution = *surfaces.pixel_columns;
  horizon.underside = surfaces.curves.underside;
  horizon.hidden_by = surfaces.curves.hidden_by;
  horizon.outline = surfaces.curves.outline.value_or(horizon.hidden_by == HiddenBy::surface);

  HeightSurvey found = surface.survey.empty() ? survey(*surface.heights) : surface.survey;
  if (found.empty() && surface.from_formula) refuse_empty(surfaces, surface.name, run);
  horizon.holes = found.holes || !surface.left_out.empty();
  if (!surface.left_out.empty()) horizon.left_out = &surface.left_out;
  ViewRequest view = view_of(surfaces);
  Point3 factor{1, 1, 1};
  if (surfaces.curves.ridgeline && surfaces.terrain.water) {
    surface.heights = land_heights(std::move(surface.heights), *surfaces.terrain.water);
    found.low = std::max(found.low, *surfaces.terrain.water);
    found.high = std::max(found.high, found.low);
  }
  if (surfaces.curves.ridgeline) {
    const double rows = surfaces.curves.ridgeline_overlap * static_cast<double>(std::max<std::size_t>(surface.y_stride, 1));
    const AxesScaling scaling = ridgeline_scaling(*surface.heights, found.low, found.high, rows, kRidgelineHeight);
    if (!found.empty())
      request.box =
          PlotBox{box_of(*surface.heights, found), scaling.factor, tick_scales(surfaces), surface.unit, scaling.origin};
    surface.heights = scaled_heights(std::move(surface.heights), scaling);
    found = survey(*surface.heights);
    view.direction = kRidgelineElevation;
    horizon.hidden_by = HiddenBy::curves;
    horizon.underside = Underside::none;
    horizon.outline = false;
  } else if (!found.empty()) {
    factor = plot_factor(surfaces, box_of(*surface.heights, found), surface.unit, false, run);
    horizon.z_scale = factor.z;
  }
  if (!found.empty() && !request.box)
    request.box = PlotBox{box_of(*surface.heights, found), factor, tick_scales(surfaces), surface.unit};
  surface.heights = scaled_ground(std::move(surface.heights), factor.x, factor.y);

  const HeightSource& heights = *surface.heights;
  request.camera = camera_of(view, box_of(heights, found, horizon.z_scale));
  request.extent = extent_scene(heights, horizon.z_scale, request.camera);
  if (found.empty()) return request;
  horizon.contours = levels_in_heights(surfaces.curves, found.low, found.high, surfaces.log_axes[2], run);
  horizon.contours_on_surface = surfaces.curves.contours || surfaces.curves.contour_step;
  if (surfaces.curves.contours_base) {
    horizon.contour_base = contour_base_of(surfaces.curves, found.low, found.high);
    add_rectangle(request.extent, heights, *horizon.contour_base * horizon.z_scale);
    request.box->box.low.z = std::min(found.low, *horizon.contour_base);
    request.box->box.high.z = std::max(found.high, *horizon.contour_base);
  }
  return request;
}

/// Rows of a ridgeline plot hide the lines of its axes. They do not hide the frame, that is the sides of the box and
/// its front edge on the ground, because no row crosses it. Lines in front of the rows would cross them and are
/// omitted.
void frame_ridgelines(const AxesBox& box, AxesPicture& axes) {
  const auto is_frame = [&](const AxisLine& line) {
    const auto both = [&](int k, double at) { return line.a[k] == at && line.b[k] == at; };
    return both(0, box.low.x) || both(0, box.high.x) || (both(1, box.low.y) && both(2, box.low.z));
  };
  std::erase_if(axes.front_lines, [&](const AxisLine& line) { return !is_frame(line); });
  std::copy_if(axes.lines.begin(), axes.lines.end(), std::back_inserter(axes.front_lines), is_frame);
  std::erase_if(axes.lines, is_frame);
}

/// Returns the visible parts of the lines of the axes.
Polylines axes_of(const HorizonLines& lines, const PictureMarks& around) {
  std::vector<std::vector<VisibleInterval>> seen(lines.back_lines.size());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    for (const horizon::Span& span : lines.back_lines[i]) seen[i].push_back({span.from, span.to});
  }
  return lines_of_axes(around, seen);
}

/// Layers of contour lines, one per height if heights are distinguished.
void add_contours(Drawing& drawing, const SurfaceRequest& request, const std::vector<double>& heights,
                  const Polylines& lines, const std::vector<std::uint32_t>& levels, bool index) {
  for (std::size_t i = 0, end = 0; i < lines.size(); i = end) {
    const LineGroup group = contour_group(request.curves, heights[levels[i]], levels[i]);
    if ((group.layer == "contour-index") != index) {
      while (end < lines.size() && (end <= i || levels[end] == levels[i])) ++end;
      continue;
    }
    Layer layer{group.layer, {}};
    layer.height = group.height;
    for (end = i; end < lines.size() && levels[end] == levels[i]; ++end) layer.lines.add(lines[end]);
    drawing.layers.push_back(std::move(layer));
  }
}

Drawing drawing_of(HorizonLines& lines, const SurfaceRequest& request, const std::vector<double>& heights) {
  Drawing drawing;
  const auto add = [&](const char* layer, Polylines& polylines) {
    if (polylines.size() > 0) drawing.layers.push_back({layer, std::move(polylines)});
  };
  add("contour-base", lines.base_contours);
  add("underside", lines.underside);
  add("horizon", lines.curves);
  if (names_heights(request.curves)) {
    for (const bool index : {false, true})
      add_contours(drawing, request, heights, lines.contours, lines.contour_levels, index);
  } else {
    add("contour", lines.contours);
  }
  add("border", lines.border);
  add("outline", lines.outline);
  return drawing;
}

void warn_of_empty_or_cut(const Drawing& drawing, const Placement& placement, RunReport& run) {
  if (drawing.layers.empty()) {
    run.warn("nothing to draw is in view: the drawing is empty");
  } else if (placement.larger_than_page()) {
    run.warn("the picture is larger than the page, and is clipped");
  }
}

/// Thins the curves of a fine grid.
void thin_curves(const Surface& surface, HorizonRequest& horizon, const View& view, double pen_width_mm, RunReport& run) {
  HorizonOptions& options = horizon.options;
  const Strides strides = strides_apart({horizon.box->in_model(), surface.heights->x().size(), surface.heights->y().size(),
                                         options.x_stride > 0, options.y_stride > 0},
                                        view, pen_width_mm);
  set_strides(strides, options, run);
}

/// Whether the surface of a formula ends or jumps somewhere and may be drawn as a mesh, which can be cut there.
/// Otherwise whole cells are omitted.
bool is_for_mesh(const SurfaceRequest& request, Surface& surface) {
  const std::size_t columns = surface.heights->x().size(), rows = surface.heights->y().size();
  if (!surface.function || columns > kMostMeshSamples / rows) return false;
  const Irregularity found = find_irregularity(*surface.heights, *surface.function);
  if (!found.empty) surface.survey = {found.span.low, found.span.high, !found.span.all};
  if (!found.breaks) return false;
  if (needs_horizon(request).empty() && !request.horizon) return true;
  surface.left_out = broken_cells(*surface.heights, *surface.function);
  return false;
}

}  // namespace

std::optional<HorizonDrawing> draw_horizon(const SurfaceRequest& request, std::vector<Surface>& surfaces, RunReport& run) {
  PictureRequest picture = request.picture;
  picture.lines.quality = Quality::exact;  // the curves are made here and need no repair
  run.method = "horizon";
  Surface& surface = surfaces.front();
  if (timed(run.stages, "breaks", [&] { return is_for_mesh(request, surface); })) return std::nullopt;
  HorizonRequest horizon;
  PictureMarks around;
  const std::string samples =
      std::to_string(surface.heights->x().size()) + " x " + std::to_string(surface.heights->y().size()) + " samples";
  timed(run.stages, {"place", samples}, [&] {
    horizon = horizon_request(request, surface, run);
    const Rect extent = picture.page.extent.value_or(projected_extent(horizon.extent, horizon.camera));
    around = place_with_axes(horizon.box, {horizon.camera, extent, horizon.extent.unit_mm}, picture.page, picture.axes,
                             picture.output.title);
    if (surface.thinned && horizon.box) thin_curves(surface, horizon, around.placement.view, picture.page.pen_width_mm, run);
    if (request.curves.ridgeline && horizon.box) frame_ridgelines(horizon.box->in_model(), around.axes);
    horizon.options.back_lines = back_lines(around);
    horizon.options.progress = picture.progress;
  });
  HorizonLines lines;
  timed(run.stages, {"study", samples},
        [&] { lines = horizon_lines(*surface.heights, around.placement.view, horizon.options, run.study); });
  Drawing drawing = drawing_of(lines, request, horizon.options.contours);
  picture.contour_labels = request.curves.labels;
  picture.label_decades = request.log_axes[2];
  warn_of_empty_or_cut(drawing, around.placement, run);
  if (Polylines axes = axes_of(lines, around); axes.size() > 0) drawing.layers.push_back({"axes", std::move(axes)});
  add_labels(drawing, picture, around);
  add_surroundings(drawing, around, picture.axes, run);
  return HorizonDrawing{std::move(drawing), around.placement.page, std::move(picture)};
}

Picture write_horizon(const HorizonDrawing& drawn, RunReport& run) {
  const PictureRequest& picture = drawn.picture;
  return timed(run.stages, "write", [&] {
    return write_picture(drawn.drawing, plot_options(picture, drawn.page), picture.plotter, {picture.output.format}, run);
  });
}

bool drawn_by_horizon(const SurfaceRequest& request, const std::vector<Surface>& surfaces) {
  if (!drawn_by_horizon(request)) return false;
  if (surfaces.size() == 1 && !surfaces.front().mesh) return true;
  const std::string option = needs_horizon(request);
  if (!option.empty()) {
    throw RequestError("", option + ": draws one surface z = f(x, y), and not " +
                               (surfaces.front().mesh ? "a mesh" : "several; --index N chooses one of a file"));
  }
  return false;
}

Picture draw_surface(const SurfaceRequest& request, RunReport& run) {
  std::vector<Surface> surfaces = timed(run.stages, "read", [&] { return surfaces_of(request, run); });
  if (drawn_by_horizon(request, surfaces)) {
    if (const std::optional<HorizonDrawing> drawn = draw_horizon(request, surfaces, run)) return write_horizon(*drawn, run);
  }
  return draw_surface_mesh(request, surfaces, run);
}

}  // namespace ligne
