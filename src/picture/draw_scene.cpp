#include "picture/draw_scene.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include "picture/errors.hpp"
#include "picture/fills.hpp"
#include "picture/gray_faces.hpp"
#include "picture/hatching.hpp"
#include "plotting/writers.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

/// Layers by class and material: the material of a line is that of the first face of its source edge.
Drawing drawing_by_material(const SceneStudy& study, const Scene& scene) {
  const StrokeModel& strokes = *study.result.strokes;
  std::map<std::string, StrokeModel> by_material;
  for (const Stroke& stroke : strokes.strokes) {
    std::string name;
    if (stroke.line_class != LineClass::axes) {
      const std::uint32_t face = study.source(scene, stroke.source).faces[0];
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

/// Polylines that show how the method worked, below all lines.
void add_debug_layer(Drawing& drawing, const std::vector<std::vector<Point2>>& polylines) {
  if (polylines.empty()) return;
  Layer layer{"debug", {}};
  for (const std::vector<Point2>& line : polylines) layer.lines.add(line);
  drawing.layers.insert(drawing.layers.begin(), std::move(layer));
}

/// Below all lines.
void add_hatching(Drawing& drawing, std::vector<Layer> hatching) {
  drawing.layers.insert(drawing.layers.begin(), std::make_move_iterator(hatching.begin()),
                        std::make_move_iterator(hatching.end()));
}

/// The lines of a study, with hatching, fills and what stands round the picture.
Drawing compose(const PreparedScene& prepared, const SceneStudy& study, std::vector<Layer> hatching, RunReport& run) {
  const PictureRequest& request = prepared.request;
  const VisibilityResult& result = study.result;
  Drawing drawing = request.plotter.pens.pen_of_material.empty() ? make_drawing(*result.strokes)
                                                                 : drawing_by_material(study, prepared.scene);
  add_debug_layer(drawing, result.debug);
  add_surroundings(drawing, prepared.around, request.axes, run);
  add_hatching(drawing, std::move(hatching));
  if (result.regions && request.fill.kind != FillKind::none) {
    drawing.fills = fill_regions(prepared.scene, prepared.view(), *result.regions, prepared.lights, request.fill.kind);
  }
  return drawing;
}

std::string json_of(const PreparedScene& prepared, const SceneStudy& study, const PlotOptions& plot) {
  const VisibilityResult& result = study.result;
  const View& view = prepared.view();
  DrawingDocument document;
  document.strokes = &*result.strokes;
  document.regions = result.regions ? &*result.regions : nullptr;
  document.order = result.order ? &*result.order : nullptr;
  document.spans = result.spans ? &*result.spans : nullptr;
  document.debug = result.debug.empty() ? nullptr : &result.debug;
  document.source = [&](std::uint32_t source) { return study.source(prepared.scene, source); };
  document.model_to_page = view.model_to_page;
  document.perspective = view.camera.perspective;
  document.window = view.window;
  document.near_distance = view.near_distance;
  document.method = prepared.method.traits().name;
  document.statistics = result.statistics;
  return write_json(document, plot);
}

}  // namespace

void check(const PictureRequest& request) {
  const Method& method = method_of(request);
  if (request.gray_faces) {
    if (request.output.format != OutputFormat::png) throw RequestError("shade", "gray faces are for PNG; see --hatch");
    if (!(method.traits().products & (kSpans | kPixels))) {
      throw RequestError("shade", "needs a method that gives spans or pixels: " + methods_with(kSpans | kPixels));
    }
  }
  if (request.hatch.asked()) {
    if (request.output.format == OutputFormat::json) throw RequestError("hatch", "a JSON drawing has no hatching");
    if (!(method.traits().products & (kRegions | kSpans))) refuse_hatching(method.traits().name);
    if (request.gray_faces) throw RequestError("hatch", "does not go together with --shade");
  }
  check(request.page);
  if (request.output.format == OutputFormat::png) check_png(request.page.size.page, request.output.dpi, request.memory);
}

Picture draw_scene(const Scene& scene, const PictureRequest& request, RunReport& run, const std::optional<PlotBox>& box,
                   std::optional<Topology> topology) {
  check(request);
  const bool json = request.output.format == OutputFormat::json;
  PreparedScene prepared = prepare(scene, request, box, run, std::move(topology));
  const PlotOptions plot = plot_options(request, prepared.around.placement.page);
  const HatchScene hatch = hatch_scene(prepared, plot);
  std::vector<Layer> hatching = hatch_spans(hatch, run);

  // Only JSON and pens by material look at the source edges; the study needs the memory of the rest.
  const bool keep_edges = json || !request.plotter.pens.pen_of_material.empty();
  const SceneStudy found = study(prepared, gray_face_lines(request, plot), keep_edges, run);
  if (found.result.regions) {
    std::ranges::move(hatch_regions(hatch, *found.result.regions, run), std::back_inserter(hatching));
  }

  return timed(run.stages, {"write", std::to_string(found.result.strokes->strokes.size()) + " strokes"}, [&] {
    if (json) return Picture{json_of(prepared, found, plot)};
    const Drawing drawing = compose(prepared, found, std::move(hatching), run);
    const std::optional<GrayPicture> faces = gray_faces(prepared, found.result, plot);
    return write_picture(drawing, plot, request.plotter, request.output.format, run, faces ? &*faces : nullptr);
  });
}

}  // namespace ligne
