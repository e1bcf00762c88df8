#include "contours/contour_junctions.hpp"

#include <array>
#include <optional>
#include <span>

#include <glm/geometric.hpp>

#include "base/indices_where.hpp"
#include "base/parallel.hpp"
#include "linework/map/nodes.hpp"
#include "linework/stroke_geometry.hpp"
#include "view/clip.hpp"

namespace ligne {
namespace {

void append(std::vector<ContourRun>& runs, const ContourRun& run) {
  if (!(run.from < run.to)) return;
  if (!runs.empty() && runs.back().state == run.state) {
    runs.back().to = run.to;
  } else {
    runs.push_back(run);
  }
}

constexpr double kCellMm = 2;
/// Adjustable. Longest move that shortens a visible part, in reaches. If it is longer than one reach, the end must lie
/// within one reach beside the line that hides it.
constexpr double kMostOblique = 4;
/// Distance up to which two ends count as one place, mm.
constexpr double kSamePlaceMm = 1e-3;
/// Number of segments before and behind a place over which the length of the chain's segments is averaged.
constexpr int kSizeWindow = 3;

bool may_hide(const Stroke& s) {
  return s.visible && s.level == 0 &&
         (s.line_class == LineClass::outline || s.line_class == LineClass::border ||
          s.line_class == LineClass::intersection);
}

/// Largest distance by which an end at `at` may be moved along the curve, mm.
double reach_at(const ContourCurve& curve, double at, double reach_mm) {
  const double from = std::max(0.0, at - kSizeWindow), to = std::min(curve.points.back().at, at + kSizeWindow);
  const double length = curve.point_at(to).length - curve.point_at(from).length;
  return std::max(reach_mm, to > from ? length / (to - from) / 2 : 0);
}

/// Finds the visible runs of contours.
SegmentFinder finder_of(const std::vector<SeenContour>& contours, const Lattice& lattice) {
  SegmentFinder finder(lattice, kCellMm);
  for (std::uint32_t c = 0; c < contours.size(); ++c) {
    for (const ContourRun& run : contours[c].runs) {
      if (run.state != 0) continue;
      const std::vector<CurvePoint> points = contours[c].curve.part(run.from, run.to);
      for (std::size_t i = 1; i < points.size(); ++i) {
        const CurvePoint &a = points[i - 1], &b = points[i];
        const auto segment = static_cast<std::size_t>(a.at);
        const double beside_mm = segment < contours[c].beside_mm.size() ? contours[c].beside_mm[segment] : 0;
        finder.add({a.mm, b.mm, a.depth, b.depth, c, a.length, b.length, beside_mm});
      }
    }
  }
  return finder;
}

/// A change of state within a curve, and the part of the curve to which it may be moved.
struct Change {
  std::uint32_t contour;
  std::size_t run;  ///< index of the run that ends there
  double length, reach;
  double from, to;  ///< arc lengths

  std::vector<CurvePoint> part_of(const ContourCurve& curve) const {
    return curve.part(curve.point_at_length(from).at, curve.point_at_length(to).at);
  }
  /// Whether a segment is the part of the curve that is searched, which does not hide itself.
  bool is_of_part(const OutlineSegment& s) const {
    return s.chain == contour && s.length_to > from - reach && s.length_from < to + reach;
  }
};

std::vector<Change> changes_of(const std::vector<SeenContour>& contours, double reach_mm) {
  std::vector<Change> changes;
  for (std::uint32_t c = 0; c < contours.size(); ++c) {
    const ContourCurve& curve = contours[c].curve;
    const std::vector<ContourRun>& runs = contours[c].runs;
    for (std::size_t i = 0; i + 1 < runs.size(); ++i) {
      const double at = runs[i].to;
      const double length = curve.point_at(at).length, reach = reach_at(curve, at, reach_mm);
      const auto longest = [&](const ContourRun& run) { return run.state == 0 ? kMostOblique * reach : reach; };
      changes.push_back({c, i, length, reach, std::max(0.0, length - longest(runs[i])),
                         std::min(curve.length(), length + longest(runs[i + 1]))});
    }
  }
  return changes;
}

/// The crossing with a line in front that is nearest to the visible end of a line, as a length along the line. Lines up to
/// `slack_mm` behind count as in front. The end must lie within reach_of(segment in front) of that line; a negative reach
/// excludes it.
template <class ReachOf>
std::optional<double> nearest_crossing(std::span<const CurvePoint> part, double end, double slack_mm,
                                       const SegmentFinder& finder, const ReachOf& reach_of) {
  std::optional<double> best;
  for (std::size_t i = 1; i < part.size(); ++i) {
    const CurvePoint &a = part[i - 1], &b = part[i];
    const Point2 along = b.mm - a.mm;
    finder.near(a.mm, b.mm, 0, [&](const OutlineSegment& s) {
      const Point2 line = s.to - s.from, to_start = s.from - a.mm;
      const double area = cross(along, line), fraction = cross(to_start, line) / area,
                   on_line = cross(to_start, along) / area;
      if (!(fraction >= 0 && fraction <= 1 && on_line >= 0 && on_line <= 1)) return;  // nor if they are parallel
      const double depth = s.z_from + on_line * (s.z_to - s.z_from);
      if (depth > a.depth + fraction * (b.depth - a.depth) + slack_mm) return;
      const double at = a.length + fraction * (b.length - a.length), shift = std::abs(at - end);
      if (shift * std::abs(cross(along, line)) > reach_of(s) * glm::length(along) * glm::length(line)) return;
      if (!best || shift < std::abs(*best - end)) best = at;
    });
  }
  return best;
}

/// Makes short hidden runs visible if no crossing explains either of their ends.
void close_gaps(const std::vector<Change>& changes, const std::vector<std::optional<double>>& moved,
                std::vector<SeenContour>& contours) {
  for (std::size_t i = 1; i < changes.size(); ++i) {
    const Change &from = changes[i - 1], &to = changes[i];
    if (from.contour != to.contour || moved[i - 1] || moved[i]) continue;
    SeenContour& contour = contours[to.contour];
    ContourRun& run = contour.runs[to.run];
    const int state = contour.runs[to.run - 1].state;
    if (run.state >= 0 || state < 0 || state != contour.runs[to.run + 1].state) continue;
    if (to.length - from.length < 2 * std::min(from.reach, to.reach)) run.state = state;
  }
}

}  // namespace

std::vector<ContourRun> runs_of(const std::vector<Stroke>& strokes, std::uint32_t first_source, std::size_t segments,
                                bool hidden_too) {
  std::vector<ContourRun> runs;
  auto stroke = std::ranges::lower_bound(strokes, first_source, {}, &Stroke::source);
  for (std::size_t i = 0; i < segments; ++i) {
    const std::uint32_t source = first_source + static_cast<std::uint32_t>(i);
    const double at = double(i);
    double end = 0;
    const int other = hidden_too ? kOutsideState : kHiddenState;
    for (; stroke != strokes.end() && stroke->source == source; ++stroke) {
      append(runs, {at + end, at + stroke->t_from, other});
      append(runs, {at + stroke->t_from, at + stroke->t_to, stroke->visible ? int(stroke->level) : kHiddenState});
      end = stroke->t_to;
    }
    append(runs, {at + end, at + 1, other});
  }
  return runs;
}

void put_in(std::vector<ContourRun>& runs, const std::vector<ContourRun>& changed) {
  std::vector<ContourRun> out;
  auto next = changed.begin();
  for (const ContourRun& run : runs) {
    double from = run.from;
    for (; next != changed.end() && next->from < run.to; ++next) {
      append(out, {from, next->from, run.state});
      append(out, {std::max(from, next->from), next->to, next->state});
      from = next->to;
    }
    append(out, {from, run.to, run.state});
  }
  runs = std::move(out);
}

void drop_short_runs(std::vector<ContourRun>& runs, const ContourCurve& curve, double shortest_mm) {
  const std::size_t n = runs.size();
  if (n < 2) return;
  std::vector<double> lengths(n);
  for (std::size_t i = 0; i < n; ++i) lengths[i] = curve.point_at(runs[i].to).length - curve.point_at(runs[i].from).length;
  if (curve.closed && n > 2 && runs.front().state == runs.back().state) {
    lengths.front() = lengths.back() = lengths.front() + lengths.back();
  }
  std::vector<ContourRun> merged;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t before = i > 0 ? i - 1 : curve.closed ? n - 1 : 1;
    const std::size_t after = i + 1 < n ? i + 1 : curve.closed ? 0 : n - 2;
    const std::size_t longer = lengths[before] >= lengths[after] ? before : after;
    append(merged, {runs[i].from, runs[i].to, runs[lengths[i] < shortest_mm ? longer : i].state});
  }
  runs = std::move(merged);
}

SegmentFinder::SegmentFinder(const Lattice& lattice, double cell_mm)
    : lattice_(lattice),
      cells_(cell_mm / lattice.step_mm),
      box_{lattice.to_mm({-kLatticeLimit, -kLatticeLimit}), lattice.to_mm({kLatticeLimit, kLatticeLimit})} {}

void SegmentFinder::add(const OutlineSegment& segment) {
  const Point2 margin(lattice_.step_mm), along = segment.to - segment.from;
  if (!std::isfinite(along.x) || !std::isfinite(along.y)) return;
  const Rect box{box_.min - margin, box_.max + margin};
  const auto part = clip_segment({segment.from.x, segment.from.y, 0, 1}, {segment.to.x, segment.to.y, 0, 1}, {box});
  if (!part) return;
  const auto at = [&](double t) { return lattice_.snap(segment.from + t * along); };
  cells_.insert(static_cast<std::uint32_t>(segments_.size()), at(part->range[0]), at(part->range[1]));
  segments_.push_back(segment);
}

void move_ends_of_contours(std::vector<SeenContour>& contours, const StrokeModel& others, double reach_mm) {
  const std::vector<Change> changes = changes_of(contours, reach_mm);
  if (changes.empty()) return;
  SegmentFinder finder = finder_of(contours, others.lattice);
  for (const Stroke& s : others.strokes) {
    if (may_hide(s)) finder.add({others.lattice.to_mm(s.from), others.lattice.to_mm(s.to), s.z_from, s.z_to});
  }
  std::vector<std::optional<double>> moved(changes.size());
  parallel_blocks(changes.size(), kSearchBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Change& change = changes[i];
      const auto reach_of = [&](const OutlineSegment& s) { return change.is_of_part(s) ? -1 : change.reach; };
      moved[i] = nearest_crossing(change.part_of(contours[change.contour].curve), change.length, 0, finder, reach_of);
    }
  });
  for (std::size_t i = 0; i < changes.size(); ++i) {
    if (!moved[i]) continue;
    SeenContour& contour = contours[changes[i].contour];
    ContourRun &before = contour.runs[changes[i].run], &after = contour.runs[changes[i].run + 1];
    const double at = std::clamp(contour.curve.point_at_length(*moved[i]).at, before.from, after.to);
    before.to = after.from = at;
  }
  close_gaps(changes, moved, contours);
}

namespace {

/// The shift of a stroke's end, mm outwards along the stroke, and its new place.
using Move = std::pair<double, LatticePoint>;

/// Whether a segment lies within the reach of the end of its contour, and that end is at p: there the contour continues a
/// stroke that ends at p.
bool continues_from(Point2 p, const OutlineSegment& s, const SeenContour& contour, double reach_mm) {
  const CurvePoint &front = contour.curve.points.front(), &back = contour.curve.points.back();
  const auto is_at_p = [&](const CurvePoint& q) { return glm::length(q.mm - p) <= kSamePlaceMm; };
  return (s.length_from < front.length + reach_mm && is_at_p(front)) ||
         (s.length_to > back.length - reach_mm && is_at_p(back));
}

/// Finds the nearest crossing with a contour in front near an end of a stroke, or beyond the end on its source edge. A
/// line that runs obliquely into the strip between the contour and the mesh ends farther behind the crossing than the
/// strip is wide.
std::optional<Move> moved_end(const Lattice& lattice, const Stroke& s, bool first, const SegmentFinder& finder,
                              const std::vector<SeenContour>& contours, double reach_mm) {
  const StrokeTip tip = ligne::tip(s, !first), far = ligne::tip(s, first);
  const Point2 end = lattice.to_mm(tip.p), other = lattice.to_mm(far.p);
  const double length = glm::length(end - other);
  if (!(length > 0)) return std::nullopt;
  const Point2 along = (end - other) / length;
  const double rest = (first ? s.t_from : 1 - s.t_to) / (s.t_to - s.t_from) * length;
  const double back = std::min(kMostOblique * reach_mm, length);
  const double on = std::clamp(rest, 0.0, reach_mm);
  const double slope = (tip.z - far.z) / length;
  const auto at = [&](double shift) -> CurvePoint {
    return {.mm = end + shift * along, .depth = tip.z + shift * slope, .length = shift};
  };
  const std::array part{at(-back), at(on)};
  // A tangent line runs behind a contour on one of its own surfaces, both of which are curved between the two.
  const bool is_tangent = s.line_class == LineClass::tangent;
  const auto best = nearest_crossing(part, 0, is_tangent ? back : 0, finder, [&](const OutlineSegment& contour) {
    if (continues_from(other, contour, contours[contour.chain], reach_mm)) return -1.0;
    return is_tangent ? std::max(reach_mm, contour.beside_mm) : reach_mm;
  });
  if (!best) return std::nullopt;
  return Move{*best, lattice.snap(end + *best * along)};
}

}  // namespace

void move_ends_of_strokes(StrokeModel& others, const std::vector<SeenContour>& contours, double reach_mm) {
  SegmentFinder finder = finder_of(contours, others.lattice);
  const std::vector<std::uint32_t> visible =
      indices_where(others.strokes.size(), [&](std::size_t i) { return others.strokes[i].visible; });
  const Nodes nodes(others.strokes, visible);
  std::vector<std::optional<Move>> moved(nodes.end_count());
  parallel_blocks(moved.size(), kSearchBlock, [&](std::size_t begin, std::size_t last) {
    for (auto end = static_cast<std::uint32_t>(begin); end < last; ++end) {
      const Stroke& s = others.strokes[visible[end / 2]];
      // An end at which another stroke continues stays in place.
      if (nodes.degree(nodes.of(end)) > 1 || s.line_class == LineClass::axes) continue;
      moved[end] = moved_end(others.lattice, s, end % 2 == 0, finder, contours, reach_mm);
    }
  });
  for (std::uint32_t end = 0; end < moved.size(); ++end) {
    if (!moved[end]) continue;
    Stroke& s = others.strokes[visible[end / 2]];
    const auto& [shift, to] = *moved[end];
    const double share = shift / glm::length(others.lattice.to_mm(s.to) - others.lattice.to_mm(s.from));
    const bool first = end % 2 == 0;
    if (share > -1 && to != tip(s, first).p) move_end(s, first, {first ? -share : 1 + share, to});
  }
}

}  // namespace ligne
