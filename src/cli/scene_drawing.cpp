#include "cli/scene_drawing.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "cli/culling.hpp"
#include "cli/errors.hpp"
#include "cli/hatching.hpp"
#include "cli/models.hpp"
#include "cli/placement.hpp"
#include "cli/plotter_output.hpp"
#include "cli/progress.hpp"
#include "plotting/writers.hpp"
#include "scene/model/topology.hpp"
#include "view/projected_scene.hpp"
#include "visibility/atherton_weiler/details.hpp"
#include "visibility/atherton_weiler/shadows.hpp"
#include "visibility/tolerances.hpp"

namespace ligne {
namespace {

/// What the JSON drawing tells of an edge of the scene.
SourceEdge source_edge(const Scene& scene, const Edge& edge) {
  return {{scene.vertices[edge.v0], scene.vertices[edge.v1]}, {edge.face0, edge.face1}, false};
}

/// Layers by class and material: the material of a line is that of the first face of its source edge.
Drawing drawing_by_material(const StrokeModel& strokes, const std::function<SourceEdge(std::uint32_t)>& source,
                            const Scene& scene) {
  std::map<std::string, StrokeModel> by_material;
  for (const Stroke& stroke : strokes.strokes) {
    std::string name;
    if (stroke.line_class != LineClass::axes) {
      const std::uint32_t face = source(stroke.source).faces[0];
      const std::uint32_t material = face < scene.face_material.size() ? scene.face_material[face] : 0;
      if (material < scene.materials.size()) name = scene.materials[material].name;
    }
    StrokeModel& part = by_material[name];
    part.lattice = strokes.lattice;
    part.strokes.push_back(stroke);
  }
  Drawing drawing;
  for (const auto& [material, part] : by_material) {
    for (Layer& layer : make_drawing(part).layers) {
      layer.material = material;
      drawing.layers.push_back(std::move(layer));
    }
  }
  return drawing;
}

/// Where a method gives regions these are hatched, else its spans.
bool hatches_regions(const SceneDrawing& request) {
  return request.hatch.asked() && (request.method.traits().products & kRegions);
}

bool wants_regions(const SceneDrawing& request) {
  return request.fill.asked() || hatches_regions(request) || request.classes.has(LineClass::shadow);
}

/// The method's study, with the progress bar over it.
VisibilityResult study(const SceneDrawing& request, const ProjectedScene& projected, const PlotOptions& plot) {
  ProgressBar bar(request.run);
  StudyOptions study_options;
  study_options.hidden_strokes = request.hidden != HiddenLines::none;
  study_options.span_lines = span_lines(request.faces, plot);
  study_options.settings = request.settings;
  if (format_of(request.output) != OutputFormat::json) {  // all that is drawn
    study_options.wanted = kStrokes;
    if (request.faces.shade) study_options.wanted |= kSpans;
    if (wants_regions(request)) study_options.wanted |= kRegions;
  }
  if (bar.wanted()) study_options.progress = [&bar](double fraction) { bar.update(fraction); };
  return request.method.study(projected, study_options);
}

/// Below all lines.
void add_debug_layer(Drawing& drawing, const std::vector<std::vector<Point2>>& polylines) {
  Layer layer{"debug", {}};
  for (const std::vector<Point2>& line : polylines) {
    layer.lines.points.insert(layer.lines.points.end(), line.begin(), line.end());
    layer.lines.begin.push_back(static_cast<std::uint32_t>(layer.lines.points.size()));
  }
  drawing.layers.insert(drawing.layers.begin(), std::move(layer));
}

/// What surface hides of the axes is not drawn, also where hidden lines are.
void remove_hidden_axes(StrokeModel& model) {
  std::erase_if(model.strokes, [](const Stroke& stroke) { return stroke.line_class == LineClass::axes && !stroke.visible; });
}

/// The document as lines, with what stands round it.
Drawing drawing_of(const DrawingDocument& document, const Surroundings& around, const SceneDrawing& request,
                   const Scene& scene) {
  Drawing drawing = request.plotter.pens.pen_of_material.empty()
                        ? make_drawing(*document.strokes)
                        : drawing_by_material(*document.strokes, document.source, scene);
  if (document.debug) add_debug_layer(drawing, *document.debug);
  if (!request.frame) return drawing;
  const std::size_t unknown = add_surroundings(drawing, around, request.frame->axes);
  if (unknown > 0 && !request.run.quiet) {
    warn(request.place_of_warnings, std::to_string(unknown) + " characters are not in the font: drawn as boxes");
  }
  return drawing;
}

/// Below all lines.
void add_hatching(Drawing& drawing, std::vector<Layer> hatching) {
  drawing.layers.insert(drawing.layers.begin(), std::make_move_iterator(hatching.begin()),
                        std::make_move_iterator(hatching.end()));
}

/// Details and light on the regions of a study, and the lines of shadows.
void finish_regions(const Scene& scene, const SceneDrawing& request, const View& view, std::span<const Light> lights,
                    VisibilityResult& result) {
  if (wants_regions(request) && !result.regions) {
    const char* const option = request.fill.kind != FillKind::none ? "--fill" : request.fill.asked() ? "--light" : "--edges";
    throw UsageError(option, std::string(request.method.traits().name) + " does not produce regions; atherton-weiler does");
  }
  if (!result.regions) return;
  if (!scene.details.empty()) *result.regions = atherton_weiler::cut_details(scene, view, std::move(*result.regions));
  if (lights.empty()) return;
  atherton_weiler::CastShadows shadows =
      atherton_weiler::cast_shadows(scene, build_topology(scene), view, lights, *result.regions);
  *result.regions = std::move(shadows.regions);
  if (request.classes.has(LineClass::shadow))
    atherton_weiler::add_shadow_strokes(scene, view, shadows.borders, *result.strokes);
}

}  // namespace

void draw_scene(const Scene& scene, const SceneDrawing& request, RunFiles& files, RunReport& run) {
  run.method = request.method.traits().name;
  const OutputFormat format = format_of(request.output);
  Topology topology = timed(run.stages, "topology", [&] { return build_topology(scene); });

  Surroundings around;
  Placement& placement = around.placement;
  const ProjectedScene projected = timed(run.stages, "project", [&] {
    const Camera camera = camera_of(request.view, scene);
    if (request.frame) {
      around = place_with_axes(request.frame->box, scene, camera, request.page, request.frame->axes, request.title);
    } else {
      placement = place(scene, camera, request.page);
    }
    ProjectedScene all = project(scene, topology, placement.view, {request.classes, request.crease_degrees});
    if (request.cull) cull_back_faces(scene, topology, all, request.place_of_warnings, request.run.quiet);
    add_lines(all, all_lines(around), LineClass::axes);
    return all;
  });
  PlotOptions plot;
  plot.page = placement.page;
  plot.pen_width_mm = request.page.pen_width_mm;
  plot.hidden_solid = request.hidden == HiddenLines::solid;
  plot.title = request.title;
  plot.dpi = request.dpi;
  const bool cast = request.fill.kind == FillKind::shade || request.hatch.kind == HatchKind::shade ||
                    request.classes.has(LineClass::shadow);
  const std::vector<Light> lights = lights_of(request.fill, scene, cast);
  const HatchPatches patches =
      request.hatch.asked() ? hatch_patches(scene, topology, request.crease_degrees) : HatchPatches{};
  const HatchScene hatch{request.hatch, scene, placement.view, lights, patches, request.plotter.pens, plot};
  std::vector<Layer> hatching;
  if (request.hatch.asked() && !hatches_regions(request)) {
    timed(run.stages, "hatch",
          [&] { hatching = hatch_spans(hatch, topology, request.method, request.settings, request.cull); });
  }
  // Only the JSON drawing, and pens by material, ask for the source edges; the study needs the memory of the rest.
  const bool asked = format == OutputFormat::json || !request.plotter.pens.pen_of_material.empty();
  const std::vector<Edge> edges = asked ? std::move(topology.edges) : std::vector<Edge>{};
  topology = {};
  VisibilityResult result = timed(run.stages, "study", [&] { return study(request, projected, plot); });
  if (!result.strokes) throw UsageError("--method", std::string(request.method.traits().name) + " does not produce lines");
  StrokeModel& strokes = *result.strokes;
  remove_hidden_axes(strokes);
  if (lights.empty() && request.classes.has(LineClass::shadow)) {
    throw UsageError("--edges", "there is no light that casts a shadow: give --light, or lights in the scene");
  }
  if (wants_regions(request) || !scene.details.empty()) {
    timed(run.stages, "regions", [&] { finish_regions(scene, request, placement.view, lights, result); });
  }
  if (result.regions && hatches_regions(request)) {
    timed(run.stages, "hatch", [&] { hatching = hatch_regions(hatch, *result.regions); });
  }

  if (!request.run.quiet) {
    if (std::none_of(strokes.strokes.begin(), strokes.strokes.end(),
                     [](const Stroke& s) { return s.line_class != LineClass::axes; })) {
      warn(request.place_of_warnings, "nothing to draw is in view: the drawing is empty");
    } else if (placement.larger_than_page()) {
      warn(request.place_of_warnings, "the picture is larger than the page: what lies outside is left out");
    }
  }

  timed(run.stages, "drawing", [&] { remove_coincident_strokes(strokes, coincidence_mm(projected)); });
  std::string bytes = timed(run.stages, "write", [&] {
    DrawingDocument document;
    document.strokes = &strokes;
    document.regions = result.regions ? &*result.regions : nullptr;
    document.order = result.order ? &*result.order : nullptr;
    document.spans = result.spans ? &*result.spans : nullptr;
    document.debug = result.debug.empty() ? nullptr : &result.debug;
    document.source = [&](std::uint32_t source) {
      return source < strokes.edge_count ? source_edge(scene, edges.at(source))
                                         : strokes.intersections.at(source - strokes.edge_count);
    };
    document.model_to_page = placement.view.model_to_page;
    document.perspective = placement.view.camera.perspective;
    document.window = placement.view.window;
    document.near_distance = placement.view.near_distance;
    document.method = run.method;
    document.statistics = result.statistics;
    if (format == OutputFormat::json) return write_json(document, plot);
    std::optional<GrayPicture> gray;
    if (request.faces.shade && result.spans) gray = picture_faces(scene, placement.view.camera, *result.spans, plot);
    Drawing drawing = drawing_of(document, around, request, scene);
    add_hatching(drawing, std::move(hatching));
    if (result.regions && request.fill.kind != FillKind::none) {
      drawing.fills = fill_regions(scene, placement.view, *result.regions, lights, request.fill.kind);
    }
    return written(drawing, plot, request.plotter, format, files, run, gray ? &*gray : nullptr);
  });
  run.study = std::move(result.statistics);
  timed(run.stages, "output", [&] { files.write(*request.output.file, std::move(bytes)); });
  finish(request.run, run, files);
}

}  // namespace ligne
