#pragma once
/// The exact scan of one band of the page. It stops only at vertices and at crossings of edges.
///
/// Invariant: between two stops the active list has the edges in their order on the scan line, and the cover of every gap is
/// the set of facets over it. A stop changes list and covers only at its place. A line is studied from one of its own stops
/// to the next (StretchStudy); stops elsewhere, and crossings between hidden edges, cost it nothing.
///
/// Crossings are computed in doubles, so two stops closer than the rounding error may come in the wrong order. This is
/// harmless. Exact determinants decide which of two neighbours is left where the first of them ends, and a pair is exchanged
/// at most once. So the list corrects itself, and the wrong part is shorter than a thousandth of a lattice step.

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "base/add_counts.hpp"
#include "visibility/watkins/exact/crossing_queue.hpp"
#include "visibility/watkins/exact/stretch_study.hpp"
#include "visibility/watkins/exact/sweep_scene.hpp"
#include "visibility/watkins/exact/sweep_status.hpp"

namespace ligne::watkins {

struct SweepCounts {
  std::uint64_t points = 0;     ///< stops at ends of edges
  std::uint64_t crossings = 0;  ///< stops where edges cross
  std::uint64_t hidden_crossings =
      0;                          ///< of these, between hidden edges that are no lines: only the list changes (figure 2.59)
  std::uint64_t searches = 0;     ///< points that needed a search, because no edge ends there (dangling vertices)
  std::uint64_t most_active = 0;  ///< largest length of the active list
  void operator+=(const SweepCounts& o) {
    const std::uint64_t most = std::max(most_active, o.most_active);
    add_counts(*this, o);
    most_active = most;
  }
};

/// The part of a line hidden by a facet.
struct Finding {
  std::uint32_t line;
  HiddenInterval interval;
};

class ExactSweep {
 public:
  /// `pairs`, which may be null, is called where facets begin to overlap. Edges within `near_steps` of each other may
  /// coincide.
  ExactSweep(const SweepScene& scene, StretchStudy& study, double near_steps, PairFinder* pairs, ScanEffort& effort)
      : scene_(scene), study_(study), near_steps_(near_steps), pairs_(pairs), effort_(effort) {}

  /// Scans the band, or stops when the effort is spent; the findings are then incomplete.
  void scan(const SweepBand& band);

  const std::vector<Finding>& findings() const { return findings_; }
  const std::vector<std::uint32_t>& near_lines() const { return near_lines_; }  ///< lines along which another line lies
  const SweepCounts& counts() const { return counts_; }

 private:
  /// The states of the lines of one edge.
  struct EdgeState {
    std::vector<LineState> lines;
  };

  void begin(const SweepBand& band);
  void at_crossings(double y, double x);
  void at_point(std::uint32_t point);
  bool still_to_come(const Crossing& c) const;
  void finish(double y, double x);

  void find_range(std::uint32_t point, std::uint32_t& before, std::uint32_t& last);
  void draw_in(std::uint32_t slot, std::uint32_t& before, std::uint32_t& last);
  void collect_edges(std::uint32_t point, std::uint32_t before, std::uint32_t last);
  void exchange(std::uint32_t left_slot);
  void join(std::uint32_t left_slot);
  void check_pair(std::uint32_t left_slot);
  void close(std::uint32_t slot, double x, double y);
  bool neighbour_along(std::uint32_t slot, double x, double y) const;
  void open(std::uint32_t node, double x, double y);
  void toggle_node(std::uint32_t node, Cover& cover);
  void end_edge(std::uint32_t local);
  void facets_of(std::uint32_t node, std::vector<std::uint32_t>& facets) const;

  std::uint32_t local_of(std::uint32_t edge) const;
  const SweepEdge& edge(std::uint32_t local) const {
    return scene_.edges[local < active_->size() ? (*active_)[local] : first_edge_ + (local - active_->size())];
  }
  bool through(std::uint32_t slot, LatticePoint p) const {
    const SweepNode& n = status_.node(status_.node_at(slot));
    return side(n.top, n.bottom, p) == 0;
  }
  std::uint32_t make_node(std::span<const std::uint32_t> edges, double x, double y);

  const SweepScene& scene_;
  StretchStudy& study_;
  double near_steps_;
  PairFinder* pairs_;
  ScanEffort& effort_;

  SweepStatus status_;
  CrossingQueue queue_;
  const std::vector<std::uint32_t>* active_ = nullptr;
  std::uint32_t first_edge_ = 0;
  std::vector<std::uint32_t> node_of_, next_in_node_, state_of_;  ///< by local edge
  std::vector<EdgeState> states_;
  std::vector<std::uint32_t> free_states_;
  double x_ = 0, y_ = 0;  ///< current place of the scan
  std::uint64_t active_count_ = 0;

  std::vector<std::uint32_t> going_on_, touched_, old_nodes_;  ///< scratch of at_point()
  std::vector<std::uint32_t> left_facets_, right_facets_;      ///< scratch of exchange()
  std::vector<Finding> findings_;
  std::vector<std::uint32_t> near_lines_;
  SweepCounts counts_;
};

}  // namespace ligne::watkins
