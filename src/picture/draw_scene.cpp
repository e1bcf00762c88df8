#include "picture/draw_scene.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>
#include <vector>

#include "picture/errors.hpp"
#include "picture/fills.hpp"
#include "picture/gray_faces.hpp"
#include "picture/hatching.hpp"
#include "picture/hidden_pieces.hpp"
#include "picture/parts.hpp"
#include "plotting/writers.hpp"
#include "scene/clean/named_objects.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

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

/// Pieces of faces from the back to the front.
std::vector<Fill> paint(const PreparedScene& prepared, const PaintOrder& order, RunReport& run) {
  const Scene& scene = prepared.scene;
  PaintOrder seen = order;
  const std::size_t hidden = drop_hidden_pieces(seen, prepared.around.placement.page.sheet(),
                                                [&](std::uint32_t face) { return material_of(scene, face).opacity >= 1; });
  run.study.count("pieces painted", seen.pieces.size());
  run.study.count("pieces not painted, since they are hidden", hidden);
  return fill_pieces(scene, prepared.view(), seen, prepared.lights, prepared.request.fill.kind);
}

/// The lines of a study, with hatching, fills and what stands round the picture.
Drawing compose(const PreparedScene& prepared, const SceneStudy& study, std::vector<Layer> hatching, RunReport& run) {
  const PictureRequest& request = prepared.request;
  const VisibilityResult& result = study.result;
  Drawing drawing = tells_parts(request) ? drawing_by_parts(study, prepared.scene, request) : make_drawing(*result.strokes);
  add_debug_layer(drawing, result.debug);
  add_surroundings(drawing, prepared.around, request.axes, run);
  add_hatching(drawing, std::move(hatching));
  if (result.regions && request.fill.kind != FillKind::none) {
    drawing.fills = fill_regions(prepared.scene, prepared.view(), *result.regions, prepared.lights, request.fill.kind);
  } else if (result.order && paints_in_order(request, prepared.method)) {
    drawing.fills = paint(prepared, *result.order, run);
  }
  return drawing;
}

/// The option that asks for regions.
const char* field_of_regions(const FillRequest& fill) {
  return !fill.lights.empty() ? "light" : fill.kind != FillKind::none ? "fill" : "edges";
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
  const ObjectOfFace object_of(prepared.scene);
  if (prepared.request.output.group_objects) {
    document.objects = object_names(prepared.scene);
    document.object = [&](std::uint32_t source) { return object_of(study.source(prepared.scene, source).faces[0]); };
  }
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
  if (wants_regions(request, method) && !(method.traits().products & kRegions)) {
    throw RequestError(field_of_regions(request.fill), "needs a method that gives regions: " + methods_with(kRegions));
  }
  if (!request.output.colors.empty()) {
    if (request.output.format == OutputFormat::json) throw RequestError("color", "a JSON drawing has no colours");
    if (request.plotter.by_pens()) throw RequestError("color", "pens have colours of their own: --pen object:NAME=N,COLOUR");
  }
  check(request.page);
  if (request.output.format == OutputFormat::png) check_png(request.page.size.page, request.output.dpi, request.memory);
}

Picture draw_scene(const Scene& scene, const PictureRequest& request, RunReport& run, const std::optional<PlotBox>& box,
                   std::optional<Topology> topology, PdfDocument* pages) {
  check(request);
  const bool json = request.output.format == OutputFormat::json;
  PreparedScene prepared = prepare(scene, request, box, run, std::move(topology));
  const PlotOptions plot = plot_options(request, prepared.around.placement.page);
  const HatchScene hatch = hatch_scene(prepared, plot);
  std::vector<Layer> hatching = hatch_spans(hatch, run);

  // Only JSON and parts look at the source edges; the study needs the memory of the rest.
  const bool keep_edges = json || tells_parts(request);
  const SceneStudy found = study(prepared, gray_face_lines(request, plot), keep_edges, run);
  if (found.result.regions) {
    std::ranges::move(hatch_regions(hatch, *found.result.regions, run), std::back_inserter(hatching));
  }

  return timed(run.stages, {"write", std::to_string(found.result.strokes->strokes.size()) + " strokes"}, [&] {
    if (json) return Picture{json_of(prepared, found, plot)};
    const Drawing drawing = compose(prepared, found, std::move(hatching), run);
    const std::optional<GrayPicture> faces = gray_faces(prepared, found.result, plot);
    return write_picture(drawing, plot, request.plotter, request.output.format, run, faces ? &*faces : nullptr, pages);
  });
}

}  // namespace ligne
