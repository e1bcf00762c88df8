#include "picture/scene_visibility.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "base/no_index.hpp"
#include "linework/stroke_geometry.hpp"
#include "picture/choice/method_choice.hpp"
#include "picture/clear/tidy_strokes.hpp"
#include "picture/errors.hpp"
#include "picture/light/lighting.hpp"
#include "picture/line_groups.hpp"
#include "picture/marks/point_marks.hpp"
#include "picture/products.hpp"
#include "picture/stream/streamed_model.hpp"

namespace ligne {
namespace {

/// Removes the hidden parts of axes, even where hidden lines are drawn.
void remove_hidden_axes(StrokeModel& model) {
  std::erase_if(model.strokes, [](const Stroke& stroke) { return stroke.line_class == LineClass::axes && !stroke.visible; });
}

/// Cuts profiles out of lines, and then removes the classes that were needed only for profiles.
void add_profiles(StrokeModel& model, PreparedScene& prepared, const ContourSources& contours) {
  const LineRequest& lines = prepared.request.lines;
  const ProfileStyle style{lines.profiles(), prepared.request.page.pen_width_mm};
  draw_profiles(model, prepared.projected, prepared.scene, contours, style);
  const LineClasses studied = lines.studied();
  std::erase_if(model.strokes, [&](const Stroke& stroke) {
    return studied.has(stroke.line_class) && !lines.classes.has(stroke.line_class);
  });
}

/// Draws the shape lines and counts them.
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
    run.warn("the picture is larger than the page, and is clipped");
  }
}

/// Whether strokes are searched for coincidence only along their visible parts: for models that are or could be streamed,
/// where the order of strokes must not depend on hidden parts, and for other large models, to save comparisons. Drawings of
/// small models keep their earlier order of strokes.
bool overlap_if_visible(const PictureRequest& request, const Scene& scene) {
  return request.blank || (scene.faces.size() >= kFewestStreamedFaces && request.lines.hidden == HiddenLines::none);
}

VisibilityOptions study_options(const PreparedScene& prepared, std::optional<SpanLines> span_lines) {
  const PictureRequest& request = prepared.request;
  return {.hidden_strokes = request.lines.hidden != HiddenLines::none,
          .progress = request.progress,
          .span_lines = span_lines,
          .with_transparent_faces = shows_faces_of_spans(request, prepared.method),
          .settings = request.lines.settings,
          .wanted = wanted_products(request, prepared.method),
          .compiled = request.compiled.get(),
          .keep = request.keep,
          .earlier = request.earlier.get(),
          .faces = prepared.faces.get(),
          .blank = request.blank.get(),
          .overlap_if_visible = overlap_if_visible(request, prepared.scene)};
}

/// Warns of the parts of the scene that the method can not handle, or does not draw.
void warn_of_limits(const MethodTraits& method, const VisibilityResult& result, const ProjectedScene& projected,
                    const LineRequest& lines, RunReport& run) {
  const std::string name(method.name);
  const auto transparent = std::ranges::count_if(projected.face_is_transparent, [](std::uint8_t t) { return t != 0; });
  if (transparent > 0 && method.transparency == TransparencyMode::opaque) {
    run.warn(std::to_string(transparent) +
             " transparent faces are drawn as opaque; --method atherton-weiler draws them as transparent");
  }
  if (!result.unsupported_reason.empty()) {
    run.warn("the drawing may be wrong: method " + name + " is for " + std::string(method.only_for) +
             ", and in this scene " + result.unsupported_reason);
  }
  if (!result.left_out.empty()) run.warn("--method " + name + " leaves out " + result.left_out);
  // The scene may contain no such thing: no cut, one zone only, a convex body without planes.
  if (lines.settings.has("show") && result.debug.empty() && result.debug_numbers.empty() && !result.plane) {
    run.warn("--show: there is nothing of that kind to draw");
  }
}

/// Finds which marked points are visible, and removes their probes, which are not lines of the drawing.
void take_points(SceneVisibility& found, const PreparedScene& prepared, RunReport& run) {
  if (!prepared.request.groups) return;
  const auto& points = prepared.request.groups->points;
  found.points_seen = read_probes(*found.result.strokes, prepared.first_probe, points.size());
  const std::string unseen = unseen_points(points, found.points_seen, prepared.view());
  if (!unseen.empty()) run.warn(unseen);
}

/// Counts the faces that took no part.
void count_left_out(Statistics& statistics, const PreparedScene& prepared) {
  if (prepared.back_faces.faces > 0) statistics.count("back faces, left out", prepared.back_faces.faces);
  const auto edge_on = std::ranges::count(prepared.projected.face_is_edge_on, std::uint8_t{1});
  if (edge_on > 0) statistics.count("faces seen edge on, left out", static_cast<std::uint64_t>(edge_on));
}

/// Moves the sources of strokes from `prepared` to `found`, and frees the rest, since the method needs the memory.
void keep_sources(SceneVisibility& found, PreparedScene& prepared, bool keep_edges) {
  found.first_detail = prepared.first_detail;
  if (keep_edges) {
    found.edges = std::move(prepared.topology.edges);
    found.details = std::move(prepared.details);
    if (prepared.request.groups) {
      for (const SpaceLine& line : prepared.request.groups->lines) found.lines.push_back(line.ends);
    }
  }
  prepared.topology = {};
}

}  // namespace

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

SceneVisibility compute_visibility(PreparedScene& prepared, std::optional<SpanLines> span_lines, bool keep_edges,
                                   RunReport& run) {
  const PictureRequest& request = prepared.request;
  const ProjectedScene& projected = prepared.projected;
  SceneVisibility found;
  keep_sources(found, prepared, keep_edges);
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
  prepared.faces.reset();
  run.method = found.method->traits().name;
  if (!found.result.strokes) {
    throw RequestError("method", std::string(found.method->traits().name) + " does not produce lines");
  }
  warn_of_limits(found.method->traits(), found.result, projected, request.lines, run);
  return found;
}

void finish_lines(SceneVisibility& found, PreparedScene& prepared, RunReport& run) {
  const LineRequest& lines = prepared.request.lines;
  StrokeModel& strokes = *found.result.strokes;
  remove_hidden_axes(strokes);
  take_points(found, prepared, run);
  clear_intersections(strokes, prepared.scene, prepared.projected, lines, prepared.patches, run);
  const ContourSources contours = draw_contours(strokes, prepared.scene, prepared.view(), prepared.contours,
                                                lines.hidden != HiddenLines::none, contour_options(prepared.request, {}));
  add_shape_strokes(found.result, prepared);
  if (lines.most_hiding) leave_out_often_hidden(strokes, *lines.most_hiding);
  light_regions(prepared, found.result, run);
  warn_of_empty_or_cut(strokes, prepared.around.placement, run);
  timed(run.stages, {"drawing", std::to_string(strokes.strokes.size()) + " strokes"},
        [&] { tidy_strokes(strokes, prepared, contours, run); });
  if (lines.profiles() != ProfileKind::off) {
    timed(run.stages, {"profiles", std::to_string(strokes.strokes.size()) + " strokes"},
          [&] { add_profiles(strokes, prepared, contours); });
  }
  count_left_out(found.result.statistics, prepared);
  run.study = found.result.statistics;
}

}  // namespace ligne
