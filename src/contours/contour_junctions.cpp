#include "contours/contour_junctions.hpp"

#include <array>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>

#include "base/indices_where.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "linework/map/nodes.hpp"
#include "view/clip.hpp"

namespace ligne {
namespace {

constexpr double kCellMm = 2;
/// Adjustable. Longest move that shortens a visible part, in reaches; on recognised surfaces also one that lengthens it.
/// If it is longer than one reach, the end must lie within one reach, or within the sag of recognised surfaces, beside
/// the line that hides it.
constexpr double kMostOblique = 4;
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

/// Calls visit(piece of the visible runs of contour c).
template <class Visit>
void for_visible_pieces(const SeenContour& contour, std::uint32_t c, Visit visit) {
  for (const ContourRun& run : contour.runs) {
    if (run.state != 0) continue;
    const std::vector<CurvePoint> points = contour.curve.part(run.from, run.to);
    for (std::size_t i = 1; i < points.size(); ++i) {
      const CurvePoint &a = points[i - 1], &b = points[i];
      const auto segment = static_cast<std::size_t>(a.at);
      const double beside_mm = segment < contour.beside_mm.size() ? contour.beside_mm[segment] : 0;
      visit(OutlineSegment{a.mm, b.mm, a.depth, b.depth, c, a.length, b.length, beside_mm,
                           segment < contour.free_sides.size() ? contour.free_sides[segment] : Point2(0)});
    }
  }
}

/// A change of state within a curve, and the part of the curve to which it may be moved.
struct Change {
  std::uint32_t contour;
  std::size_t run;  ///< index of the run that ends there
  double length, reach;
  double from, to;   ///< arc lengths
  bool on_surface;   ///< whether the contour lies on recognised surfaces
  bool hides_ahead;  ///< whether the run that begins there is hidden

  /// Whether a crossing at the arc length `at` may be the true end of the run: it lies within reach along the curve, or
  /// the present end lies within reach beside the crossing line.
  bool may_move_to(double at, const Point2& direction, const OutlineSegment& line) const {
    const double shift = std::abs(at - length);
    if (shift <= reach) return true;
    const Point2 along = line.to - line.from;
    // Both lines are exact, and the mesh is off by its sag. A line becomes hidden where it enters the body.
    const bool enters = glm::dot(hides_ahead ? direction : -direction, line.free_side) < 0;
    const double beside = on_surface && enters ? std::max(reach, line.beside_mm) : reach;
    return shift * std::abs(cross(direction, along)) <= beside * glm::length(direction) * glm::length(along);
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
      const double oblique = kMostOblique * reach, on = contours[c].on_surface() ? oblique : reach;
      const double before = runs[i].state == 0 ? oblique : on, after = runs[i + 1].state == 0 ? oblique : on;
      changes.push_back({c, i, length, reach, std::max(0.0, length - before), std::min(curve.length(), length + after),
                         contours[c].on_surface(), runs[i + 1].state < 0});
    }
  }
  return changes;
}

/// Arc length of the crossing with a line in front that is nearest to the change.
std::optional<double> nearest_crossing(const Change& change, const ContourCurve& curve, const SegmentFinder& finder) {
  std::optional<double> best;
  const std::vector<CurvePoint> points =
      curve.part(curve.point_at_length(change.from).at, curve.point_at_length(change.to).at);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const CurvePoint &a = points[i - 1], &b = points[i];
    finder.near(a.mm, b.mm, 0, [&](const OutlineSegment& s) {
      // The finder also returns the searched part of the curve, which does not hide itself.
      if (s.chain == change.contour && s.length_to > change.from - change.reach &&
          s.length_from < change.to + change.reach) {
        return;
      }
      double fraction = 0, depth = 0;
      if (!crossing(a.mm, b.mm, s, fraction, depth)) return;
      if (depth > a.depth + fraction * (b.depth - a.depth)) return;
      const double length = a.length + fraction * (b.length - a.length);
      if (!change.may_move_to(length, b.mm - a.mm, s)) return;
      if (!best || std::abs(length - change.length) < std::abs(*best - change.length)) best = length;
    });
  }
  return best;
}

/// Whether the sights of at least half of the run lie on the other side than the sight before it. Such a run is the
/// hidden part between two cusps.
bool is_beyond_cusp(const SeenContour& contour, const ContourRun& run) {
  const std::vector<int>& sides = contour.sides;
  const auto before = static_cast<std::size_t>(std::max(run.from - 1, 0.0));
  const auto first = static_cast<std::size_t>(run.from),
             last = std::min(static_cast<std::size_t>(std::ceil(run.to)), sides.size());
  std::size_t turned = 0;
  for (std::size_t i = first; i < last; ++i) turned += sides[i] != sides[before];
  return 2 * turned >= last - first;
}

/// Makes short hidden runs visible if no crossing explains either of their ends and they do not lie between two cusps.
void close_gaps(const std::vector<Change>& changes, const std::vector<std::optional<double>>& moved,
                std::vector<SeenContour>& contours) {
  for (std::size_t i = 1; i < changes.size(); ++i) {
    const Change &from = changes[i - 1], &to = changes[i];
    if (from.contour != to.contour || moved[i - 1] || moved[i]) continue;
    SeenContour& contour = contours[to.contour];
    ContourRun& run = contour.runs[to.run];
    const int state = contour.runs[to.run - 1].state;
    if (run.state >= 0 || state < 0 || state != contour.runs[to.run + 1].state) continue;
    if (to.length - from.length < 2 * std::min(from.reach, to.reach) && !is_beyond_cusp(contour, run)) run.state = state;
  }
}

bool contains(const Rect& box, Point2 p) {
  return p.x >= box.min.x && p.x <= box.max.x && p.y >= box.min.y && p.y <= box.max.y;
}

}  // namespace

void SegmentFinder::expect(Point2 from, Point2 to, double reach_mm) {
  const Point2 reach(reach_mm), low = glm::min(from, to) - reach, high = glm::max(from, to) + reach;
  box_.extend(low);
  box_.extend(high);
  if (contains(covered_, low) && contains(covered_, high)) return;
  const Point2 extent = glm::abs(to - from);
  const double half_mm = std::max(extent.x, extent.y) / 2;
  if (half_mm > cell_mm_) return cells_.expect(lattice_.snap(from), lattice_.snap(to), reach_mm / lattice_.step_mm);
  // The queries along a line follow one another. A square somewhat larger than needed serves the next ones, too.
  const Point2 middle = (from + to) / 2.0;
  const double more_mm = half_mm + reach_mm + cell_mm_ / 2, sure_mm = more_mm - 2 * lattice_.step_mm;
  cells_.expect(lattice_.snap(middle), lattice_.snap(middle), more_mm / lattice_.step_mm);
  covered_ = {middle - Point2(sure_mm), middle + Point2(sure_mm)};
}

void SegmentFinder::add(const OutlineSegment& segment) {
  const Point2 margin(lattice_.step_mm), along = segment.to - segment.from;
  if (!std::isfinite(along.x) || !std::isfinite(along.y)) return;
  const Rect box{box_.min - margin, box_.max + margin};
  std::array<double, 2> range{0, 1};
  if (!contains(box, segment.from) || !contains(box, segment.to)) {
    const auto part = clip_segment({segment.from.x, segment.from.y, 0, 1}, {segment.to.x, segment.to.y, 0, 1}, {box});
    if (!part) return;
    range = part->range;
  }
  const auto at = [&](double t) { return lattice_.snap(segment.from + t * along); };
  const auto number = static_cast<std::uint32_t>(segments_.size());
  if (cells_.insert(number, at(range[0]), at(range[1]))) segments_.push_back(segment);
}

bool crossing(Point2 from, Point2 to, const OutlineSegment& segment, double& fraction, double& depth) {
  const Point2 d = to - from, e = segment.to - segment.from, to_start = segment.from - from;
  const double area = cross(d, e);
  if (area == 0) return false;
  fraction = cross(to_start, e) / area;
  const double along = cross(to_start, d) / area;
  if (!(fraction >= 0 && fraction <= 1 && along >= 0 && along <= 1)) return false;
  depth = segment.z_from + along * (segment.z_to - segment.z_from);
  return true;
}

void move_ends_of_contours(std::vector<SeenContour>& contours, const StrokeModel& others, double reach_mm) {
  const std::vector<Change> changes = changes_of(contours, reach_mm);
  if (changes.empty()) return;
  SegmentFinder finder(others.lattice, kCellMm);
  for (const Change& change : changes) {
    const ContourCurve& curve = contours[change.contour].curve;
    const std::vector<CurvePoint> points =
        curve.part(curve.point_at_length(change.from).at, curve.point_at_length(change.to).at);
    for (std::size_t i = 1; i < points.size(); ++i) finder.expect(points[i - 1].mm, points[i].mm);
  }
  for (std::uint32_t c = 0; c < contours.size(); ++c) {
    for_visible_pieces(contours[c], c, [&](const OutlineSegment& s) { finder.add(s); });
  }
  for (const Stroke& s : others.strokes) {
    if (may_hide(s)) finder.add({others.lattice.to_mm(s.from), others.lattice.to_mm(s.to), s.z_from, s.z_to});
  }
  std::vector<std::optional<double>> moved(changes.size());
  parallel_blocks(changes.size(), kSearchBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      moved[i] = nearest_crossing(changes[i], contours[changes[i].contour].curve, finder);
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

/// An end of a visible stroke, and the crossing to which it moves.
struct MovedEnd {
  std::size_t stroke;
  bool first;
  double shift;  ///< mm along the stroke, outwards
  LatticePoint to;
};

/// Finds the nearest crossing with a contour in front near an end of a stroke, or beyond the end on its source edge. A
/// line that runs obliquely into the strip between the contour and the mesh ends farther behind the crossing than the
/// strip is wide.
std::optional<MovedEnd> moved_end(const StrokeModel& model, std::size_t i, bool first, const SegmentFinder& finder,
                                  double reach_mm) {
  const Stroke& s = model.strokes[i];
  const Point2 end = model.lattice.to_mm(first ? s.from : s.to), other = model.lattice.to_mm(first ? s.to : s.from);
  const double length = glm::length(end - other);
  if (!(length > 0)) return std::nullopt;
  const Point2 along = (end - other) / length;
  const double rest = (first ? s.t_from : 1 - s.t_to) / (s.t_to - s.t_from) * length;
  const double back = std::min(kMostOblique * reach_mm, length);
  const double on = std::clamp(rest, 0.0, reach_mm);
  const Point2 from = end - back * along, to = end + on * along;
  const double z_end = first ? s.z_from : s.z_to, slope = (first ? s.z_from - s.z_to : s.z_to - s.z_from) / length;
  // A tangent line runs behind a contour on one of its own surfaces, both of which are curved between the two.
  const bool is_tangent = s.line_class == LineClass::tangent;
  const double slack = is_tangent ? back : 0;
  std::optional<double> best;
  finder.near(from, to, 0, [&](const OutlineSegment& piece) {
    double fraction = 0, depth = 0;
    if (!crossing(from, to, piece, fraction, depth)) return;
    const double shift = fraction * (back + on) - back;
    if (depth > z_end + shift * slope + slack || shift <= -length || (best && std::abs(*best) <= std::abs(shift))) return;
    const Point2 contour = piece.to - piece.from;
    const double reach = is_tangent ? std::max(reach_mm, piece.beside_mm) : reach_mm;
    if (std::abs(shift * cross(along, contour)) > reach * glm::length(contour)) return;
    best = shift;
  });
  if (!best) return std::nullopt;
  return MovedEnd{i, first, *best, model.lattice.snap(end + *best * along)};
}

void apply(const MovedEnd& moved, StrokeModel& model) {
  Stroke& s = model.strokes[moved.stroke];
  const double length = glm::length(model.lattice.to_mm(s.to) - model.lattice.to_mm(s.from));
  if (!(moved.shift > -length) || moved.to == (moved.first ? s.to : s.from)) return;
  const double share = moved.shift / length, dt = share * (s.t_to - s.t_from), dz = share * (double(s.z_to) - s.z_from);
  if (moved.first) {
    s.from = moved.to;
    s.t_from = std::max(0.0, s.t_from - dt);
    s.z_from = static_cast<float>(s.z_from - dz);
  } else {
    s.to = moved.to;
    s.t_to = std::min(1.0, s.t_to + dt);
    s.z_to = static_cast<float>(s.z_to + dz);
  }
}

}  // namespace

void move_ends_of_strokes(StrokeModel& others, const std::vector<SeenContour>& contours, double reach_mm) {
  SegmentFinder finder(others.lattice, kCellMm);
  for (std::uint32_t c = 0; c < contours.size(); ++c) {
    for_visible_pieces(contours[c], c, [&](const OutlineSegment& s) { finder.expect(s.from, s.to); });
  }
  for (std::uint32_t c = 0; c < contours.size(); ++c) {
    for_visible_pieces(contours[c], c, [&](const OutlineSegment& s) { finder.add(s); });
  }
  const std::vector<std::uint32_t> visible =
      indices_where(others.strokes.size(), [&](std::size_t i) { return others.strokes[i].visible; });
  const Nodes nodes(others.strokes, visible);
  std::vector<std::optional<MovedEnd>> moved(nodes.end_count());
  parallel_blocks(moved.size(), kSearchBlock, [&](std::size_t begin, std::size_t last) {
    for (auto end = static_cast<std::uint32_t>(begin); end < last; ++end) {
      const std::uint32_t i = visible[end / 2];
      // An end at which another stroke continues stays in place.
      if (nodes.degree(nodes.of(end)) > 1 || others.strokes[i].line_class == LineClass::axes) continue;
      moved[end] = moved_end(others, i, end % 2 == 0, finder, reach_mm);
    }
  });
  for (const std::optional<MovedEnd>& end : moved) {
    if (end) apply(*end, others);
  }
}

}  // namespace ligne
