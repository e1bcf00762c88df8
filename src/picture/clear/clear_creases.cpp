#include "picture/clear/clear_creases.hpp"

#include <limits>

#include <glm/geometric.hpp>

#include "base/indices_where.hpp"
#include "base/no_index.hpp"
#include "scene/creases/color_borders.hpp"
#include "scene/patches/borders/freeform_seams.hpp"
#include "scene/patches/borders/straight_tangents.hpp"
#include "scene/patches/borders/tangent_gaps.hpp"
#include "scene/patches/fillets.hpp"

namespace ligne {
namespace {

/// Adjustable: fillets narrower than this on the page, in pen widths, are drawn as one line. Two lines this near to
/// each other look like one line that is too thick. Taste.
constexpr double kNarrowFilletInPens = 8;

double widest_fillet(const PictureRequest& request, const View& view) {
  if (request.lines.tangent == TangentLines::borders) return 0;
  if (request.lines.tangent == TangentLines::middles) return std::numeric_limits<double>::infinity();
  return kNarrowFilletInPens * request.page.pen_width_mm / view.scale;
}

/// Marks the tangent lines of patches in `creases.lines`. Returns the middle lines of fillets. `widest`: of a fillet that is
/// drawn as its middle, model units.
std::vector<ShapeLine> tangents_of_patches(const Scene& scene, const Topology& topology, double widest, Creases& creases) {
  const Patches& patches = creases.patches;
  if (patches.list.empty() && patches.borders.empty()) return {};
  close_tangent_gaps(scene, topology, patches, creases.lines, creases.patch_edges);
  FilletMiddles fillets = fillet_middles(scene, topology, patches, creases.patch_edges, widest);
  drop_loose_tangents(scene, topology, patches, creases.lines, creases.patch_edges);
  straighten_tangents(scene, topology, creases.lines, creases.patch_edges);
  find_freeform_seams(scene, topology, patches, creases.lines, creases.patch_edges);
  const auto is_fillet = [&](std::uint32_t face) {
    const std::uint32_t patch = patches.patch_of[face];
    return patch != kNone && fillets.is_fillet[patch];
  };
  for (const std::uint32_t e : indices_of_marks(creases.patch_edges)) {
    if (creases.patch_edges[e] != PatchEdge::tangent) continue;
    const Edge& edge = topology.edges[e];
    if (!is_fillet(edge.face0) && !is_fillet(edge.face1)) creases.lines[e] = kTangentLine;
  }
  std::vector<ShapeLine> lines;
  for (FaceLine& line : fillets.lines) {
    lines.push_back({LineClass::tangent, std::move(line.points), std::move(line.faces), line.closed});
  }
  return lines;
}

}  // namespace

bool needs_creases(LineClasses classes) {
  return classes.has(LineClass::crease) || classes.has(LineClass::tangent) || has_shape_lines(classes);
}

std::function<Creases()> search_creases(const Scene& scene, const Topology& topology, const LineRequest& request,
                                        LineClasses classes) {
  if (request.quality == Quality::exact || !needs_creases(classes)) return {};
  return search_creases(scene, topology, {request.crease_degrees, request.surface_crease_degrees});
}

EdgeSelection select_edges(const std::function<Creases()>& search, const LineRequest& request, LineClasses classes,
                           Creases& creases, RunReport& run) {
  EdgeSelection selection{classes, request.crease_degrees};
  if (!search) return selection;
  creases = search();
  run.count_clear("creases smooth by the file", creases.smooth_by_file);
  run.count_clear("creases sharp by the file", creases.sharp_by_file);
  run.count_clear("creases inside a surface", creases.inside_surfaces);
  run.count_clear("creases between surfaces", creases.between_surfaces);
  run.count_clear("creases on no clean line", creases.untraced);
  run.count_clear("creases traced", creases.traced);
  run.count_clear("creases continued", creases.continued);
  run.count_clear("creases that fade", creases.fading);
  run.count_clear("creases with loose ends", creases.loose);
  run.count_clear("creases standing out", creases.spurs);
  run.count_clear("creases too short", creases.short_chains);
  run.count_clear("creases of straight sheets", creases.straight_sheets);
  selection.creases = &creases.lines;
  return selection;
}

void decide_sheets_by_view(const Scene& scene, const Topology& topology, const Camera& camera, Creases& creases) {
  const auto sight_from = [&](std::uint32_t e) {
    const Edge& edge = topology.edges[e];
    return to_eye(camera, 0.5 * (scene.vertices[edge.v0] + scene.vertices[edge.v1]));
  };
  for (const WallEdge& wall : creases.walls) {
    if (glm::dot(wall.side, sight_from(wall.edge)) <= 0) creases.lines[wall.edge] = 0;
  }
  for (auto sheet = creases.folds.begin(); sheet != creases.folds.end();) {
    const std::uint32_t e = sheet->edge;
    const Point3 sight = sight_from(e);
    bool turns_left = false, turns_right = false;
    for (; sheet != creases.folds.end() && sheet->edge == e; ++sheet) {
      const double side = glm::dot(sheet->normal, sight);
      turns_left |= side > 0;
      turns_right |= side < 0;
    }
    if (turns_left != turns_right && creases.lines[e] == 0) creases.lines[e] = kFoldLine;
  }
}

std::vector<ShapeLine> choose_tangent_lines(const Scene& scene, const Topology& topology, const PictureRequest& request,
                                            const View& view, Creases& creases) {
  const bool asks_for_lines = request.lines.classes.has(LineClass::tangent) && request.lines.tangent != TangentLines::none;
  if (creases.lines.empty() || !asks_for_lines) return {};
  std::vector<ShapeLine> middles = tangents_of_patches(scene, topology, widest_fillet(request, view), creases);
  mark_color_borders(scene, topology, creases.lines);
  return middles;
}

}  // namespace ligne
