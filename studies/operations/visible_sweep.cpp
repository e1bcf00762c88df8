#include "studies/operations/visible_sweep.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace ligne::studies {
namespace {

/// True if curve a lies in front of b just behind x. The curves do not coincide.
bool is_in_front(const PlaneCurve& a, const PlaneCurve& b, const OneRoot& x) {
  const CurveMeeting meeting = meeting_of(a, b);
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

/// A range of a carrier that curves cover without a gap. Runs coincide nowhere.
struct Run {
  PlaneCurve curve;                   ///< over the whole range
  std::set<std::uint32_t> members{};  ///< numbers of the curves over the sweep line, the nearest first
};

class VisibleSweep {
 public:
  VisibleSweep(std::span<const PlaneCurve> curves, VisibleWork& work)
      : curves_(curves), work_(work), tree_(Order{this}), pieces_(curves.size()) {
    make_runs();
    places_.assign(runs_.size(), tree_.end());
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
    std::vector<std::uint32_t> begin, end;  ///< curves
    std::vector<std::uint32_t> crossing;    ///< one of each two neighbouring runs that cross
  };
  /// Runs by depth just behind the current stop.
  struct Order {
    const VisibleSweep* sweep;
    bool operator()(std::uint32_t a, std::uint32_t b) const {
      if (a == b) return false;
      ++sweep->work_.comparisons;
      return is_in_front(sweep->runs_[a].curve, sweep->runs_[b].curve, sweep->at_);
    }
  };
  using Tree = std::set<std::uint32_t, Order>;
  using Place = Tree::iterator;
  /// A curve, or the place behind one that has ended, in the order of depth.
  struct Spot {
    std::uint32_t run, curve;
    bool has_ended;
  };

  void make_runs() {
    std::vector<std::uint32_t> by_carrier(curves_.size());
    std::iota(by_carrier.begin(), by_carrier.end(), 0u);
    std::erase_if(by_carrier, [&](std::uint32_t i) { return curves_[i].is_seen_edge_on(); });
    std::ranges::sort(by_carrier, {}, [&](std::uint32_t i) {
      return std::tuple(carrier_of(curves_[i]), curves_[i].left, curves_[i].right, i);
    });
    run_of_.resize(curves_.size());
    std::array<std::int64_t, 4> carrier{};
    for (const std::uint32_t i : by_carrier) {
      const PlaneCurve& curve = curves_[i];
      if (runs_.empty() || carrier != carrier_of(curve) || curve.left >= runs_.back().curve.right) {
        runs_.push_back({curve});
      } else if (PlaneCurve& run = runs_.back().curve; run.right < curve.right) {
        run.right = curve.right;
        run.z_right = curve.z_right;
      }
      carrier = carrier_of(curve);
      run_of_[i] = static_cast<std::uint32_t>(runs_.size() - 1);
    }
  }

  bool meet_here(std::uint32_t a, std::uint32_t b) const {
    const CurveMeeting meeting = meeting_of(runs_[a].curve, runs_[b].curve);
    return std::any_of(meeting.points, meeting.points + meeting.count, [&](const OneRoot& p) { return p == at_; });
  }

  /// Finds the next crossing of two neighbours.
  void test(std::uint32_t a, std::uint32_t b) {
    ++work_.pairs;
    const CurveMeeting meeting = meeting_of(runs_[a].curve, runs_[b].curve);
    for (int i = 0; i < meeting.count; ++i) {
      if (!meeting.crosses[i] || !(at_ < meeting.points[i])) continue;
      queue_[meeting.points[i]].crossing.push_back(a);
      return;
    }
  }

  /// Removes all runs that pass through the point where the run is at the stop. They are neighbours. Appends those that go
  /// on to `going`, and what stands behind the gap to `behind_gaps`.
  void take_out(std::uint32_t run, std::vector<std::uint32_t>& going, std::vector<std::uint32_t>& behind_gaps) {
    if (places_[run] == tree_.end()) return;  // with another run of this stop
    Place first = places_[run], last = std::next(first);
    while (first != tree_.begin() && meet_here(*std::prev(first), *first)) --first;
    while (last != tree_.end() && meet_here(*std::prev(last), *last)) ++last;
    for (Place place = first; place != last; ++place) {
      places_[*place] = tree_.end();
      if (at_ < OneRoot(runs_[*place].curve.right)) going.push_back(*place);
    }
    if (last != tree_.end()) behind_gaps.push_back(*last);
    tree_.erase(first, last);
  }

  void stop(const Stop& what) {
    std::vector<std::uint32_t> going, behind_gaps;
    std::vector<Spot> spots;
    for (const std::uint32_t run : what.crossing) take_out(run, going, behind_gaps);
    for (const std::uint32_t curve : what.end) {
      const std::uint32_t run = run_of_[curve];
      if (runs_[run].curve.right == curves_[curve].right) take_out(run, going, behind_gaps);
      runs_[run].members.erase(curve);
      pieces_.change(curve, std::nullopt, at_);
      spots.push_back({run, curve, true});
    }
    for (const std::uint32_t curve : what.begin) {
      const std::uint32_t run = run_of_[curve];
      if (runs_[run].members.empty()) going.push_back(run);
      runs_[run].members.insert(curve);
      spots.push_back({run, curve, false});
    }
    for (const std::uint32_t run : going) places_[run] = tree_.insert(run).first;
    test_neighbours(going, behind_gaps);
    for (const auto* runs : {&going, &behind_gaps}) {
      for (const std::uint32_t run : *runs) {
        if (places_[run] == tree_.end()) continue;  // found behind a gap and taken out later
        spots.push_back({run, 0, true});
        // The run behind has another one in front, even where that one keeps its levels.
        if (const Place next = std::next(places_[run]); next != tree_.end()) spots.push_back({*next, 0, true});
      }
    }
    find_levels(spots);
  }

  void test_neighbours(const std::vector<std::uint32_t>& going, const std::vector<std::uint32_t>& behind_gaps) {
    for (const auto* runs : {&going, &behind_gaps}) {
      for (const std::uint32_t run : *runs) {
        const Place place = places_[run];
        if (place == tree_.end()) continue;
        if (place != tree_.begin()) test(*std::prev(place), run);
        if (const Place next = std::next(place); next != tree_.end()) test(run, *next);
      }
    }
  }

  void find_levels(std::vector<Spot>& spots) {
    std::erase_if(spots, [&](const Spot& spot) { return places_[spot.run] == tree_.end(); });
    std::ranges::sort(spots, [&](const Spot& a, const Spot& b) {
      if (a.run != b.run) return Order{this}(a.run, b.run);
      return std::pair(a.curve, !a.has_ended) < std::pair(b.curve, !b.has_ended);
    });
    for (const Spot& spot : spots) {
      const auto& members = runs_[spot.run].members;
      look_again(spot.run, members.lower_bound(spot.curve));
      // The curve behind one that begins has another one in front, even where that one is hidden and changes no level.
      if (!spot.has_ended) look_again(spot.run, members.upper_bound(spot.curve));
    }
  }

  /// The level behind all members of a run.
  Pieces::Level level_behind(std::uint32_t run) const {
    const std::uint32_t last = *runs_[run].members.rbegin();
    return behind(curves_[last], pieces_.level(last));
  }

  /// Finds the levels from a member on, up to one that keeps its level.
  void look_again(std::uint32_t run, std::set<std::uint32_t>::const_iterator member) {
    for (Place place = places_[run]; place != tree_.end(); ++place, member = runs_[*place].members.begin()) {
      const auto& members = runs_[*place].members;
      for (; member != members.end(); ++member) {
        Pieces::Level level = 0;
        if (member != members.begin()) {
          level = behind(curves_[*std::prev(member)], pieces_.level(*std::prev(member)));
        } else if (place != tree_.begin()) {
          level = level_behind(*std::prev(place));
        }
        if (!pieces_.change(*member, level, at_)) return;
      }
      if (std::next(place) == tree_.end()) return;
    }
  }

  std::span<const PlaneCurve> curves_;
  VisibleWork& work_;
  std::vector<Run> runs_;
  std::vector<std::uint32_t> run_of_;  ///< per curve
  OneRoot at_;
  Tree tree_;
  std::vector<Place> places_;  ///< per run; the end of the tree if it is not in it
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
    std::ranges::sort(over, [&](std::uint32_t a, std::uint32_t b) {
      if (a == b || meeting_of(curves[a], curves[b]).coincide) return a < b;
      return is_in_front(curves[a], curves[b], x);
    });
    Pieces::Level level = 0;
    for (const std::uint32_t i : over) {
      pieces.change(i, level, x);
      level = behind(curves[i], level);
    }
  }
  return pieces.take();
}

}  // namespace ligne::studies
