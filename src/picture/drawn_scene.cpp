#include "picture/drawn_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include "picture/fills.hpp"
#include "picture/hatching/painted_faces.hpp"
#include "picture/hidden_pieces.hpp"
#include "picture/light/seen_through.hpp"
#include "picture/marks/point_marks.hpp"
#include "picture/marks/scan_plane_inset.hpp"
#include "picture/parts.hpp"
#include "picture/products.hpp"
#include "plotting/curves/fit_curves.hpp"
#include "plotting/writers/writers.hpp"
#include "scene/clean/named_objects.hpp"
#include "view/brightness.hpp"

namespace ligne {
namespace {

/// The colour, light and patch of each region, so that the stored drawing can be filled and hatched.
std::vector<RegionAppearance> looks_of(const PreparedScene& prepared, const std::vector<Region>& regions,
                                       const HatchPatches& patches) {
  const FaceLight light(prepared.scene, prepared.view().camera, prepared.lights);
  std::vector<RegionAppearance> looks;
  for (const Region& region : regions) {
    const Material& material = material_of(prepared.scene, region);
    RegionAppearance& look = looks.emplace_back();
    look.light = std::clamp(light.of(region.face, region.lights, region.light_shares), 0.0, 1.0);
    look.color = {material.color.x, material.color.y, material.color.z};
    look.patch = patches.of_face[region.face];
    look.material = material.name;
  }
  return looks;
}

/// Adds the materials of a painting order to the document, and for each piece its light, material and whether it is
/// hidden.
void add_piece_looks(const PreparedScene& prepared, const PaintOrder& order, DrawingDocument& document) {
  const Scene& scene = prepared.scene;
  const std::vector<double> lights = lights_of_pieces(scene, prepared.view(), order, prepared.lights);
  for (const Material& m : scene.materials) {
    document.materials.push_back({m.name, {m.color.x, m.color.y, m.color.z}, m.opacity});
  }
  const auto none = static_cast<std::uint32_t>(document.materials.size());
  const std::vector<std::uint8_t> hidden =
      find_hidden_pieces(order, prepared.around.placement.page.sheet(),
                         [&](std::uint32_t face) { return material_of(scene, face).opacity >= 1; });
  bool needs_none = false;
  for (std::size_t i = 0; i < order.pieces.size(); ++i) {
    const std::uint32_t m = scene.face_material.empty() ? 0 : scene.face_material[order.pieces[i].face];
    needs_none = needs_none || m >= none;
    document.piece_looks.push_back({std::clamp(lights[i], 0.0, 1.0), std::min(m, none), hidden[i] != 0});
  }
  if (!needs_none) return;
  const Material standard;
  document.materials.push_back({{}, {standard.color.x, standard.color.y, standard.color.z}, standard.opacity});
}

/// Sets the members that each kind of surface has, see docs/drawing-format.md.
DocumentSurface document_surface(const FoundSurface& found) {
  const PatchSurface& surface = found.surface;
  DocumentSurface to{.kind = kSurfaceKindNames[static_cast<std::size_t>(surface.kind)], .at = surface.at};
  if (found.has_axis()) to.axis = surface.axis;
  if (found.has_radius()) to.radius = surface.radius;
  if (surface.kind == SurfaceKind::cone) to.slope = surface.slope;
  if (surface.kind == SurfaceKind::torus) to.tube = surface.tube;
  if (found.has_length()) to.along = found.along;
  if (found.has_turn()) to.turn = found.turn;
  to.outward = found.outward;
  to.sag = found.sag;
  to.faces = found.faces;
  to.object = found.object;
  return to;
}

/// Returns the JSON. `drawn` must have the source edges of strokes. Throws std::runtime_error.
std::string scene_json(const DrawnScene& drawn, const PlotOptions& plot) {
  const PreparedScene& prepared = drawn.prepared();
  const SceneVisibility& found = drawn.visibility();
  const VisibilityResult& result = found.result;
  const View& view = prepared.view();
  DrawingDocument document;
  document.strokes = &*result.strokes;
  document.regions = result.regions ? &*result.regions : nullptr;
  if (result.regions) {
    document.region_looks = looks_of(prepared, *result.regions, drawn.patches());
    document.seen_through = seen_through(prepared.scene, *result.regions, result.strokes->lattice);
  }
  document.order = result.order ? &*result.order : nullptr;
  if (result.order) add_piece_looks(prepared, *result.order, document);
  document.spans = result.spans ? &*result.spans : nullptr;
  document.plane = result.plane ? &*result.plane : nullptr;
  document.debug = result.debug.empty() ? nullptr : &result.debug;
  document.source = [&](std::uint32_t source) { return found.source(prepared.scene, source); };
  const ObjectOfFace object_of(prepared.scene);
  if (prepared.request.output.group_objects) {
    document.objects = object_names(prepared.scene);
    document.object = [&](std::uint32_t source) { return object_of(found.source(prepared.scene, source).faces[0]); };
  }
  FoundSurfaces surfaces = drawn.surfaces();
  std::ranges::transform(surfaces.list, std::back_inserter(document.surfaces), document_surface);
  document.surface_of_face = std::move(surfaces.of_face);
  document.model_to_page = view.model_to_page;
  document.perspective = view.camera.perspective;
  document.window = view.window;
  document.near_distance = view.near_distance;
  document.method = found.method->traits().name;
  document.statistics = result.statistics;
  return write_json(document, plot);
}

constexpr double kInsetText = 0.8;  ///< height of texts in an inset, as part of the height of other texts

/// Adds the polylines that show how the method worked, below all lines.
void add_debug_layer(Drawing& drawing, const std::vector<std::vector<Point2>>& polylines) {
  if (polylines.empty()) return;
  Layer layer{"debug", {}};
  for (const std::vector<Point2>& line : polylines) layer.lines.add(line);
  drawing.layers.insert(drawing.layers.begin(), std::move(layer));
}

/// Makes fills of pieces of faces, from back to front.
std::vector<Fill> paint(const PreparedScene& prepared, const PaintOrder& order, RunReport& run) {
  const Scene& scene = prepared.scene;
  PaintOrder seen = order;
  const std::size_t hidden = drop_hidden_pieces(seen, prepared.around.placement.page.sheet(),
                                                [&](std::uint32_t face) { return material_of(scene, face).opacity >= 1; });
  run.study.count("pieces painted", seen.pieces.size());
  run.study.count("pieces not painted, since they are hidden", hidden);
  return fill_pieces(scene, prepared.view(), seen, prepared.lights, prepared.request.fill.kind);
}

/// Marks points, and labels them clear of all other texts.
void add_point_marks(Drawing& drawing, const DrawnScene& drawn) {
  const PictureRequest& request = drawn.request();
  if (!request.groups || request.groups->points.empty()) return;
  const PictureMarks& around = drawn.prepared().around;
  std::vector<TextItem> taken = around.texts;
  taken.insert(taken.end(), drawing.texts.begin(), drawing.texts.end());
  const double height = text_height_mm(request.axes, around.placement.page);
  std::vector<TextItem> labels = mark_points(drawing, request.groups->points, drawn.visibility().points_seen,
                                             drawn.prepared().view(), {height, request.axes.text}, taken);
  std::ranges::move(labels, std::back_inserter(drawing.texts));
}

/// Adds the plane of a scan line in the space reserved for it.
void add_inset(Drawing& drawing, const ScanPlane& plane, const PreparedScene& prepared) {
  const Placement& placement = prepared.around.placement;
  const Rect drawable = placement.page.drawable(), picture = placement.picture;
  Rect area = drawable;
  area.min.y = drawable.max.y - prepared.request.page.inset_part * drawable.height();
  add_scan_plane(drawing, plane, picture, area, kInsetText * text_height_mm(prepared.request.axes, placement.page));
}

/// The circles of recognised surfaces on the page. Those that reach behind the viewer are left out.
std::vector<Ellipse> circles_on_page(const PreparedScene& prepared) {
  // Circles become ellipses in either projection, and any five points tell one.
  constexpr std::size_t kPoints = 8;
  std::array<Point2, kPoints> turn;
  for (std::size_t k = 0; k < kPoints; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / kPoints;
    turn[k] = {std::cos(angle), std::sin(angle)};
  }
  const View& view = prepared.view();
  std::vector<Point2> points;
  std::vector<Ellipse> found;
  for (const PatchCircle& circle : prepared.circles) {
    const auto [u, v] = frame_of(circle.axis);
    points.clear();
    for (const Point2 way : turn) {
      const Point3 p = circle.centre + circle.radius * (way.x * u + way.y * v);
      if (view.camera.perspective && camera_coordinates(view.camera, p).z < view.near_distance) break;
      const HomogeneousPoint h = to_homogeneous(view, p);
      points.push_back(Point2(h.x, h.y) / h.w);
    }
    Ellipse ellipse;
    if (points.size() == kPoints && fit_ellipse(points, ellipse)) found.push_back(ellipse);
  }
  return found;
}

/// Makes the areas below all lines from regions, overpainting pieces of faces, or spans.
std::vector<Fill> fills_of(const DrawnScene& drawn, RunReport& run) {
  const PreparedScene& prepared = drawn.prepared();
  const VisibilityResult& result = drawn.visibility().result;
  const FillKind kind = prepared.request.fill.kind;
  if (result.regions && kind != FillKind::none) {
    return fill_regions(prepared.scene, prepared.view(), *result.regions, prepared.lights, kind);
  }
  if (result.order && paints_in_order(prepared.request, prepared.method)) return paint(prepared, *result.order, run);
  if (fills_spans(prepared.request, prepared.method)) return filled_spans(prepared, result);
  return gray_areas(prepared, result);
}

}  // namespace

std::shared_ptr<const KnownEllipses> known_ellipses(const PreparedScene& prepared) {
  return std::make_shared<KnownEllipses>(circles_on_page(prepared), prepared.around.placement.page.sheet());
}

DrawnScene::DrawnScene(DrawnParts parts) : parts_(std::move(parts)) {}

FoundSurfaces DrawnScene::surfaces() const { return found_surfaces(parts_.prepared.scene, parts_.prepared.patches); }

Drawing DrawnScene::compose(RunReport& run) const {
  const PreparedScene& prepared = parts_.prepared;
  const VisibilityResult& result = parts_.found.result;
  Drawing drawing =
      has_parts(request()) ? drawing_by_parts(parts_.found, prepared.scene, request()) : make_drawing(*result.strokes);
  add_debug_layer(drawing, result.debug);
  drawing.layers.insert(drawing.layers.begin(), parts_.hatching.begin(), parts_.hatching.end());  // below all lines
  drawing.fills = fills_of(*this, run);  // before labels, which have a halo on areas
  add_labels(drawing, request(), prepared.around);
  add_point_marks(drawing, *this);
  add_surroundings(drawing, prepared.around, request().axes, run);
  if (result.plane) add_inset(drawing, *result.plane, prepared);
  return drawing;
}

bool DrawnScene::serves(const OutputRequest& output, const PlotterRequest& plotter) const {
  const Method& method = parts_.prepared.method;
  PictureRequest other = request();
  other.output = output;
  other.plotter = plotter;
  // The density of hatching depends on the pen width, and faces of an image have one scan line per row of pixels.
  if (request().hatch.is_requested() || request().gray_faces || fills_smoothly(request())) return false;
  if (looks_at_edges(other) && !parts_.has_edges) return false;
  if (output.format == OutputFormat::json && parts_.found.result.regions && parts_.patches.of_face.empty()) return false;
  const std::uint8_t can = method.traits().products;
  const std::uint8_t has = wanted_products(request(), method), needs = wanted_products(other, method);
  return (needs & can & ~has) == 0;
}

void DrawnScene::choose(OutputRequest output, PlotterRequest plotter) {
  PictureRequest other = request();
  other.output = std::move(output);
  other.plotter = std::move(plotter);
  check(other);
  parts_.prepared.request = std::move(other);
}

Picture DrawnScene::write(RunReport& run, PdfDocument* pages) const {
  PlotOptions plot = plot_options(request(), parts_.prepared.around.placement.page);
  const VisibilityResult& result = parts_.found.result;
  const Stage stage{"write", std::to_string(result.strokes->strokes.size()) + " strokes"};
  return timed(run.stages, stage, [&] {
    if (request().output.format == OutputFormat::json) return Picture{scene_json(*this, plot)};
    const Drawing drawing = compose(run);
    if (plot.curves) plot.known = parts_.ellipses ? parts_.ellipses : known_ellipses(parts_.prepared);
    const std::optional<FacePicture> faces = face_picture(parts_.prepared, result, plot);
    return write_picture(drawing, plot, request().plotter, {request().output.format, faces ? &*faces : nullptr, pages}, run);
  });
}

bool looks_at_edges(const PictureRequest& request) {
  return request.output.format == OutputFormat::json || has_parts(request);
}

}  // namespace ligne
