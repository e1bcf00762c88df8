#include "studies/operations/visible_sweep.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

namespace ligne::studies {
namespace {

/// True if curve a lies in front of b just behind x. The number decides between curves that coincide.
bool is_in_front(std::span<const PlaneCurve> curves, std::uint32_t a, std::uint32_t b, const OneRoot& x) {
  const CurveMeeting meeting = meeting_of(curves[a], curves[b]);
  if (meeting.coincide) return a < b;
  int order = meeting.order_at_begin;
  for (int i = 0; i < meeting.count; ++i) {
    if (meeting.crosses[i] && !(x < meeting.points[i])) order = -order;
  }
  return order < 0;
}

/// The open and the finished pieces of all curves. A curve has a level while it is visible.
class Pieces {
 public:
  using Level = std::optional<std::uint32_t>;

  explicit Pieces(std::size_t count) : levels_(count), begins_(count) {}

  const Level& level(std::uint32_t curve) const { return levels_[curve]; }

  /// Returns false if the curve has that level already.
  bool change(std::uint32_t curve, const Level& level, const OneRoot& x) {
    if (levels_[curve] == level) return false;
    if (levels_[curve] && begins_[curve] < x) found_.push_back({curve, *levels_[curve], begins_[curve], x});
    levels_[curve] = level;
    begins_[curve] = x;
    return true;
  }

  std::vector<VisiblePiece> take() {
    std::ranges::stable_sort(found_, {}, &VisiblePiece::curve);
    return std::move(found_);
  }

 private:
  std::vector<Level> levels_;
  std::vector<OneRoot> begins_;
  std::vector<VisiblePiece> found_;
};

/// The level of a curve behind one with `level`.
Pieces::Level behind(const PlaneCurve& front, const Pieces::Level& level) {
  if (!level || !front.is_transparent) return std::nullopt;
  return *level + 1;
}

class VisibleSweep {
 public:
  VisibleSweep(std::span<const PlaneCurve> curves, VisibleWork& work)
      : curves_(curves), work_(work), tree_(Order{this}), places_(curves.size(), tree_.end()), pieces_(curves.size()) {
    for (std::uint32_t i = 0; i < curves.size(); ++i) {
      if (curves[i].is_seen_edge_on()) continue;
      queue_[OneRoot(curves[i].left)].begin.push_back(i);
      queue_[OneRoot(curves[i].right)].end.push_back(i);
    }
  }

  std::vector<VisiblePiece> run() {
    while (!queue_.empty()) {
      const auto node = queue_.extract(queue_.begin());
      at_ = node.key();
      ++work_.stops;
      stop(node.mapped());
    }
    return pieces_.take();
  }

 private:
  /// Events at an abscissa.
  struct Stop {
    std::vector<std::uint32_t> begin, end;
    std::vector<std::uint32_t> crossing;  ///< one of each two neighbours that cross
  };
  /// By depth just behind the current stop.
  struct Order {
    const VisibleSweep* sweep;
    bool operator()(std::uint32_t a, std::uint32_t b) const {
      if (a == b) return false;
      ++sweep->work_.comparisons;
      return is_in_front(sweep->curves_, a, b, sweep->at_);
    }
  };
  using Tree = std::set<std::uint32_t, Order>;
  using Place = Tree::iterator;

  bool meet_here(std::uint32_t a, std::uint32_t b) const {
    const CurveMeeting meeting = meeting_of(curves_[a], curves_[b]);
    return meeting.coincide ||
           std::any_of(meeting.points, meeting.points + meeting.count, [&](const OneRoot& p) { return p == at_; });
  }

  /// Finds the next crossing of two neighbours.
  void test(std::uint32_t a, std::uint32_t b) {
    ++work_.pairs;
    const CurveMeeting meeting = meeting_of(curves_[a], curves_[b]);
    for (int i = 0; i < meeting.count; ++i) {
      if (!meeting.crosses[i] || !(at_ < meeting.points[i])) continue;
      queue_[meeting.points[i]].crossing.push_back(a);
      return;
    }
  }

  /// Removes all curves that pass through the point where the curve is at the stop. They are neighbours. Appends those that
  /// go on to `going`, and what stands behind the gap to `changed`.
  void take_out(std::uint32_t curve, std::vector<std::uint32_t>& going, std::vector<std::uint32_t>& changed) {
    if (places_[curve] == tree_.end()) return;  // with another curve of this stop
    Place first = places_[curve], last = std::next(first);
    while (first != tree_.begin() && meet_here(*std::prev(first), *first)) --first;
    while (last != tree_.end() && meet_here(*std::prev(last), *last)) ++last;
    for (Place place = first; place != last; ++place) {
      places_[*place] = tree_.end();
      if (at_ < OneRoot(curves_[*place].right)) {
        going.push_back(*place);
      } else {
        pieces_.change(*place, std::nullopt, at_);
      }
    }
    if (last != tree_.end()) changed.push_back(*last);
    tree_.erase(first, last);
  }

  void stop(const Stop& what) {
    std::vector<std::uint32_t> going = what.begin, changed;
    for (const auto* curves : {&what.crossing, &what.end}) {
      for (const std::uint32_t curve : *curves) take_out(curve, going, changed);
    }
    for (const std::uint32_t curve : going) places_[curve] = tree_.insert(curve).first;
    for (const std::uint32_t curve : going) {
      changed.push_back(curve);
      // The next curve has another one in front, even if that one keeps its level or is hidden from its begin on.
      if (const Place next = std::next(places_[curve]); next != tree_.end()) changed.push_back(*next);
    }
    // A curve found behind a gap may have been taken out later and have ended.
    std::erase_if(changed, [&](std::uint32_t curve) { return places_[curve] == tree_.end(); });
    std::ranges::sort(changed, Order{this});
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    for (const std::uint32_t curve : changed) {
      if (places_[curve] != tree_.begin()) test(*std::prev(places_[curve]), curve);
    }
    for (const std::uint32_t curve : changed) look_again(places_[curve]);
  }

  /// Finds the levels from a curve on, up to one that keeps its level.
  void look_again(Place place) {
    for (; place != tree_.end(); ++place) {
      Pieces::Level level = 0;
      if (place != tree_.begin()) {
        const std::uint32_t front = *std::prev(place);
        level = behind(curves_[front], pieces_.level(front));
      }
      if (!pieces_.change(*place, level, at_)) return;
    }
  }

  std::span<const PlaneCurve> curves_;
  VisibleWork& work_;
  OneRoot at_;
  Tree tree_;
  std::vector<Place> places_;  ///< per curve; the end of the tree if it is not in it
  std::map<OneRoot, Stop> queue_;
  Pieces pieces_;
};

}  // namespace

std::vector<VisiblePiece> visible_by_sweep(std::span<const PlaneCurve> curves, VisibleWork& work) {
  return VisibleSweep(curves, work).run();
}

std::vector<VisiblePiece> visible_by_pairs(std::span<const PlaneCurve> curves) {
  std::vector<OneRoot> stops;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    stops.emplace_back(curves[i].left);
    stops.emplace_back(curves[i].right);
    for (std::size_t k = i + 1; k < curves.size(); ++k) {
      const CurveMeeting meeting = meeting_of(curves[i], curves[k]);
      stops.insert(stops.end(), meeting.points, meeting.points + meeting.count);
    }
  }
  std::sort(stops.begin(), stops.end());
  stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
  Pieces pieces(curves.size());
  std::vector<std::uint32_t> over;
  for (const OneRoot& x : stops) {
    over.clear();
    for (std::uint32_t i = 0; i < curves.size(); ++i) {
      const bool is_over = !(x < OneRoot(curves[i].left)) && x < OneRoot(curves[i].right);
      is_over ? over.push_back(i) : void(pieces.change(i, std::nullopt, x));
    }
    std::ranges::sort(over, [&](std::uint32_t a, std::uint32_t b) { return a != b && is_in_front(curves, a, b, x); });
    Pieces::Level level = 0;
    for (const std::uint32_t i : over) {
      pieces.change(i, level, x);
      level = behind(curves[i], level);
    }
  }
  return pieces.take();
}

}  // namespace ligne::studies
