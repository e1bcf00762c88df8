#include "picture/clear/tidy_strokes.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include <glm/geometric.hpp>

#include "base/no_index.hpp"
#include "contours/surfaces/lines_beside.hpp"
#include "linework/clean_lines.hpp"
#include "linework/overlaps/coincident_strokes.hpp"
#include "view/tolerances.hpp"

namespace ligne {
namespace {

/// Shortest bit of a line that visibility leaves and that is drawn, in pen widths. Taste.
constexpr double kLeastInPens = 1.5;
/// Adjustable. Places between two points, as parts of the way, and the largest distance of an outline from them, in lengths
/// of the way.
constexpr std::array kPlaces{0.25, 0.5, 0.75};
constexpr double kBeside = 0.75;

/// Returns the number of the scan of a stroke, kNone for other objects.
std::uint32_t scan_of(const std::vector<ScanObject>& scans, const StrokeModel& strokes, const Stroke& s) {
  const bool is_edge = s.source < strokes.edge_count;
  const std::uint32_t number = is_edge ? s.source : strokes.intersections[s.source - strokes.edge_count].faces[0];
  const auto end_of = [&](const ScanObject& scan) { return is_edge ? scan.edge_end : scan.face_end; };
  const auto scan = std::ranges::upper_bound(scans, number, {}, end_of);
  if (scan == scans.end() || number < (is_edge ? scan->edge_begin : scan->face_begin)) return kNone;
  return static_cast<std::uint32_t>(scan - scans.begin());
}

/// Returns the number of the free form on whose edge a stroke lies, kNone for strokes of smooth contours and of other lines.
std::uint32_t form_of(const std::vector<FreeForm>& forms, const Stroke& s) {
  const auto form = std::ranges::upper_bound(forms, s.source, {}, &FreeForm::edge_end);
  if (form == forms.end() || s.source < form->edge_begin) return kNone;
  return static_cast<std::uint32_t>(form - forms.begin());
}

/// Returns the number of the object of a stroke, or kNone.
std::uint32_t object_of(const PreparedScene& prepared, const StrokeModel& strokes, const Stroke& s) {
  if (s.source < strokes.edge_count) {
    const auto& ends = prepared.object_edge_ends;
    const auto end = std::ranges::upper_bound(ends, s.source);
    return end == ends.end() ? kNone : static_cast<std::uint32_t>(end - ends.begin());
  }
  const std::vector<Object>& objects = prepared.scene.objects;
  const std::uint32_t face = strokes.intersections[s.source - strokes.edge_count].faces[0];
  const auto object = std::ranges::upper_bound(objects, face, {}, &Object::face_end);
  return object == objects.end() ? kNone : static_cast<std::uint32_t>(object - objects.begin());
}

/// Makes sources of strokes that join lines, on the faces of the line.
class JointSources {
 public:
  JointSources(const StrokeModel& strokes, const ProjectedScene& scene) : strokes_(strokes), scene_(scene) {}

  SourceEdge operator()(const Stroke& joint) {
    SourceEdge source;
    source.ends = {to_model_point(scene_.view, strokes_.lattice.to_mm(joint.from), joint.z_from),
                   to_model_point(scene_.view, strokes_.lattice.to_mm(joint.to), joint.z_to)};
    if (joint.source >= strokes_.edge_count) {
      source.faces = strokes_.intersections[joint.source - strokes_.edge_count].faces;
      return source;
    }
    if (!filed_) {
      edge_of_.assign(scene_.source_count, kNone);
      for (std::uint32_t e = 0; e < scene_.edges.size(); ++e) edge_of_[scene_.edges[e].source] = e;
      filed_ = true;
    }
    const std::uint32_t edge = edge_of_[joint.source];
    if (edge != kNone) source.faces = {scene_.edges[edge].face0, scene_.edges[edge].face1};
    return source;
  }

 private:
  const StrokeModel& strokes_;
  const ProjectedScene& scene_;
  std::vector<std::uint32_t> edge_of_;  ///< by source
  bool filed_ = false;
};

/// Removes short bits among the strokes for which takes_part() returns true.
std::size_t remove_short_bits_of(StrokeModel& strokes, double least_mm,
                                 const std::function<bool(const Stroke&)>& takes_part) {
  LineMap map(strokes, takes_part, {}, least_mm / strokes.lattice.step_mm);
  const std::size_t removed = remove_short_bits(map, least_mm);
  map.commit(0);
  return removed;
}

/// Whether lines pass beside three places between two points; with `along`, whether they run beside the whole way.
bool runs_beside(const LinesBeside& lines, Point2 from, Point2 to, bool along) {
  const Point2 d = to - from;
  const double reach = kBeside * glm::length(d);
  if (along) return lines.uncovered(from, to, reach, 0).empty();
  return std::ranges::all_of(kPlaces, [&](double part) { return lines.any_within(from + part * d, reach); });
}

}  // namespace

double least_bit_mm(const PreparedScene& prepared) {
  const bool clear = prepared.request.lines.quality == Quality::clear;
  return prepared.request.lines.least_mm.value_or(clear ? kLeastInPens * prepared.request.page.pen_width_mm : 0);
}

CleanReport clean_scene_lines(StrokeModel& strokes, const PreparedScene& prepared, const ContourSources& contours,
                              double least_mm) {
  const LineClasses drawn = prepared.request.lines.studied(), features = LineClasses::features();
  JointSources make_source(strokes, prepared.projected);
  CleanOptions options;
  options.pen_mm = prepared.request.page.pen_width_mm;
  options.least_mm = least_mm;
  options.has_outlines = drawn.has(LineClass::outline);
  options.has_all_features = (drawn.bits & features.bits) == features.bits;
  if (!prepared.scans.empty()) options.scan_of = [&](const Stroke& s) { return scan_of(prepared.scans, strokes, s); };
  if (!prepared.free_forms.empty()) {
    for (const FreeForm& form : prepared.free_forms) options.facet_parts.push_back(form.facet_part);
    options.form_of = [&](const Stroke& s) { return form_of(prepared.free_forms, s); };
  }
  options.object_of = [&](const Stroke& s) { return object_of(prepared, strokes, s); };
  LinesBeside outlines(strokes.lattice);
  for (const auto& [from, to] : contours.replaced) outlines.add(from, to);
  if (!contours.replaced.empty())
    options.is_outline = [&](Point2 a, Point2 b, bool along) { return runs_beside(outlines, a, b, along); };
  options.make_source = std::ref(make_source);
  return clean_lines(strokes, options);
}

void tidy_strokes(StrokeModel& strokes, const PreparedScene& prepared, const ContourSources& contours, RunReport& run) {
  const LineRequest& lines = prepared.request.lines;
  const double least_mm = least_bit_mm(prepared);
  remove_coincident_strokes(strokes, coincidence_mm(prepared.projected));
  if (least_mm == 0) return;
  const auto is_mesh = [](const Stroke& s) { return s.line_class == LineClass::mesh; };
  if (lines.quality != Quality::clear) {
    run.count_clear("short bits removed", remove_short_bits_of(strokes, least_mm, [](const Stroke&) { return true; }));
    return;
  }
  if (lines.least_mm) run.count_clear("short mesh lines removed", remove_short_bits_of(strokes, least_mm, is_mesh));
  if (!prepared.scans.empty()) {
    const auto is_rough = [&](const Stroke& s) {
      return s.line_class == LineClass::crease && scan_of(prepared.scans, strokes, s) != kNone;
    };
    run.count_clear("points of creases smoothed", smooth_lines(strokes, is_rough));
  }
  const CleanReport report = clean_scene_lines(strokes, prepared, contours, least_mm);
  for (const RuleReport& rule : report.rules) run.count_clear(rule.changes, rule.count);
  run.count_clear("passes of cleaning", static_cast<std::size_t>(report.passes));
}

}  // namespace ligne
