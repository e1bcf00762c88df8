#include "drawing/cleanup/loose_ends.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "base/key_table.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "drawing/graphs/point_tree.hpp"
#include "drawing/graphs/stroke_chains.hpp"
#include "drawing/near_part.hpp"
#include "drawing/overlaps/stroke_index.hpp"

namespace ligne {
namespace {

/// Smallest cosine of the turn at a bridged gap, where ink hides it and where it is seen. Taste.
constexpr double kLeastCosine = 0.5, kStraightCosine = 0.94;
/// A bridge that is seen needs lines at least this many times as long as itself. Taste.
constexpr double kLongInGaps = 2;
/// Bridges of at least this many gaps are far: their lines must be straighter, and longer in proportion. Taste.
constexpr double kFarPartInGaps = 3, kFarCosine = 0.985, kLongInFar = 4;
/// Lines within 4 degrees of one line may be shorter in proportion, for bridges of up to this many gaps: a rim whose facets
/// are hidden at intervals is a row of such lines. Taste.
constexpr double kRowInGaps = 6, kRowCosine = 0.9976, kLongInRow = 1.5;
/// Most rounds of joining: a joined line may have become long enough for another bridge.
constexpr int kMostRounds = 3;
/// Two ends that are fewer lattice steps apart have no direction from one to the other: each is rounded by itself.
constexpr double kRoundedSteps = 8;
/// A chain whose own ends are joined has at least this many gaps, or a speck would become a ring.
constexpr double kRingInGaps = 4;

/// Factor above the roundings of a squared distance.
constexpr double kAbout = 1 + 0x1p-40;

struct LooseEnd {
  std::uint32_t stroke;
  bool at_from;
  std::uint32_t nearest = kNone;  ///< of the others that it may be joined to
  LatticePoint point{};
  double dx = 0, dy = 0, length = 0;  ///< the stroke's way to the end
};

class LooseEnds {
 public:
  LooseEnds(const std::vector<Stroke>& strokes, double gap, double wide) : chains_(strokes), gap_(gap), wide_(wide) {
    for (const std::uint32_t i : chains_.seen()) {
      const Stroke& s = strokes[i];
      if (!is_edge(s) || s.line_class == LineClass::mesh || s.from == s.to) continue;
      for (const bool at_from : {true, false}) {
        if (!chains_.is_free(i, at_from)) continue;
        ends_.push_back({i, at_from});
        LooseEnd& end = ends_.back();
        end.point = at_from ? s.from : s.to;
        const LatticePoint start = at_from ? s.to : s.from;
        end.dx = double(end.point.x) - start.x;
        end.dy = double(end.point.y) - start.y;
        end.length = page_length(s);
      }
    }
    std::vector<LatticePoint> points;
    points.reserve(ends_.size());
    for (const LooseEnd& end : ends_) points.push_back(end.point);
    tree_ = PointTree(points);
    parallel_blocks(ends_.size(), kSearchBlock, [&](std::size_t begin, std::size_t last) {
      for (std::size_t e = begin; e < last; ++e) ends_[e].nearest = nearest(static_cast<std::uint32_t>(e));
    });
  }

  /// Calls join(end, end) for each two that are each other's nearest.
  template <class Join>
  void pairs(const Join& join) const {
    for (std::uint32_t e = 0; e < ends_.size(); ++e) {
      const std::uint32_t other = ends_[e].nearest;
      if (other != kNone && other > e && ends_[other].nearest == e) join(ends_[e], ends_[other]);
    }
  }

  bool shows(const LooseEnd& a, const LooseEnd& b) const { return length(a.point, b.point) >= gap_; }
  bool is_of(const LooseEnd& end, std::uint32_t stroke) const {
    return chains_.chain_of(stroke) == chains_.chain_of(end.stroke);
  }
  const std::vector<std::uint32_t>& seen() const { return chains_.seen(); }
  double line_length(const LooseEnd& end) const { return chains_.chain(chains_.chain_of(end.stroke)).length; }

 private:
  static double length(LatticePoint a, LatticePoint b) { return std::hypot(double(b.x) - a.x, double(b.y) - a.y); }

  static double along(const LooseEnd& e, LatticePoint p) {
    return e.dx * (double(p.x) - e.point.x) + e.dy * (double(p.y) - e.point.y);
  }

  /// The line goes on towards the point; a stroke shorter than the way to it has no direction that says anything.
  bool leads_to(const LooseEnd& e, LatticePoint p, double distance) const {
    if (distance <= kRoundedSteps) return true;
    const bool shows = distance >= gap_, far = distance >= kFarPartInGaps * gap_;
    if (e.length <= distance && !shows) return true;
    const double cosine = along(e, p) / (e.length * distance);
    const bool in_row = distance < kRowInGaps * gap_ && cosine >= kRowCosine;
    const double least = !far ? kLongInGaps : in_row ? kLongInRow : kLongInFar;
    if (shows && line_length(e) < least * distance) return false;
    return cosine >= (far ? kFarCosine : shows ? kStraightCosine : kLeastCosine);
  }

  /// leads_to() is false, as can be told in a moment: where thousands of lines end side by side, nearly all others are asked
  /// about in vain.
  static bool leads_away(const LooseEnd& e, LatticePoint p, double squared_distance) {
    return along(e, p) < 0 && e.length * e.length > kAbout * squared_distance &&
           squared_distance > kAbout * kRoundedSteps * kRoundedSteps;
  }

  /// leads_to() is false for all points of the box: where thousands of lines end side by side, nearly all of these lie
  /// beside the line, outside of the cone in which points lie to which it may lead.
  static bool leads_away(const LooseEnd& e, const PointBox& box) {
    static const double sine = std::sqrt(1 - kLeastCosine * kLeastCosine);
    constexpr double kRounding = 1;  // steps
    for (const double side : {-1.0, 1.0}) {
      // The inner normal of a side of the cone, as long as the stroke.
      const double nx = sine * e.dx - side * kLeastCosine * e.dy, ny = sine * e.dy + side * kLeastCosine * e.dx;
      const double x = (nx > 0 ? box.high.x : box.low.x) - double(e.point.x);
      const double y = (ny > 0 ? box.high.y : box.low.y) - double(e.point.y);
      if (nx * x + ny * y < -kRounding * e.length) return true;
    }
    return false;
  }

  std::uint32_t nearest(std::uint32_t e) const {
    const LooseEnd& end = ends_[e];
    const LatticePoint p = end.point;
    std::uint32_t best = kNone;
    double best_distance = wide_;
    const auto enter = [&](const PointBox& box) {
      const double squared = box.squared_distance(p);
      if (squared > kAbout * best_distance * best_distance) return false;
      const bool is_apart = end.length > wide_ && squared > kAbout * kRoundedSteps * kRoundedSteps;
      return !is_apart || !leads_away(end, box);
    };
    tree_.search(p, enter, [&](std::uint32_t o) {
      if (o == e) return;
      const LooseEnd& other = ends_[o];
      const LatticePoint q = other.point;
      const double dx = double(q.x) - p.x, dy = double(q.y) - p.y, squared = dx * dx + dy * dy;
      if (squared > kAbout * best_distance * best_distance) return;
      if (leads_away(end, q, squared) || leads_away(other, p, squared)) return;
      const double distance = length(p, q);
      if (distance >= wide_ || distance > best_distance || (distance == best_distance && o > best)) return;
      const bool same = chains_.chain_of(end.stroke) == chains_.chain_of(other.stroke);
      if (same && line_length(end) < kRingInGaps * gap_) return;
      if (!leads_to(end, q, distance) || !leads_to(other, p, distance)) return;
      best = o;
      best_distance = distance;
    });
    return best;
  }

  StrokeChains chains_;
  double gap_, wide_;
  PointTree tree_;  ///< of the ends
  std::vector<LooseEnd> ends_;
};

struct Joint {
  Stroke stroke;
  const LooseEnd *a, *b;
  bool blocked = false;  ///< it shows, and another line is in its way
};

/// Joints in the cells of a grid.
class JointGrid {
 public:
  JointGrid(double cell, double reach) : grid_(cell, reach) {}

  void add(std::uint32_t joint, const Stroke& stroke) {
    grid_.walk(stroke.from, stroke.to, [&](std::uint64_t cell) {
      std::uint32_t& first = cells_[cell];
      links_.emplace_back(joint, first);
      first = static_cast<std::uint32_t>(links_.size() - 1);
      return false;
    });
  }
  bool empty() const { return links_.empty(); }
  /// Calls found(joint) for those that the stroke may come near, some more than once, until it returns true; true when it
  /// did.
  template <class Found>
  bool near(const Stroke& stroke, const Found& found) const {
    return grid_.walk(stroke.from, stroke.to, [&](std::uint64_t cell) {
      for (std::uint32_t l = cells_.find(cell); l != kNone; l = links_[l].second) {
        if (found(links_[l].first)) return true;
      }
      return false;
    });
  }

 private:
  SegmentGrid grid_;
  KeyTable cells_;                                              // of each cell the first link
  std::vector<std::pair<std::uint32_t, std::uint32_t>> links_;  // joint, next link
};

/// Finds the lines in the way of the joints that show.
void block(std::vector<Joint>& joints, const LooseEnds& ends, const std::vector<Stroke>& strokes, double wide,
           double clear) {
  JointGrid grid(walked_cell(strokes, 2 * wide), clear);
  for (std::uint32_t j = 0; j < joints.size(); ++j) {
    if (ends.shows(*joints[j].a, *joints[j].b)) grid.add(j, joints[j].stroke);
  }
  if (grid.empty()) return;
  for (const std::uint32_t i : ends.seen()) {
    grid.near(strokes[i], [&](std::uint32_t j) {
      Joint& joint = joints[j];
      if (joint.blocked || ends.is_of(*joint.a, i) || ends.is_of(*joint.b, i)) return false;
      joint.blocked = !part_near(joint.stroke, strokes[i], clear).empty();
      return false;
    });
  }
}

/// Takes out the hidden strokes that lie all along joints: they are the line that is seen now.
void drop_hidden(std::vector<Stroke>& strokes, const std::vector<Joint>& joints, double wide, double clear) {
  if (joints.empty() || !any_hidden(strokes)) return;
  JointGrid grid(walked_cell(strokes, 2 * wide), clear);
  for (std::uint32_t j = 0; j < joints.size(); ++j) grid.add(j, joints[j].stroke);
  std::erase_if(strokes, [&](const Stroke& s) {
    return !s.visible && s.from != s.to && grid.near(s, [&](std::uint32_t j) {
      const StrokePart part = part_near(s, joints[j].stroke, clear);
      return part.from == 0 && part.to == 1;
    });
  });
}

std::size_t join_once(StrokeModel& model, const JointLimits& limits, const MakeSource& make_source) {
  const double step = model.lattice.step_mm;
  const LooseEnds ends(model.strokes, limits.gap_mm / step, limits.wide_mm / step);
  std::vector<Joint> joints;
  ends.pairs([&](const LooseEnd& a, const LooseEnd& b) {
    const Stroke &s = model.strokes[a.stroke], &t = model.strokes[b.stroke];
    Stroke joint = ends.line_length(a) < ends.line_length(b) ? t : s;
    joint.t_from = 0;
    joint.t_to = 1;
    joint.from = a.point;
    joint.to = b.point;
    joint.z_from = a.at_from ? s.z_from : s.z_to;
    joint.z_to = b.at_from ? t.z_from : t.z_to;
    joint.w_from = a.at_from ? s.w_from : s.w_to;
    joint.w_to = b.at_from ? t.w_from : t.w_to;
    joints.push_back({joint, &a, &b});
  });
  block(joints, ends, model.strokes, limits.wide_mm / step, limits.clear_mm / step);
  std::erase_if(joints, [](const Joint& joint) { return joint.blocked; });
  for (Joint& joint : joints) {
    model.intersections.push_back(make_source(joint.stroke));
    joint.stroke.source = model.edge_count + static_cast<std::uint32_t>(model.intersections.size()) - 1;
  }
  drop_hidden(model.strokes, joints, limits.wide_mm / step, limits.clear_mm / step);
  for (const Joint& joint : joints) model.strokes.push_back(joint.stroke);
  return joints.size();
}

}  // namespace

std::size_t join_loose_ends(StrokeModel& model, const JointLimits& limits, const MakeSource& make_source) {
  std::size_t joined = 0;
  for (int round = 0; round < kMostRounds; ++round) {
    const std::size_t count = join_once(model, limits, make_source);
    joined += count;
    if (count == 0) break;
  }
  return joined;
}

}  // namespace ligne
