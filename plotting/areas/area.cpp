#include "areas/area.hpp"
#include "base/hash.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "areas/work_limit_error.hpp"

namespace ligne::svg {
namespace {

/// Most boxes and edges that all areas of a drawing may look at together; more is endless work.
constexpr std::size_t kMostClipWork = 1'000'000'000;
/// Cost of sorting and applying one change of winding, in tests of an edge.
constexpr std::size_t kChangeWork = 40;
/// Number of edges from which rows across them (WindingRows) save more time than they cost. Adjustable.
constexpr std::size_t kManyEdges = 64;

/// Tests whether a box may hold an edge that meets the line of a stroke at or after the fraction `from` of the stroke.
/// `from` is at most 0: the line may begin before the stroke.
class LineFilter {
 public:
  LineFilter(const StepSegment& stroke, double from)
      : a_x_(static_cast<double>(stroke.a.x)),
        a_y_(static_cast<double>(stroke.a.y)),
        dx_(static_cast<double>(stroke.dx())),
        dy_(static_cast<double>(stroke.dy())),
        reach_(box_of(stroke).grown(kRoundingSteps)) {
    if (dx_ != 0) (dx_ > 0 ? reach_.low_x : reach_.high_x) += dx_ * from;
    if (dy_ != 0) (dy_ > 0 ? reach_.low_y : reach_.high_y) += dy_ * from;
  }

  bool operator()(const StepBox& box) const {
    if (!reach_.meets(box)) return false;
    const double x = (box.low_x + box.high_x) / 2 - a_x_, y = (box.low_y + box.high_y) / 2 - a_y_;
    const double half_x = (box.high_x - box.low_x) / 2 + kRoundingSteps,
                 half_y = (box.high_y - box.low_y) / 2 + kRoundingSteps;
    // The last term exceeds the rounding of the determinant.
    const double p = dx_ * y, q = dy_ * x;
    return std::abs(p - q) <= std::abs(dx_) * half_y + std::abs(dy_) * half_x + 0x1p-48 * (std::abs(p) + std::abs(q));
  }

 private:
  double a_x_, a_y_, dx_, dy_;
  StepBox reach_;
};

/// One edge for several equal ones: the index of the first, and the sum of their windings.
struct Merged {
  StepSegment segment;
  std::size_t first;
  std::int32_t winding;
};

std::vector<Merged> merged(std::vector<Merged> edges, FillRule rule) {
  std::sort(edges.begin(), edges.end(), [](const Merged& p, const Merged& q) {
    return p.segment != q.segment ? p.segment < q.segment : p.first < q.first;
  });
  std::vector<Merged> kept;
  for (std::size_t i = 0; i < edges.size();) {
    Merged one = edges[i];
    for (++i; i < edges.size() && edges[i].segment == one.segment; ++i) one.winding += edges[i].winding;
    if (rule == FillRule::even_odd) one.winding %= 2;
    if (one.winding != 0) kept.push_back(one);
  }
  std::sort(kept.begin(), kept.end(), [](const Merged& p, const Merged& q) { return p.first < q.first; });
  return kept;
}

void add(Polylines& out, std::vector<Point2>& line) {
  if (line.size() > 1) out.add(line);
  line.clear();
}

}  // namespace

void Area::count(std::size_t looked_at) const {
  if ((*work_ += looked_at) > kMostClipWork) throw WorkLimitError("has a clip path that takes too much work");
}

Area::Area(const Polylines& contours, FillRule rule, ClipWork work) : rule_(rule), work_(std::move(work)) {
  std::vector<Merged> all;
  std::vector<std::pair<Point2, Point2>> ends;
  std::vector<std::pair<Point2, StepPoint>> corners;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    corners.clear();
    for (const Point2 p : contours[i]) {
      box_.extend(p);
      const StepPoint at = to_steps(p);
      if (corners.empty() || corners.back().second != at) corners.emplace_back(p, at);
    }
    while (corners.size() > 1 && corners.back().second == corners.front().second) corners.pop_back();
    for (std::size_t k = 0; corners.size() > 1 && k < corners.size(); ++k) {
      const auto& [a, from] = corners[k];
      const auto& [b, to] = corners[k + 1 == corners.size() ? 0 : k + 1];
      all.push_back({from < to ? StepSegment{from, to} : StepSegment{to, from}, ends.size(), from < to ? 1 : -1});
      ends.emplace_back(a, b);
    }
  }
  for (const Merged& edge : merged(std::move(all), rule)) {
    edges_.push_back({ends[edge.first].first, ends[edge.first].second, edge.winding});
    steps_.push_back(edge.segment);
  }
  tree_ = EdgeTree(steps_);
  count(edges_.size());
}

Windings Area::wind_along(const StepSegment& stroke, std::uint32_t number, std::vector<WindingChange>& changes) const {
  Windings at_begin;
  const StepBox box = tree_.box().grown(kRoundingSteps);
  if (steps_.empty() || !box.meets(box_of(stroke))) return at_begin;
  StepBox begin;
  begin.extend(stroke.a);
  // No contour winds round a point outside the box.
  const bool may_begin_inside = box.meets(begin);
  double from = 0;
  if (may_begin_inside) {
    from = -std::numeric_limits<double>::infinity();
    if (const std::optional<Anchor> anchor = anchor_before(stroke)) {
      from = anchor->at;
      at_begin = {anchor->winding, anchor->winding};
    }
  }
  const std::size_t before = changes.size();
  const std::size_t looked_at = tree_.search(
      LineFilter(stroke, from), [&](std::size_t i) { add_changes(i, stroke, from, number, at_begin, changes); });
  count(looked_at + kChangeWork * (changes.size() - before));
  return may_begin_inside ? at_begin : Windings{};
}

/// A point on the line of the stroke, before its start, where the winding is known. Without one the search goes back to
/// infinity, where the winding is 0.
std::optional<Anchor> Area::anchor_before(const StepSegment& stroke) const {
  if (steps_.size() < kManyEdges) return std::nullopt;
  if (!rows_) {
    std::vector<std::int32_t> windings;
    windings.reserve(edges_.size());
    for (const Edge& edge : edges_) windings.push_back(edge.winding);
    rows_ = std::make_shared<const WindingRows>(steps_, windings, tree_.box());
  }
  return rows_->find_before(stroke);
}

/// Adds the changes of winding where the edge crosses the plus side or the minus side of the stroke: it crosses a side
/// if exactly one of its ends lies there. If an end of the stroke lies on the edge, the crossing is moved to that end;
/// if both ends do, to the end near which the edge lies on that side. Crossings before the fraction `from` of the
/// stroke are dropped.
void Area::add_changes(std::size_t i, const StepSegment& stroke, double from, std::uint32_t number, Windings& at_begin,
                       std::vector<WindingChange>& changes) const {
  const StepSegment& edge = steps_[i];
  const Int128 at_a = orientation(stroke, edge.a), at_b = orientation(stroke, edge.b);
  const int a = side_of(stroke, at_a), b = side_of(stroke, at_b);
  if (a == b) return;
  const bool begins_on = lies_on(edge, stroke.a), ends_on = lies_on(edge, stroke.b);
  Along at;
  if (begins_on || ends_on) {
    at = begins_on ? kBegin : kEnd;
  } else {
    at = a == 0 ? nearest_to(stroke, edge.a) : b == 0 ? nearest_to(stroke, edge.b) : crossing(stroke, edge, at_a, at_b);
  }
  const bool runs_along = Int128{stroke.dx()} * edge.dx() + Int128{stroke.dy()} * edge.dy() > 0;
  const std::int32_t winding = edges_[i].winding;
  for (const int side : {1, -1}) {
    if ((a == side) == (b == side)) continue;
    // Crossing an edge from its right to its left adds its winding.
    Windings by;
    (side > 0 ? by.plus : by.minus) = a - b > 0 ? winding : -winding;
    Along where = at;
    if (begins_on && ends_on) where = (a == side) == runs_along ? kBegin : kEnd;
    if (where.value < from) continue;
    if (!is_behind_begin(where)) {
      at_begin.plus += by.plus;
      at_begin.minus += by.minus;
    } else if (is_before_end(where)) {
      changes.push_back({where, number, by});
    }
  }
}

Polylines Area::contours_near(const Rect& box) const {
  Polylines all;
  if (edges_.empty() || box.empty()) return all;
  StepBox near;
  near.extend(to_steps(box.min));
  near.extend(to_steps(box.max));
  std::vector<Point2> line;
  count(tree_.search([&](const StepBox& part) { return near.meets(part); },
                     [&](std::size_t i) {
                       const Edge& e = edges_[i];
                       if (!near.meets(box_of(steps_[i]))) return;
                       if (!line.empty() && line.back() != e.a) add(all, line);
                       if (line.empty()) line.push_back(e.a);
                       line.push_back(e.b);
                       if (e.b == line.front()) add(all, line);
                     }));
  add(all, line);
  return all;
}

bool Area::is_same(const Area& other) const {
  return rule_ == other.rule_ && steps_ == other.steps_ &&
         std::equal(edges_.begin(), edges_.end(), other.edges_.begin(), other.edges_.end(),
                    [](const Edge& p, const Edge& q) { return p.winding == q.winding; });
}

std::size_t Area::hash() const {
  return std::accumulate(steps_.begin(), steps_.end(), steps_.size(), [](std::size_t sum, const StepSegment& s) {
    for (const std::int64_t v : {s.a.x, s.a.y, s.b.x, s.b.y}) sum = extend_hash(sum, static_cast<std::uint64_t>(v));
    return sum;
  });
}

}  // namespace ligne::svg
