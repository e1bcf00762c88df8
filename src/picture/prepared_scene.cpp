#include "picture/prepared_scene.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "base/parallel.hpp"
#include "picture/choice/method_choice.hpp"
#include "picture/clear/clear_creases.hpp"
#include "picture/clear/refined_picture.hpp"
#include "picture/errors.hpp"
#include "picture/light/lighting.hpp"
#include "picture/line_groups.hpp"
#include "picture/marks/point_marks.hpp"
#include "picture/marks/scan_plane_inset.hpp"
#include "picture/products.hpp"
#include "scene/clean/check_facts.hpp"
#include "visibility/edges/edge_visibility.hpp"
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

/// Adjustable: with more triangles, the method makes the facets later. By then the topology, which takes twice their memory,
/// is freed. With fewer than kFewestEarly, scenes are often refined, so that an early study would be in vain.
constexpr std::size_t kMostEarlyFacets = 2'000'000, kFewestEarly = 2'000, kMostEarly = 200'000;

/// Whether the method begins with the facets of all faces, which do not depend on lines.
bool begins_with_facets(const PreparedScene& prepared) {
  const LineRequest& lines = prepared.request.lines;
  return draws_contours(lines) && !lines.cull && &prepared.method == &default_method() &&
         prepared.topology.triangles.size() <= kMostEarlyFacets;
}

/// Faces that were placed and studied while creases were chosen.
struct EarlyFaces {
  ProjectedScene page;  ///< without candidates
  PlacedNumbers numbers;
  std::shared_ptr<const FaceStudy> study;
};

std::optional<EarlyFaces> study_early(const PreparedScene& prepared) {
  const LineRequest& lines = prepared.request.lines;
  const std::size_t n = prepared.topology.triangles.size();
  if (!begins_with_facets(prepared) || n < kFewestEarly || n > kMostEarly) return std::nullopt;
  ProjectedScene page =
      select_candidates(prepared.scene, prepared.topology, prepared.view(), {.classes = lines.studied(), .no_edges = true});
  if (!page.with_intersections || chooses_regions(prepared.request, page)) return std::nullopt;
  auto numbers = place_faces(prepared.scene, prepared.topology, page);
  if (!numbers) return std::nullopt;
  auto study = std::make_shared<FaceStudy>(study_faces(page, &prepared.topology, lines.hidden != HiddenLines::none, true));
  return EarlyFaces{std::move(page), std::move(*numbers), std::move(study)};
}

/// Places the scene on the page and, in parallel, finds the contours that replace outlines. The contours depend on the
/// candidate outlines, nearly all of which remain after placement. If some do not, the contours are computed again.
SmoothContours place_with_contours(PreparedScene& prepared, const Creases& creases, std::optional<EarlyFaces> early,
                                   RunReport& run) {
  const Scene& scene = prepared.scene;
  const Topology& topology = prepared.topology;
  ProjectedScene& projected = prepared.projected;
  const bool with_contours = draws_contours(prepared.request.lines);
  std::vector<std::uint32_t> outlines;
  if (with_contours) outlines = outline_edges(topology, projected);
  const ContourOptions options = contour_options(prepared.request, creases);
  OutlinePatch patch;
  parallel_tasks(with_contours ? 2 : 1, [&](std::size_t task) {
    if (task == 0) {
      if (early) {
        early->page.edges = std::move(projected.edges);
        projected = std::move(early->page);
        place_candidates(early->numbers, projected);
      } else {
        place_on_page(scene, topology, projected);
      }
    } else {
      patch = patch_of_outlines(scene, topology, prepared.view().camera, outlines, options.borders);
    }
  });
  // The facets come second, since one thread makes them. So two threads can finish the patch first.
  OutlineReplacement replacement;
  parallel_tasks(with_contours ? 2 : 0, [&](std::size_t task) {
    if (task == 0) {
      if (early) {
        prepared.faces = std::move(early->study);
      } else if (begins_with_facets(prepared)) {
        prepared.faces = std::make_shared<FaceStudy>(study_faces(projected, &topology, false, false));
      }
    } else {
      replacement = replacement_of(scene, topology, projected, std::move(patch), options);
    }
  });
  if (prepared.request.lines.cull) prepared.back_faces = cull_back_faces(scene, topology, projected, run);
  if (!with_contours) return {};
  if (outline_edges(topology, projected) != outlines) return replace_outlines(scene, topology, projected, options);
  return replace_outlines(projected, std::move(replacement));
}

/// The creases of a mesh, and what depends on them.
struct ChosenLines {
  Creases creases;
  std::shared_ptr<GivenScene> given;  ///< the scene and its refinement, which the others are of; or null
  std::vector<ShapeLine> tangents;    ///< along fillets
  ProjectedScene candidates;          ///< the edges
  std::optional<EarlyFaces> early;
  std::optional<PictureMarks> around;  ///< placement of the refinement, if it differs from that of the given scene
};

/// Places the picture of a refined scene on the page. Returns nothing if it stays within a pen width of the area of the
/// given scene, or if the request fixes the place of that one.
using PlaceRefined = std::function<std::optional<PictureMarks>(const Scene&)>;

/// Finds the creases, refines the surfaces behind a coarse mesh, which gives another scene, and chooses the lines along
/// fillets for this view and the candidate edges. Studies the faces of the given scene meanwhile.
ChosenLines choose_lines(const PreparedScene& prepared, const PlaceRefined& place_refined, RunReport& run) {
  const LineRequest& lines = prepared.request.lines;
  const View* view = &prepared.view();
  const Scene* scene = &prepared.scene;
  const Topology* topology = &prepared.topology;
  ChosenLines found;
  std::function<Creases()> search;
  const auto begin_search = [&] { search = search_creases(*scene, *topology, lines, lines.studied()); };
  // The surfaces of several objects keep all threads busy; those of one do not.
  const bool is_one = scene->objects.size() == 1;
  if (!is_one) begin_search();
  parallel_tasks(begins_with_facets(prepared) ? 2 : 1, [&](std::size_t task) {
    if (task == 1) {
      found.early = study_early(prepared);
      return;
    }
    if (is_one) begin_search();
    Creases& creases = found.creases;
    EdgeSelection selection = select_edges(search, lines, lines.studied(), creases, run);
    decide_sheets_by_view(*scene, *topology, view->camera, creases);
    if (draws_contours(lines)) found.given = refine_on_page(*scene, *topology, *view, prepared.request, creases);
    if (found.given) {
      scene = &found.given->refined.scene;
      topology = &found.given->refined.topology;
      creases.shapes = {};
      found.around = place_refined(*scene);
      if (found.around) view = &found.around->placement.view;
    }
    found.tangents = choose_tangent_lines(*scene, *topology, prepared.request, *view, creases);
    if (!creases.shapes.heights.empty()) selection.shapes = &creases.shapes;
    found.candidates = select_candidates(*scene, *topology, *view, selection);
    creases.shapes = {};
  });
  return found;
}

/// The preparation of the refined scene, if there is one.
PreparedScene refined(PreparedScene prepared, ChosenLines& chosen) {
  const std::shared_ptr<GivenScene> given = std::move(chosen.given);
  if (!given) return prepared;
  prepared.given = given;
  given->edges = std::move(prepared.topology.edges);
  prepared.topology = std::move(given->refined.topology);
  chosen.early.reset();
  if (chosen.around) prepared.around = std::move(*chosen.around);
  return with_scene(std::move(prepared), given->refined.scene);
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

/// Places all lines.
void place_lines(PreparedScene& prepared, ChosenLines chosen, RunReport& run) {
  prepared.projected = std::move(chosen.candidates);
  const Patches& patches = chosen.creases.patches;
  parallel_tasks(patches.list.empty() ? 1 : 2, [&](std::size_t task) {
    if (task == 0) {
      prepared.contours = place_with_contours(prepared, chosen.creases, std::move(chosen.early), run);
    } else {
      prepared.circles = patch_circles(prepared.scene, prepared.topology, patches);
    }
  });
  add_lines_of_shape(prepared, std::move(chosen.tangents), chosen.creases);
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
    const auto place_picture = [&](const CameraPicture& picture) {
      return place_with_axes(box, picture, request.page, request.axes, request.heading);
    };
    const CameraPicture picture = picture_of(request.view, request.page, scene);
    prepared.around = place_picture(picture);
    const auto place_refined = [&](const Scene& refined_scene) -> std::optional<PictureMarks> {
      if (request.page.extent || request.page.page_mm_per_unit(picture.unit_mm)) return std::nullopt;
      const Rect seen = projected_extent(refined_scene, picture.camera), &given = picture.extent;
      const Point2 beyond = glm::max(given.min - seen.min, seen.max - given.max) * prepared.view().scale;
      if (std::max(beyond.x, beyond.y) <= request.page.pen_width_mm) return std::nullopt;
      return place_picture({picture.camera, seen, picture.unit_mm});
    };
    ChosenLines chosen = choose_lines(prepared, place_refined, run);
    PreparedScene placed = refined(std::move(prepared), chosen);
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
          std::move(prepared.faces),
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

BackFaces cull_back_faces(const Scene& scene, const Topology& topology, ProjectedScene& projected, RunReport& run) {
  BackFaces back_faces = find_back_faces(scene, topology, projected.view);
  cull(projected, back_faces);
  if (back_faces.kept_objects > 0) {
    run.warn(
        std::to_string(back_faces.kept_objects) + " of " + std::to_string(back_faces.objects) +
        " objects keep their back faces, or some of them: they are not closed and consistently wound, touch or penetrate "
        "themselves, are transparent, or surround the eye");
  }
  return back_faces;
}

}  // namespace ligne
