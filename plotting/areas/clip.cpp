#include "areas/clip.hpp"

#include "areas/coverage.hpp"
#include "areas/seen_parts.hpp"
#include "areas/side_counts.hpp"

namespace ligne::svg {
namespace {

/// Visits the areas of a chain of clip paths, and those of the clip paths that cut them.
template <class Visit>
void for_each_area(const Clip& clip, const Visit& visit) {
  for (const Clip* one = &clip; one; one = one->outer.get()) {
    for (const Area& area : one->any_of) visit(area);
    for (const std::shared_ptr<const Clip>& inside : one->within) {
      if (inside) for_each_area(*inside, visit);
    }
  }
}

}  // namespace

Polylines clipped(const Polylines& lines, const Clip& clip, const Area* filled) {
  Polylines out;
  Coverage coverage;
  LineCutter cutter;
  SideTally tally;
  const auto find_parts = [&](const StepSegment& stroke, std::vector<SeenPart>& parts) {
    bool at_border = false;
    for (const CoveredPart& part : coverage.find(stroke, nullptr, &clip)) {
      parts.push_back({part.end.value, part.plus || part.minus});
      at_border |= part.plus != part.minus;
    }
    if (!filled || (!at_border && !parts[0].seen)) return;
    parts.clear();
    tally.clear();
    tally.add(coverage.find(stroke, nullptr, &clip), SideKind::covered);
    tally.add(coverage.find(stroke, filled, nullptr), SideKind::own);
    tally.for_each_part([&](const SideCounts& counts, const Along& end) {
      const SideCount shown = counts[0], own = counts[1];
      const bool has_own = own.plus > 0 || own.minus > 0;
      parts.push_back(
          {end.value, (shown.plus > 0 && (own.plus > 0 || !has_own)) || (shown.minus > 0 && (own.minus > 0 || !has_own))});
      // Between two parts of the area its own ink has no border.
      if (own.plus > 0 && own.minus > 0 && shown.plus > 0 && shown.minus > 0) parts.back().seen = false;
    });
  };
  for (std::size_t i = 0; i < lines.size(); ++i) cutter.cut(lines[i], out, find_parts);
  return out;
}

Polylines area_borders(const Polylines& contours, const Area& area) {
  Polylines out;
  Coverage coverage;
  LineCutter cutter;
  const auto find_parts = [&](const StepSegment& stroke, std::vector<SeenPart>& parts) {
    for (const CoveredPart& part : coverage.find(stroke, &area, nullptr))
      parts.push_back({part.end.value, !part.plus || !part.minus});
  };
  for (std::size_t i = 0; i < contours.size(); ++i) cutter.cut(contours[i], out, find_parts);
  return out;
}

Polylines clip_borders(const Area& area, const Clip& clip) {
  Polylines out;
  Coverage coverage;
  LineCutter cutter;
  const auto find_parts = [&](const StepSegment& stroke, std::vector<SeenPart>& parts) {
    for (const CoveredPart& part : coverage.find(stroke, &area, &clip))
      parts.push_back({part.end.value, part.plus != part.minus && !part.on_rim});
  };
  for_each_area(clip, [&](const Area& cutting) {
    const Polylines lines = cutting.contours_near(area.box());
    for (std::size_t i = 0; i < lines.size(); ++i) cutter.cut(lines[i], out, find_parts);
  });
  return out;
}

}  // namespace ligne::svg
