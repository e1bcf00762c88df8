#include "picture/pages/scene_document.hpp"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "picture/drawn_scene.hpp"
#include "picture/fills.hpp"
#include "picture/hidden_pieces.hpp"
#include "picture/light/seen_through.hpp"
#include "picture/parts.hpp"
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
  DocumentSurface to;
  to.kind = kSurfaceKindNames[static_cast<std::size_t>(surface.kind)];
  to.at = surface.at;
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

}  // namespace

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

}  // namespace ligne
