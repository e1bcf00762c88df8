#include "areas/clip.hpp"

#include <algorithm>

#include "areas/coverage.hpp"
#include "areas/seen_parts.hpp"
#include "areas/side_counts.hpp"
#include "areas/steps.hpp"

namespace ligne::svg {
namespace {

/// Visits the areas of a chain of clip paths, and the areas of the clip paths that cut them.
template <class Visit>
void for_each_area(const Clip& clip, const Visit& visit) {
  for (const Clip* one = &clip; one; one = one->outer.get()) {
    for (const Area& area : one->any_of) visit(area);
    for (const std::shared_ptr<const Clip>& inside : one->within) {
      if (inside) for_each_area(*inside, visit);
    }
  }
}

/// Appends the parts of the lines of which `is_seen` holds. They are divided by their cover.
template <class IsSeen>
void append_parts(const Polylines& lines, const Area* area, const Clip* clip, const IsSeen& is_seen, Polylines& out) {
  Coverage coverage;
  LineCutter cutter;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    cutter.cut(lines[i], out, [&](const StepSegment& stroke, std::vector<SeenPart>& parts) {
      for (const CoveredPart& part : coverage.find(stroke, area, clip)) parts.push_back({part.end.value, is_seen(part)});
    });
  }
}

/// Limit of drawn_once(): mean number of edges and boxes tested per segment. Above it all segments lie in one place,
/// and repeated lines are kept. Adjustable.
constexpr std::size_t kMaxTestsPerSegment = 1000;

/// A part of a segment, as fractions of its length.
struct Interval {
  double begin, end;
};

/// Appends the part of `segment` along which `other` lies up to rounding. Returns false if there is none.
bool add_common_part(const StepSegment& segment, const StepSegment& other, std::vector<Interval>& parts) {
  // The longer segment defines the supporting line.
  const bool is_longer = segment.tolerance() >= other.tolerance();
  const StepSegment &longer = is_longer ? segment : other, &shorter = is_longer ? other : segment;
  if (side_of(longer, orientation(longer, shorter.a)) != 0 || side_of(longer, orientation(longer, shorter.b)) != 0)
    return false;
  const double a = nearest_to(segment, other.a).value, b = nearest_to(segment, other.b).value;
  const Interval part{std::max(std::min(a, b), 0.0), std::min(std::max(a, b), 1.0)};
  if ((part.end - part.begin) * static_cast<double>(segment.tolerance()) <= kLeastPartSteps) return false;
  parts.push_back(part);
  return true;
}

/// Appends the parts of a segment: hidden in the intervals, seen between them.
void add_parts_between(std::vector<Interval>& hidden, std::vector<SeenPart>& parts) {
  std::sort(hidden.begin(), hidden.end(), [](const Interval& p, const Interval& q) { return p.begin < q.begin; });
  double at = 0;
  for (const Interval& part : hidden) {
    if (part.end <= at) continue;
    if (part.begin > at) parts.push_back({part.begin, true});
    parts.push_back({at = part.end, false});
  }
  if (at < 1 || parts.empty()) parts.push_back({1, true});
}

}  // namespace

Polylines clipped(const Polylines& lines, const Clip& clip, const Area* filled) {
  Polylines out;
  Coverage coverage;
  LineCutter cutter;
  SideTally tally;
  const auto find_parts = [&](const StepSegment& stroke, std::vector<SeenPart>& parts) {
    bool any_seen = false;
    for (const CoveredPart& part : coverage.find(stroke, nullptr, &clip)) {
      parts.push_back({part.end.value, part.plus || part.minus});
      any_seen |= parts.back().seen;
    }
    if (!filled || !any_seen) return;
    parts.clear();
    tally.clear();
    tally.add(coverage.find(stroke, nullptr, &clip), SideKind::covered);
    tally.add(coverage.find(stroke, filled, nullptr), SideKind::own);
    tally.for_each_part([&](const SideCounts& counts, const Along& end) {
      const SideCount shown = counts[0], own = counts[1];
      const bool has_own = own.plus > 0 || own.minus > 0;
      parts.push_back(
          {end.value, (shown.plus > 0 && (own.plus > 0 || !has_own)) || (shown.minus > 0 && (own.minus > 0 || !has_own))});
      // A contour with the area on both sides is not a border of it. clip_borders() adds the borders that clip paths make
      // there.
      if (own.plus > 0 && own.minus > 0) parts.back().seen = false;
    });
  };
  for (std::size_t i = 0; i < lines.size(); ++i) cutter.cut(lines[i], out, find_parts);
  return out;
}

Polylines area_borders(const Polylines& contours, const Area& area) {
  Polylines out;
  append_parts(
      contours, &area, nullptr, [](const CoveredPart& part) { return part.plus != part.minus; }, out);
  return out;
}

DividedLines divided(const Polylines& lines, const Area& under, const Clip* under_clip, const Area* over,
                     const Clip* over_clip) {
  DividedLines out;
  Coverage coverage;
  LineCutter cutter;
  SideTally tally;
  for (const bool on : {true, false}) {
    const auto find_parts = [&](const StepSegment& stroke, std::vector<SeenPart>& parts) {
      tally.clear();
      tally.add(coverage.find(stroke, &under, under_clip), SideKind::covered);
      if (over) tally.add(coverage.find(stroke, over, over_clip), SideKind::own);
      tally.for_each_part([&](const SideCounts& counts, const Along& end) {
        const SideCount below = counts[0], own = counts[1];
        const bool beside = (below.plus > 0 && own.plus == 0) || (below.minus > 0 && own.minus == 0);
        const bool within = !over || (below.plus > 0 && own.plus > 0) || (below.minus > 0 && own.minus > 0);
        parts.push_back({end.value, on ? beside && within : !beside});
      });
    };
    for (std::size_t i = 0; i < lines.size(); ++i) cutter.cut(lines[i], on ? out.on : out.off, find_parts);
  }
  return out;
}

Polylines clip_borders(const Area& area, const Clip& clip) {
  Polylines out;
  const auto is_border = [](const CoveredPart& part) { return part.plus != part.minus && !part.on_rim; };
  for_each_area(clip,
                [&](const Area& cutting) { append_parts(cutting.contours_near(area.box()), &area, &clip, is_border, out); });
  return out;
}

Polylines drawn_once(const Polylines& lines) {
  std::vector<StepSegment> all;
  LineCutter cutter;
  Polylines ignored;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    cutter.cut(lines[i], ignored, [&](const StepSegment& stroke, std::vector<SeenPart>& parts) {
      all.push_back(stroke);
      parts.push_back({1, true});
    });
  }
  const EdgeTree tree(all);
  std::vector<std::vector<Interval>> repeated(all.size());
  bool any = false;
  std::size_t tests = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const StepBox box = box_of(all[i]).grown(kRoundingSteps);
    tests += tree.search(
        [&](const StepBox& other) { return box.meets(other); },
        [&](std::size_t k) { any |= k < i && box.meets(box_of(all[k])) && add_common_part(all[i], all[k], repeated[i]); });
    if (tests > kMaxTestsPerSegment * all.size()) return lines;
  }
  if (!any) return lines;
  Polylines out;
  std::size_t number = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    cutter.cut(lines[i], out,
               [&](const StepSegment&, std::vector<SeenPart>& parts) { add_parts_between(repeated[number++], parts); });
  }
  return out;
}

}  // namespace ligne::svg
