#include "picture/scene_visibility.hpp"

#include <algorithm>
#include <utility>

#include "contours/contour_strokes.hpp"
#include "picture/choice/method_choice.hpp"
#include "picture/clear/clear_creases.hpp"
#include "picture/clear/clear_intersections.hpp"
#include "picture/clear/profile.hpp"
#include "picture/clear/tidy_strokes.hpp"
#include "picture/culling.hpp"
#include "picture/errors.hpp"
#include "picture/hatching/hatching.hpp"
#include "picture/light/lighting.hpp"
#include "picture/line_groups.hpp"
#include "picture/marks/point_marks.hpp"
#include "picture/stream/streamed_model.hpp"
#include "view/tolerances.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

/// Parts of axes hidden by a surface are not drawn, not even where hidden lines are.
void remove_hidden_axes(StrokeModel& model) {
  std::erase_if(model.strokes, [](const Stroke& stroke) { return stroke.line_class == LineClass::axes && !stroke.visible; });
}

/// Profiles, and of what was studied for them no more than is asked for.
void add_profiles(StrokeModel& model, PreparedScene& prepared, const ContourSources& contours) {
  const LineRequest& lines = prepared.request.lines;
  draw_profiles(model, prepared.projected, prepared.scene, contours, lines.profiles(), prepared.request.page.pen_width_mm);
  const LineClasses studied = lines.studied();
  std::erase_if(model.strokes, [&](const Stroke& stroke) {
    return studied.has(stroke.line_class) && !lines.classes.has(stroke.line_class);
  });
}

/// The outlines of a mesh that is drawn itself, edge by edge, are its own.
bool draws_contours(const LineRequest& lines) {
  return lines.quality == Quality::clear && lines.studied().has(LineClass::outline) && !lines.classes.has(LineClass::mesh);
}

/// Clear lines draw the outlines of smooth regions as contours of the shape; their borders are the creases that were found.
ContourOptions contour_options(const PictureRequest& request, const Creases& creases) {
  const RegionBorders borders{request.lines.crease_degrees, creases.lines.empty() ? nullptr : &creases.lines,
                              creases.patches.list.empty() ? nullptr : &creases.patches};
  return {borders, creases.scans, request.page.pen_width_mm};
}

/// Draws the lines of the shape that were studied, and tells how many there are.
void add_shape_strokes(VisibilityResult& result, const PreparedScene& prepared) {
  const LineRequest& lines = prepared.request.lines;
  draw_shape_lines(*result.strokes, prepared.view(), prepared.shape_lines, lines.hidden != HiddenLines::none,
                   contour_options(prepared.request, {}));
  for (const LineClass c : kShapeClasses) {
    if (!lines.classes.has(c)) continue;
    const auto count = std::ranges::count(prepared.shape_lines.lines, c, &ShapeLine::line_class);
    result.statistics.count("lines of class " + std::string(kLineClassNames[static_cast<std::size_t>(c)]),
                            static_cast<std::uint64_t>(count));
  }
}

void warn_of_empty_or_cut(const StrokeModel& strokes, const Placement& placement, RunReport& run) {
  const bool nothing = std::none_of(strokes.strokes.begin(), strokes.strokes.end(),
                                    [](const Stroke& s) { return s.line_class != LineClass::axes; });
  if (nothing) {
    run.warn("nothing to draw is in view: the drawing is empty");
  } else if (placement.larger_than_page()) {
    run.warn("the picture is larger than the page: what lies outside is left out");
  }
}

std::string faces_text(const Scene& scene) {
  return std::to_string(scene.faces.size()) + " faces, " + std::to_string(scene.vertices.size()) + " vertices";
}

/// The least memory of a scene: a place on the page for each vertex, and a triangle for each face.
double least_bytes(const Scene& scene) {
  return static_cast<double>(scene.vertices.size() * sizeof(ProjectedScene::vertices[0]) +
                             scene.faces.size() * sizeof(Topology::triangles[0]));
}

std::vector<std::uint32_t> edge_ends_of_objects(const Scene& scene, const Topology& topology) {
  std::vector<std::uint32_t> ends;
  ends.reserve(scene.objects.size());
  for (const Object& object : scene.objects) {
    const auto end = std::ranges::lower_bound(topology.edges, object.vertex_end, {}, &Edge::v0);
    ends.push_back(static_cast<std::uint32_t>(end - topology.edges.begin()));
  }
  return ends;
}

/// Whether strokes are compared for coincidence by what is seen beside them alone: where the model is streamed, or could be,
/// so that their order does not depend on what is hidden, and of other large models since nearly none are compared then.
/// Drawings of small models keep the order that they had before.
bool coincide_by_sight(const PictureRequest& request, const Scene& scene) {
  return request.blank || (scene.faces.size() >= kFewestStreamedFaces && request.lines.hidden == HiddenLines::none);
}

VisibilityOptions study_options(const PreparedScene& prepared, std::optional<SpanLines> span_lines) {
  const PictureRequest& request = prepared.request;
  VisibilityOptions options;
  options.hidden_strokes = request.lines.hidden != HiddenLines::none;
  options.span_lines = span_lines;
  options.settings = request.lines.settings;
  options.wanted = wanted_products(request, prepared.method);
  options.progress = request.progress;
  options.compiled = request.compiled.get();
  options.keep = request.keep;
  options.earlier = request.earlier.get();
  options.blank = request.blank.get();
  options.coincide_by_sight = coincide_by_sight(request, prepared.scene);
  options.facets = prepared.facets ? &*prepared.facets : nullptr;
  return options;
}

/// Warns of the parts of the scene that the method can not handle, or not draw.
void warn_of_limits(const MethodTraits& method, const VisibilityResult& result, const ProjectedScene& projected,
                    const LineRequest& lines, RunReport& run) {
  const std::string name(method.name);
  const auto glass = std::ranges::count_if(projected.face_is_transparent, [](std::uint8_t t) { return t != 0; });
  if (glass > 0 && method.glass == TransparencyMode::opaque) {
    run.warn(std::to_string(glass) + " transparent faces are taken as opaque; --method atherton-weiler sees through them");
  }
  if (!result.unsupported_reason.empty()) {
    run.warn("the drawing may be wrong: --method " + name + " is for " + std::string(method.only_for) +
             ", and of this scene " + result.unsupported_reason);
  }
  if (!result.left_out.empty()) run.warn("--method " + name + " leaves out " + result.left_out);
  // The scene may have nothing of that kind: no cut, one zone, a convex body without planes.
  if (lines.settings.has("show") && result.debug.empty() && result.debug_numbers.empty()) {
    run.warn("--show finds nothing of that kind to draw");
  }
}

/// Adjustable: facets of more triangles wait for the study, when the topology, which takes twice their memory, is gone.
constexpr std::size_t kMostEarlyFacets = 2'000'000;

/// Places the scene on the page, and finds the contours in place of outlines beside that. These depend on the outlines that
/// are candidates, nearly all of which are still there when the scene has been placed; where some are not, the contours are
/// found once more.
SmoothContours place_with_contours(PreparedScene& prepared, const Creases& creases, RunReport& run) {
  const Scene& scene = prepared.scene;
  const Topology& topology = prepared.topology;
  ProjectedScene& projected = prepared.projected;
  const bool with_contours = draws_contours(prepared.request.lines);
  std::vector<std::uint32_t> outlines;
  if (with_contours) outlines = outline_edges(topology, projected);
  const ContourOptions options = contour_options(prepared.request, creases);
  // The method begins with them, and they have nothing to do with lines.
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
  // Facets come second, beside what one thread does: so both threads end the patch.
  OutlineReplacement replacement;
  parallel_tasks(with_contours ? 2 : 0, [&](std::size_t task) {
    if (task == 0) {
      if (makes_facets) prepared.facets = make_facets(projected, coincidence_mm(projected) / projected.lattice.step_mm);
    } else {
      replacement = replacement_of(scene, topology, projected, std::move(patch), options);
    }
  });
  if (prepared.request.lines.cull) prepared.back_faces = cull_back_faces(scene, topology, projected, run);
  if (!with_contours) return {};
  if (outline_edges(topology, projected) != outlines) return replace_outlines(scene, topology, projected, options);
  return replace_outlines(topology, projected, std::move(replacement));
}

}  // namespace

const Method& method_of(const PictureRequest& request) {
  if (request.lines.method) return *request.lines.method;
  return asks_for_regions(request) ? region_method() : default_method();
}

bool paints_in_order(const PictureRequest& request, const Method& method) {
  const std::uint8_t products = method.traits().products;
  return request.fill.kind != FillKind::none && request.fill.lights.empty() && (products & kOrder);
}

std::uint8_t wanted_products(const PictureRequest& request, const Method& method) {
  if (request.output.format == OutputFormat::json) return 0xff & ~kPixels;
  std::uint8_t wanted = kStrokes;
  if (request.gray_faces) wanted |= kSpans | kPixels;
  if (wants_regions(request, method)) wanted |= kRegions;
  if (paints_in_order(request, method)) wanted |= kOrder;
  return wanted;
}

bool wants_regions(const PictureRequest& request, const Method& method) {
  return request.regions || (request.fill.asked() && !paints_in_order(request, method)) ||
         hatches_regions(request, method) || request.lines.classes.has(LineClass::shadow);
}

SourceEdge SceneVisibility::source(const Scene& scene, std::uint32_t number) const {
  const StrokeModel& strokes = *result.strokes;
  if (number >= strokes.edge_count) return strokes.intersections.at(number - strokes.edge_count);
  if (number >= first_detail && number - first_detail < details.size()) {
    const DetailLine& detail = details[number - first_detail];
    return {detail.ends, {detail.face, kNone}, false};
  }
  if (number >= edges.size()) return {lines.at(number - edges.size()), {kNone, kNone}, false};
  const Edge& edge = edges[number];
  return {{scene.vertices[edge.v0], scene.vertices[edge.v1]}, {edge.face0, edge.face1}, false};
}

PreparedScene prepare(const Scene& scene, const PictureRequest& request, const std::optional<PlotBox>& box, RunReport& run,
                      std::optional<Topology> topology) {
  PreparedScene prepared{scene, request, method_of(request), {}, {}, {}, {}, {}};
  run.method = prepared.method.traits().name;
  const std::string faces = faces_text(scene);
  request.memory.require(least_bytes(scene), {"project", faces});
  prepared.topology =
      timed(run.stages, {"topology", faces}, [&] { return topology ? std::move(*topology) : build_topology(scene); });
  timed(run.stages, {"project", faces}, [&] {
    prepared.around =
        place_with_axes(box, scene, camera_of(request.view, scene), request.page, request.axes, request.heading);
    Creases creases;
    const EdgeSelection selection =
        select_edges(scene, prepared.topology, request.lines, request.lines.studied(), creases, run);
    leave_out_walls_behind(scene, prepared.topology, prepared.view().camera, creases);
    std::vector<ShapeLine> shape_lines = choose_tangent_lines(scene, prepared.topology, request, prepared.view(), creases);
    prepared.projected = select_candidates(scene, prepared.topology, prepared.view(), selection);
    prepared.contours = place_with_contours(prepared, creases, run);
    if (has_shape_lines(request.lines.classes)) {
      const std::vector<ShapeLine> more = find_shape_lines(scene, prepared.topology, prepared.view(), request.lines.classes,
                                                           contour_options(request, creases));
      shape_lines.insert(shape_lines.end(), more.begin(), more.end());
    }
    if (!shape_lines.empty()) prepared.shape_lines = add_shape_lines(prepared.projected, std::move(shape_lines));
    prepared.scans = std::move(creases.scans);
    if (!creases.patches.list.empty()) {
      prepared.patches = std::move(creases.patches);
      prepared.patches.is_freeform = {};
      prepared.patches.borders = {};
    }
    prepared.object_edge_ends = edge_ends_of_objects(scene, prepared.topology);
    if (request.groups) {
      std::vector<std::array<Point3, 2>> lines;
      for (const SpaceLine& line : request.groups->lines) lines.push_back(line.ends);
      add_lines(prepared.projected, lines, LineClass::curve);
      prepared.first_probe = prepared.projected.source_count;
      add_lines(prepared.projected, probes_of(request.groups->points, prepared.view()), LineClass::curve);
    }
    prepared.first_detail = prepared.projected.source_count;
    if (request.lines.classes.has(LineClass::detail)) {
      prepared.details = detail_lines(scene);
      std::vector<std::array<Point3, 2>> lines;
      for (const DetailLine& line : prepared.details) lines.push_back(line.ends);
      add_lines(prepared.projected, lines, LineClass::detail);
    }
    add_lines(prepared.projected, all_lines(prepared.around), LineClass::axes);
  });
  prepared.lights = lights_of(request, scene);
  return prepared;
}

SceneVisibility compute_visibility(PreparedScene& prepared, std::optional<SpanLines> span_lines, bool keep_edges,
                                   RunReport& run) {
  const PictureRequest& request = prepared.request;
  SceneVisibility found;
  if (keep_edges) found.edges = std::move(prepared.topology.edges);
  if (keep_edges && request.groups) {
    for (const SpaceLine& line : request.groups->lines) found.lines.push_back(line.ends);
  }
  if (keep_edges) found.details = std::move(prepared.details);
  found.first_detail = prepared.first_detail;
  prepared.topology = {};

  const ProjectedScene& projected = prepared.projected;
  const std::string asks =
      std::to_string(projected.triangles.size()) + " triangles, " + std::to_string(projected.edges.size()) + " lines";
  found.method = &prepared.method;
  found.result = timed(run.stages, {"study", asks}, [&] {
    const VisibilityOptions options = study_options(prepared, span_lines);
    if (request.lines.method) return prepared.method.compute_visibility(projected, options);
    ChosenStudy choice = study_by_choice(request, projected, options);
    found.method = choice.method;
    run.choices.emplace_back("method", std::move(choice.why));
    return std::move(choice.result);
  });
  prepared.facets.reset();
  run.method = found.method->traits().name;
  if (!found.result.strokes) {
    throw RequestError("method", std::string(found.method->traits().name) + " does not produce lines");
  }
  warn_of_limits(found.method->traits(), found.result, projected, request.lines, run);
  remove_hidden_axes(*found.result.strokes);
  if (request.groups) {
    found.points_seen = take_probes(*found.result.strokes, prepared.first_probe, request.groups->points.size());
    const std::string unseen = unseen_points(request.groups->points, found.points_seen, prepared.view());
    if (!unseen.empty()) run.warn(unseen);
  }
  clear_intersections(*found.result.strokes, prepared.scene, projected, request.lines, run);
  const ContourSources contours = draw_contours(*found.result.strokes, prepared.scene, prepared.view(), prepared.contours,
                                                request.lines.hidden != HiddenLines::none, contour_options(request, {}));
  add_shape_strokes(found.result, prepared);
  light_regions(prepared, found.result, run);
  warn_of_empty_or_cut(*found.result.strokes, prepared.around.placement, run);
  timed(run.stages, {"drawing", std::to_string(found.result.strokes->strokes.size()) + " strokes"},
        [&] { tidy_strokes(*found.result.strokes, prepared, run); });
  if (request.lines.profiles() != ProfileKind::off) {
    timed(run.stages, {"profiles", std::to_string(found.result.strokes->strokes.size()) + " strokes"},
          [&] { add_profiles(*found.result.strokes, prepared, contours); });
  }
  if (prepared.back_faces.faces > 0) found.result.statistics.count("back faces, left out", prepared.back_faces.faces);
  const auto edge_on = std::ranges::count(prepared.projected.face_is_edge_on, std::uint8_t{1});
  if (edge_on > 0) found.result.statistics.count("faces seen edge on, left out", static_cast<std::uint64_t>(edge_on));
  run.study = found.result.statistics;
  return found;
}

}  // namespace ligne
