#include "areas/occluder.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace ligne::svg {
namespace {

/// Most cells along a side of the grid of occluders. Adjustable.
constexpr double kMostCells = 256;
/// Margin of bounding boxes, mm: larger than all rounding.
constexpr double kBoxMargin = 4 / kStepsPerMm;

/// Whether the second occluder, painted later, hides all that the first one hides.
bool hides_as_much(const Occluder& first, const Occluder& second) {
  return first.clip == second.clip && second.since <= first.since && first.area.is_same(second.area) &&
         (!first.rim_width || (second.rim_width && *second.rim_width >= *first.rim_width));
}

/// The line that the occluder draws in place of lines of this width along its rim.
RimLine line_of(const Occluder& occluder, double width_mm) {
  if (!occluder.rim_width || *occluder.rim_width < width_mm) return RimLine::none;
  return *occluder.rim_width > 0 ? RimLine::contours : RimLine::borders;
}

Rect with_margin(Point2 a, Point2 b) {
  return {{std::min(a.x, b.x) - kBoxMargin, std::min(a.y, b.y) - kBoxMargin},
          {std::max(a.x, b.x) + kBoxMargin, std::max(a.y, b.y) + kBoxMargin}};
}

}  // namespace

Occluders::Occluders(std::span<const Occluder> occluders, const FilledAreas& filled, ClipWork work)
    : occluders_(occluders), filled_(filled), work_(std::move(work)), is_repeated_(occluders.size()) {
  drop_repeated();
  for (const Occluder& occluder : occluders) {
    if (occluder.area.empty()) continue;
    box_.extend(occluder.area.box().min);
    box_.extend(occluder.area.box().max);
  }
  side_ = static_cast<std::size_t>(std::clamp(std::sqrt(static_cast<double>(occluders.size())), 1.0, kMostCells));
  cells_.resize(side_ * side_);
  for (std::uint32_t i = 0; i < occluders.size(); ++i) {
    if (occluders[i].area.empty() || is_repeated_[i]) continue;
    const Rect& box = occluders[i].area.box();
    for (std::size_t y = cell(box.min.y, 1); y <= cell(box.max.y, 1); ++y) {
      for (std::size_t x = cell(box.min.x, 0); x <= cell(box.max.x, 0); ++x) cells_[y * side_ + x].push_back(i);
    }
  }
}

/// Finds areas that are painted again later without change.
void Occluders::drop_repeated() {
  std::unordered_map<std::size_t, std::uint32_t> last;
  for (std::uint32_t i = static_cast<std::uint32_t>(occluders_.size()); i-- > 0;) {
    const Occluder& occluder = occluders_[i];
    const auto [found, is_new] = last.emplace(occluder.area.hash() ^ std::hash<const void*>()(occluder.clip.get()), i);
    if (is_new) continue;
    const Occluder& later = occluders_[found->second];
    if (occluder.clip == later.clip && later.since < occluder.painted && occluder.area.is_same(later.area))
      covered_.insert(occluder.painted);
    is_repeated_[i] = hides_as_much(occluder, later);
  }
}

std::size_t Occluders::cell(double at, int axis) const {
  const double size = box_.max[axis] - box_.min[axis];
  if (!(size > 0)) return 0;
  const double side = static_cast<double>(side_);
  return static_cast<std::size_t>(std::clamp((at - box_.min[axis]) / size * side, 0.0, side - 1));
}

void Occluders::find_over(const Rect& box, std::uint32_t painted) {
  over_.clear();
  const std::size_t first_x = cell(box.min.x, 0), first_y = cell(box.min.y, 1);
  for (std::size_t y = first_y; y <= cell(box.max.y, 1); ++y) {
    for (std::size_t x = first_x; x <= cell(box.max.x, 0); ++x) {
      const std::vector<std::uint32_t>& here = cells_[y * side_ + x];
      for (auto i = here.rbegin(); i != here.rend() && occluders_[*i].painted > painted; ++i) {
        if (occluders_[*i].since >= painted) continue;
        const Rect& other = occluders_[*i].area.box();
        // An occluder in several cells is found in the first of them.
        if (std::max(cell(other.min.x, 0), first_x) != x || std::max(cell(other.min.y, 1), first_y) != y) continue;
        if (other.min.x <= box.max.x && other.max.x >= box.min.x && other.min.y <= box.max.y && other.max.y >= box.min.y)
          over_.push_back(*i);
      }
    }
  }
  if (!std::is_sorted(over_.begin(), over_.end(), std::greater<>())) std::sort(over_.begin(), over_.end(), std::greater<>());
}

const FilledArea* Occluders::filled_at(std::uint32_t painted) const {
  const auto found = filled_.find(painted);
  return found == filled_.end() ? nullptr : &found->second;
}

/// Appends the parts of a segment, seen or hidden. find_over() must have found the occluders over it.
void Occluders::find_parts(const StepSegment& stroke, std::uint32_t painted, double width_mm, std::vector<SeenPart>& parts) {
  tally_.clear();
  bool at_rim = false;
  for (const std::uint32_t i : over_) {
    const Occluder& occluder = occluders_[i];
    const std::vector<CoveredPart>& covered = coverage_.find(stroke, &occluder.area, occluder.clip.get());
    if (covered.size() == 1 && covered[0].plus && covered[0].minus) return parts.push_back({1, false});
    tally_.add(covered, SideKind::covered, line_of(occluder, width_mm));
    at_rim |= std::ranges::any_of(covered, [](const CoveredPart& part) { return part.plus != part.minus; });
  }
  if (const FilledArea* filled = at_rim ? filled_at(painted) : nullptr) {
    auto own = own_.find(painted);
    if (own == own_.end()) own = own_.emplace(painted, Area(filled->contours, filled->rule, work_)).first;
    tally_.add(coverage_.find(stroke, &own->second, filled->clip.get()), SideKind::own);
  }
  tally_.for_each_part([&](const SideCounts& counts, const Along& end) {
    const auto count = [&](SideKind kind) { return counts[static_cast<std::size_t>(kind)]; };
    const bool hidden = is_hidden(count(SideKind::covered), count(SideKind::own)) || count(SideKind::rim).plus > 0;
    parts.push_back({end.value, !hidden});
  });
}

void Occluders::remove_hidden(Polylines& lines, std::vector<std::uint32_t>& painted, double width_mm) {
  Polylines seen;
  std::vector<std::uint32_t> when;
  LineCutter cutter;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::uint32_t at = painted[i];
    if (covered_.contains(at) && filled_at(at)) continue;
    cutter.cut(lines[i], seen, [&](const StepSegment& stroke, std::vector<SeenPart>& parts) {
      const auto mm = [](StepPoint p) { return Point2(static_cast<double>(p.x), static_cast<double>(p.y)) / kStepsPerMm; };
      find_over(with_margin(mm(stroke.a), mm(stroke.b)), at);
      if (over_.empty()) return parts.push_back({1, true});
      find_parts(stroke, at, width_mm, parts);
    });
    when.resize(seen.size(), at);
  }
  lines = std::move(seen);
  painted = std::move(when);
}

}  // namespace ligne::svg
