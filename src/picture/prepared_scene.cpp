#include "picture/prepared_scene.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "base/parallel.hpp"
#include "picture/clear/clear_creases.hpp"
#include "picture/clear/refined_picture.hpp"
#include "picture/culling.hpp"
#include "picture/errors.hpp"
#include "picture/light/lighting.hpp"
#include "picture/line_groups.hpp"
#include "picture/marks/point_marks.hpp"
#include "picture/marks/scan_plane_inset.hpp"
#include "picture/products.hpp"
#include "scene/clean/check_facts.hpp"
#include "view/tolerances.hpp"
#include "visibility/penetration/joined_facets.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

/// Whether smooth contours replace outlines. A mesh that is drawn edge by edge keeps its own outlines.
bool draws_contours(const LineRequest& lines) {
  return lines.quality == Quality::clear && lines.studied().has(LineClass::outline) && !lines.classes.has(LineClass::mesh);
}

std::string faces_text(const Scene& scene) {
  return std::to_string(scene.faces.size()) + " faces, " + std::to_string(scene.vertices.size()) + " vertices";
}

/// Lower bound of the memory for a scene: a page position for each vertex and a triangle for each face.
double least_bytes(const Scene& scene) {
  return static_cast<double>(scene.vertices.size() * sizeof(ProjectedScene::vertices[0]) +
                             scene.faces.size() * sizeof(Topology::triangles[0]));
}

/// Adjustable: with more triangles, the method makes the facets later. By then the topology, which takes twice their
/// memory, is freed.
constexpr std::size_t kMostEarlyFacets = 2'000'000;

/// Places the scene on the page and, in parallel, finds the contours that replace outlines. The contours depend on the
/// candidate outlines, nearly all of which remain after placement. If some do not, the contours are computed again.
SmoothContours place_with_contours(PreparedScene& prepared, const Creases& creases, RunReport& run) {
  const Scene& scene = prepared.scene;
  const Topology& topology = prepared.topology;
  ProjectedScene& projected = prepared.projected;
  const bool with_contours = draws_contours(prepared.request.lines);
  std::vector<std::uint32_t> outlines;
  if (with_contours) outlines = outline_edges(topology, projected);
  const ContourOptions options = contour_options(prepared.request, creases);
  // The default method begins with the facets, and they do not depend on lines.
  const bool makes_facets = with_contours && !prepared.request.lines.cull && &prepared.method == &default_method() &&
                            topology.triangles.size() <= kMostEarlyFacets;
  OutlinePatch patch;
  parallel_tasks(with_contours ? 2 : 1, [&](std::size_t task) {
    if (task == 0) {
      place_on_page(scene, topology, projected);
    } else {
      patch = patch_of_outlines(scene, topology, projected.view.camera, outlines, options.borders);
    }
  });
  // The facets come second, since one thread makes them. So two threads can finish the patch first.
  OutlineReplacement replacement;
  parallel_tasks(with_contours ? 2 : 0, [&](std::size_t task) {
    if (task == 0) {
      if (!makes_facets) return;
      Facets& made = prepared.facets.emplace(make_facets(projected, coincidence_mm(projected) / projected.lattice.step_mm));
      if (projected.with_intersections) made.joined = joined_facets(projected, topology, made.facets);
    } else {
      replacement = replacement_of(scene, topology, projected, std::move(patch), options);
    }
  });
  if (prepared.request.lines.cull) prepared.back_faces = cull_back_faces(scene, topology, projected, run);
  if (!with_contours) return {};
  if (outline_edges(topology, projected) != outlines) return replace_outlines(scene, topology, projected, options);
  return replace_outlines(projected, std::move(replacement));
}

/// The creases of a mesh, and how they select edges.
struct ChosenCreases {
  Creases creases;
  bool decide = false;  ///< whether they select edges; otherwise angles do
};

/// Finds the creases, and refines the surfaces behind a coarse mesh. `scene` is then the refined one.
ChosenCreases find_lines(const Scene*& scene, PreparedScene& prepared, RunReport& run) {
  const LineRequest& lines = prepared.request.lines;
  ChosenCreases found;
  found.decide = select_edges(*scene, prepared.topology, lines, lines.studied(), found.creases, run).creases != nullptr;
  decide_sheets_by_view(*scene, prepared.topology, prepared.view().camera, found.creases);
  if (draws_contours(lines)) {
    if (auto given = refine_on_page(*scene, prepared.topology, prepared.view(), prepared.request, found.creases)) {
      scene = &given->refined.scene;
      found.creases.shapes = {};
      prepared.given = std::move(given);
    }
  }
  return found;
}

/// Selects the lines along fillets for this view (into `tangents`) and the candidate edges, and projects the edges.
void select_lines(PreparedScene& prepared, ChosenCreases& chosen, std::vector<ShapeLine>& tangents) {
  const LineRequest& lines = prepared.request.lines;
  tangents = choose_tangent_lines(prepared.scene, prepared.topology, prepared.request, prepared.view(), chosen.creases);
  TriangleShapes& shapes = chosen.creases.shapes;
  const EdgeSelection selection{lines.studied(), lines.crease_degrees, chosen.decide ? &chosen.creases.lines : nullptr,
                                shapes.heights.empty() ? nullptr : &shapes};
  prepared.projected = select_candidates(prepared.scene, prepared.topology, prepared.view(), selection);
  shapes = {};
}

/// Adds the lines along fillets and the requested shape lines.
void add_lines_of_shape(PreparedScene& prepared, std::vector<ShapeLine> lines, const Creases& creases) {
  const LineClasses& classes = prepared.request.lines.classes;
  if (has_shape_lines(classes)) {
    const std::vector<ShapeLine> more = find_shape_lines(prepared.scene, prepared.topology, prepared.view(), classes,
                                                         contour_options(prepared.request, creases));
    lines.insert(lines.end(), more.begin(), more.end());
  }
  if (!lines.empty()) prepared.shape_lines = add_shape_lines(prepared.projected, std::move(lines));
}

/// Keeps the scans, free forms and surfaces, which the cleaning and writing of lines need. The list of free faces is
/// dropped.
void keep_surfaces(PreparedScene& prepared, Creases creases) {
  if (!creases.lines.empty()) {
    // Rules of their own clean the lines of scans.
    const auto is_no_scan = [&](EdgeRange edges) {
      return std::ranges::find(creases.scans, edges.begin, &ScanObject::edge_begin) == creases.scans.end();
    };
    prepared.free_forms = find_free_forms(prepared.scene, prepared.topology, creases.patches.is_freeform, is_no_scan);
  }
  prepared.scans = std::move(creases.scans);
  if (creases.patches.list.empty()) return;
  prepared.circles = patch_circles(prepared.scene, prepared.topology, creases.patches);
  prepared.patches = std::move(creases.patches);
  prepared.patches.is_freeform = {};
  prepared.patches.borders = {};
}

/// Adds the lines that are not edges of the scene: curves and marked points, details of faces, axes.
void add_other_lines(PreparedScene& prepared) {
  ProjectedScene& projected = prepared.projected;
  const PictureRequest& request = prepared.request;
  std::vector<std::array<Point3, 2>> lines;
  if (request.groups) {
    for (const SpaceLine& line : request.groups->lines) lines.push_back(line.ends);
    add_lines(projected, lines, LineClass::curve);
    prepared.first_probe = projected.source_count;
    add_lines(projected, probes_of(request.groups->points, prepared.view()), LineClass::curve);
  }
  prepared.first_detail = projected.source_count;
  if (request.lines.classes.has(LineClass::detail)) {
    prepared.details = detail_lines(prepared.scene);
    lines.clear();
    for (const DetailLine& line : prepared.details) lines.push_back(line.ends);
    add_lines(projected, lines, LineClass::detail);
  }
  add_lines(projected, all_lines(prepared.around), LineClass::axes);
}

/// Selects and places all lines.
void place_lines(PreparedScene& prepared, ChosenCreases chosen, RunReport& run) {
  std::vector<ShapeLine> tangents;
  select_lines(prepared, chosen, tangents);
  prepared.contours = place_with_contours(prepared, chosen.creases, run);
  add_lines_of_shape(prepared, std::move(tangents), chosen.creases);
  keep_surfaces(prepared, std::move(chosen.creases));
  add_other_lines(prepared);
  prepared.lights = lights_of(prepared.request, prepared.scene);
}

}  // namespace

ContourOptions contour_options(const PictureRequest& request, const Creases& creases) {
  const RegionBorders borders{request.lines.crease_degrees, creases.lines.empty() ? nullptr : &creases.lines,
                              creases.patches.list.empty() ? nullptr : &creases.patches};
  return {borders, creases.scans, request.page.pen_width_mm};
}

PreparedScene prepare(const Scene& scene, PictureRequest requested, const std::optional<PlotBox>& box, RunReport& run,
                      std::optional<Topology> topology) {
  const Method& method = method_of(requested);
  PreparedScene prepared{scene, std::move(requested), method, {}, {}, {}, {}, {}};
  prepared.request.page.inset_part = inset_part(prepared.request.lines);
  const PictureRequest& request = prepared.request;
  run.method = method.traits().name;
  const std::string faces = faces_text(scene);
  request.memory.require(least_bytes(scene), {"project", faces});
  prepared.topology =
      timed(run.stages, {"topology", faces}, [&] { return topology ? std::move(*topology) : build_topology(scene); });
  if (scene.stated.any()) {
    const std::string why =
        timed(run.stages, {"check facts", faces}, [&] { return find_false_fact(scene, prepared.topology); });
    if (!why.empty()) throw RequestError("", why);
  }
  return timed(run.stages, {"project", faces}, [&] {
    prepared.around =
        place_with_axes(box, scene, camera_of(request.view, scene), request.page, request.axes, request.heading);
    const Scene* drawn = &scene;
    ChosenCreases chosen = find_lines(drawn, prepared, run);
    PreparedScene placed = with_scene(std::move(prepared), *drawn);
    place_lines(placed, std::move(chosen), run);
    return placed;
  });
}

PreparedScene with_scene(PreparedScene prepared, const Scene& scene) {
  return {scene,
          std::move(prepared.request),
          prepared.method,
          std::move(prepared.topology),
          std::move(prepared.around),
          std::move(prepared.projected),
          std::move(prepared.back_faces),
          std::move(prepared.lights),
          std::move(prepared.facets),
          std::move(prepared.contours),
          std::move(prepared.shape_lines),
          std::move(prepared.scans),
          std::move(prepared.free_forms),
          std::move(prepared.patches),
          std::move(prepared.circles),
          prepared.first_probe,
          std::move(prepared.details),
          prepared.first_detail,
          std::move(prepared.tones),
          std::move(prepared.given)};
}

}  // namespace ligne
