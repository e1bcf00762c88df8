#include "picture/clear/tidy_strokes.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include <glm/geometric.hpp>

#include "base/no_index.hpp"
#include "contours/surfaces/lines_beside.hpp"
#include "linework/overlaps/coincident_strokes.hpp"
#include "picture/clear/source_lines.hpp"
#include "view/tolerances.hpp"

namespace ligne {
namespace {

/// Shortest bit of a line that visibility leaves and that is drawn, in pen widths. Taste.
constexpr double kLeastInPens = 1.5;
/// Adjustable. Places between two points, as parts of the way, and the largest distance of an outline from them, in lengths
/// of the way.
constexpr std::array kPlaces{0.25, 0.5, 0.75};
constexpr double kBeside = 0.75;

/// Returns the index of the range [begin, end) that holds a number; kNone if none does. The ranges are ascending.
template <class Range>
std::uint32_t range_of(const std::vector<Range>& ranges, std::uint32_t number, std::uint32_t Range::*begin,
                       std::uint32_t Range::*end) {
  const auto range = std::ranges::upper_bound(ranges, number, {}, end);
  const bool is_inside = range != ranges.end() && number >= (*range).*begin;
  return is_inside ? static_cast<std::uint32_t>(range - ranges.begin()) : kNone;
}

/// Returns the number of the scan of a stroke, kNone for other objects.
std::uint32_t scan_of(const std::vector<ScanObject>& scans, const SourceLines& sources, const Stroke& s) {
  return range_of(scans, sources.faces(s)[0], &ScanObject::face_begin, &ScanObject::face_end);
}

/// Removes short bits among the strokes for which takes_part() returns true.
std::size_t remove_short_bits_of(StrokeModel& strokes, double least_mm,
                                 const std::function<bool(const Stroke&)>& takes_part) {
  LineMap map(strokes, takes_part, {}, least_mm / strokes.lattice.step_mm);
  const std::size_t removed = remove_short_bits(map, least_mm);
  map.commit();
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
  const SourceLines sources(strokes, prepared.projected);
  CleanOptions options{.pen_mm = prepared.request.page.pen_width_mm,
                       .least_mm = least_mm,
                       .has_outlines = drawn.has(LineClass::outline),
                       .has_all_features = (drawn.bits & features.bits) == features.bits};
  if (!prepared.scans.empty()) options.scan_of = [&](const Stroke& s) { return scan_of(prepared.scans, sources, s); };
  if (std::ranges::any_of(prepared.scans, &ScanObject::is_decimated)) {
    options.decimated_of = [&](const Stroke& s) {
      const std::uint32_t scan = scan_of(prepared.scans, sources, s);
      return scan != kNone && prepared.scans[scan].is_decimated ? scan : kNone;
    };
  }
  if (!prepared.free_forms.empty()) {
    for (const FreeForm& form : prepared.free_forms) options.facet_parts.push_back(form.facet_part);
    // Strokes of smooth contours and of other lines lie on no edge.
    options.form_of = [&](const Stroke& s) {
      return range_of(prepared.free_forms, s.source, &FreeForm::edge_begin, &FreeForm::edge_end);
    };
  }
  options.object_of = [&](const Stroke& s) {
    return range_of(prepared.scene.objects, sources.faces(s)[0], &Object::face_begin, &Object::face_end);
  };
  LinesBeside outlines(strokes.lattice);
  for (const auto& [from, to] : contours.replaced) outlines.add(from, to);
  if (!contours.replaced.empty())
    options.is_outline = [&](Point2 a, Point2 b, bool along) { return runs_beside(outlines, a, b, along); };
  const auto in_space = [&](LatticePoint p, double depth) {
    return to_model_point(prepared.projected.view, strokes.lattice.to_mm(p), depth);
  };
  options.make_source = [&](const Stroke& joint) -> SourceEdge {
    return {{in_space(joint.from, joint.z_from), in_space(joint.to, joint.z_to)}, sources.faces(joint)};
  };
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
    const SourceLines sources(strokes, prepared.projected);
    const auto is_rough = [&](const Stroke& s) {
      return s.line_class == LineClass::crease && scan_of(prepared.scans, sources, s) != kNone;
    };
    run.count_clear("points of creases smoothed", smooth_lines(strokes, is_rough));
  }
  const CleanReport report = clean_scene_lines(strokes, prepared, contours, least_mm);
  for (const RuleReport& rule : report.rules) run.count_clear(rule.changes, rule.count);
  run.count_clear("passes of cleaning", static_cast<std::size_t>(report.passes));
}

}  // namespace ligne
