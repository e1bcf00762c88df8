#include "picture/drawn_scene.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "picture/draw_scene.hpp"
#include "picture/fills.hpp"
#include "picture/hatching/gray_faces.hpp"
#include "picture/hatching/hatching.hpp"
#include "picture/hidden_pieces.hpp"
#include "picture/light/seen_through.hpp"
#include "picture/line_groups.hpp"
#include "picture/marks/contour_labels.hpp"
#include "picture/marks/point_marks.hpp"
#include "picture/parts.hpp"
#include "plotting/stroke_text.hpp"
#include "plotting/writers.hpp"
#include "scene/clean/named_objects.hpp"
#include "view/brightness.hpp"

namespace ligne {
namespace {

/// Polylines that show how the method worked, below all lines.
void add_debug_layer(Drawing& drawing, const std::vector<std::vector<Point2>>& polylines) {
  if (polylines.empty()) return;
  Layer layer{"debug", {}};
  for (const std::vector<Point2>& line : polylines) layer.lines.add(line);
  drawing.layers.insert(drawing.layers.begin(), std::move(layer));
}

/// Numbers that show how the method worked as polylines, like the rest of that.
void write_debug_numbers(VisibilityResult& result, const PictureRequest& request, const Page& page) {
  if (result.debug_numbers.empty()) return;
  const double height_mm = text_height_mm(request.axes, page);
  for (const PageNumber& n : result.debug_numbers) {
    Polylines lines;
    append_stroke_text({std::to_string(n.number), n.middle, height_mm, TextAcross::center, TextUp::middle}, lines);
    for (std::size_t i = 0; i + 1 < lines.begin.size(); ++i) {
      result.debug.emplace_back(lines.points.begin() + lines.begin[i], lines.points.begin() + lines.begin[i + 1]);
    }
  }
  result.debug_numbers.clear();
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

/// Only JSON and parts look at the source edges; the study needs the memory of the rest.
bool looks_at_edges(const PictureRequest& request) {
  return request.output.format == OutputFormat::json || tells_parts(request);
}

/// The looks of regions in a file, so that they can be filled and hatched from it.
std::vector<RegionAppearance> looks_of(const PreparedScene& prepared, const std::vector<Region>& regions,
                                       const HatchPatches& patches) {
  const FaceLight light(prepared.scene, prepared.view().camera, prepared.lights);
  std::vector<RegionAppearance> looks;
  for (const Region& region : regions) {
    const Material material = material_of(prepared.scene, region);
    RegionAppearance& look = looks.emplace_back();
    look.light = std::clamp(light.of(region.face, region.lights, region.light_shares), 0.0, 1.0);
    look.color = {material.color.x, material.color.y, material.color.z};
    look.patch = patches.of_face[region.face];
    look.material = material.name;
  }
  return looks;
}

/// Members that each kind of surface has, as docs/drawing-format.md says.
DocumentSurface document_surface(const FoundSurface& found) {
  const PatchSurface& surface = found.surface;
  DocumentSurface to;
  to.kind = kSurfaceKindNames[static_cast<std::size_t>(surface.kind)];
  to.at = surface.at;
  if (found.has_axis()) to.axis = surface.axis;
  to.radius = surface.radius;
  if (surface.kind == SurfaceKind::cone) to.slope = surface.slope;
  if (surface.kind == SurfaceKind::torus) to.tube = surface.tube;
  if (found.has_length()) {
    to.along = found.along;
    to.turn = found.turn;
  }
  to.outward = found.outward;
  to.sag = found.sag;
  to.faces = found.faces;
  to.object = found.object;
  return to;
}

PictureRequest checked(PictureRequest request) {
  check(request);
  return request;
}

}  // namespace

DrawnScene::DrawnScene(const Scene& scene, PictureRequest request, RunReport& run, const std::optional<PlotBox>& box,
                       std::optional<Topology> topology, bool keep_edges)
    : request_(checked(std::move(request))),
      prepared_(prepare(scene, request_, box, run, std::move(topology))),
      has_edges_(keep_edges || looks_at_edges(request_)) {
  const PlotOptions plot = plot_options(request_, prepared_.around.placement.page);
  HatchScene hatch = hatch_scene(prepared_, plot);
  hatching_ = hatch_spans(hatch, run);
  study_ = ligne::compute_visibility(prepared_, gray_face_lines(request_, prepared_.method, plot), has_edges_, run);
  write_debug_numbers(study_.result, request_, prepared_.around.placement.page);
  if (study_.result.regions) {
    std::ranges::move(hatch_regions(hatch, *study_.result.regions, run), std::back_inserter(hatching_));
  }
  patches_ = std::move(hatch.patches);
  prepared_.projected = {};
  request_.progress = {};
}

Drawing DrawnScene::drawing(RunReport& run) const {
  const VisibilityResult& result = study_.result;
  Drawing drawing =
      tells_parts(request_) ? drawing_by_parts(study_, prepared_.scene, request_) : make_drawing(*result.strokes);
  add_debug_layer(drawing, result.debug);
  drawing.layers.insert(drawing.layers.begin(), hatching_.begin(), hatching_.end());  // below all lines
  add_labels(drawing, request_, prepared_.around);
  if (request_.groups && !request_.groups->points.empty()) {
    std::vector<TextItem> taken = prepared_.around.texts;
    taken.insert(taken.end(), drawing.texts.begin(), drawing.texts.end());
    const double height = text_height_mm(request_.axes, prepared_.around.placement.page);
    for (TextItem& label : mark_points(drawing, request_.groups->points, study_.points_seen, prepared_.view(), height,
                                       request_.axes.text, taken)) {
      drawing.texts.push_back(std::move(label));
    }
  }
  if (result.regions && request_.fill.kind != FillKind::none) {
    drawing.fills = fill_regions(prepared_.scene, prepared_.view(), *result.regions, prepared_.lights, request_.fill.kind);
  } else if (result.order && paints_in_order(request_, prepared_.method)) {
    drawing.fills = paint(prepared_, *result.order, run);
  } else {
    drawing.fills = gray_areas(prepared_, result);
  }
  add_surroundings(drawing, prepared_.around, request_.axes, run);
  return drawing;
}

bool DrawnScene::serves(const OutputRequest& output, const PlotterRequest& plotter) const {
  PictureRequest other = request_;
  other.output = output;
  other.plotter = plotter;
  // Hatching is as dense as its pens are wide, and gray faces have a line for each row of pixels.
  if (request_.hatch.asked() || request_.gray_faces) return false;
  if (looks_at_edges(other) && !has_edges_) return false;
  if (output.format == OutputFormat::json && study_.result.regions && patches_.of_face.empty()) return false;
  const std::uint8_t can = prepared_.method.traits().products;
  const std::uint8_t has = wanted_products(request_, prepared_.method), needs = wanted_products(other, prepared_.method);
  return (needs & can & ~has) == 0;
}

void DrawnScene::choose(OutputRequest output, PlotterRequest plotter) {
  PictureRequest other = request_;
  other.output = std::move(output);
  other.plotter = std::move(plotter);
  check(other);
  request_ = std::move(other);
}

Picture DrawnScene::write(RunReport& run, PdfDocument* pages) const {
  const PlotOptions plot = plot_options(request_, prepared_.around.placement.page);
  const Stage stage{"write", std::to_string(study_.result.strokes->strokes.size()) + " strokes"};
  return timed(run.stages, stage, [&] {
    if (request_.output.format == OutputFormat::json) return Picture{json(plot)};
    const Drawing lines = drawing(run);
    const std::optional<GrayPicture> faces = gray_faces(prepared_, study_.result, plot);
    return write_picture(lines, plot, request_.plotter, request_.output.format, run, faces ? &*faces : nullptr, pages);
  });
}

std::string DrawnScene::json(const PlotOptions& plot) const {
  const VisibilityResult& result = study_.result;
  const View& view = prepared_.view();
  DrawingDocument document;
  document.strokes = &*result.strokes;
  document.regions = result.regions ? &*result.regions : nullptr;
  if (result.regions) {
    document.region_looks = looks_of(prepared_, *result.regions, patches_);
    document.seen_through = seen_through(prepared_.scene, *result.regions, result.strokes->lattice);
  }
  document.order = result.order ? &*result.order : nullptr;
  document.spans = result.spans ? &*result.spans : nullptr;
  document.debug = result.debug.empty() ? nullptr : &result.debug;
  document.source = [&](std::uint32_t source) { return study_.source(prepared_.scene, source); };
  const ObjectOfFace object_of(prepared_.scene);
  if (request_.output.group_objects) {
    document.objects = object_names(prepared_.scene);
    document.object = [&](std::uint32_t source) { return object_of(study_.source(prepared_.scene, source).faces[0]); };
  }
  FoundSurfaces found = surfaces();
  std::ranges::transform(found.list, std::back_inserter(document.surfaces), document_surface);
  document.surface_of_face = std::move(found.of_face);
  document.model_to_page = view.model_to_page;
  document.perspective = view.camera.perspective;
  document.window = view.window;
  document.near_distance = view.near_distance;
  document.method = study_.method->traits().name;
  document.statistics = result.statistics;
  return write_json(document, plot);
}

}  // namespace ligne
