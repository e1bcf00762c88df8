#pragma once
/// The exact scan of one band of the page: it stops at every vertex and at every crossing of edges, and nowhere else.
///
/// Invariant: between two stops the active list is ordered as the edges lie on the scan line, and the cover of every gap is
/// the set of facets over it. A stop changes the list and the covers only there where it is. A line is studied from one of
/// its own stops to the next (StretchStudy); what happens elsewhere, and what hidden edges do among each other, costs it
/// nothing.
///
/// Crossings are computed in doubles, so two stops closer than rounding may come in the wrong order. That is harmless: each
/// pair of neighbours is asked by exact determinants which of the two is left where the first of them ends, and exchanged at
/// most once, so the list mends itself, and what was misjudged on the way is shorter than a thousandth of a lattice step.

#include <cstdint>
#include <span>
#include <vector>

#include "visibility/watkins/exact/crossing_queue.hpp"
#include "visibility/watkins/exact/pair_finder.hpp"
#include "visibility/watkins/exact/stretch_study.hpp"
#include "visibility/watkins/exact/sweep_scene.hpp"
#include "visibility/watkins/exact/sweep_status.hpp"

namespace ligne::watkins {

struct SweepCounts {
  std::uint64_t points = 0;     ///< stops at ends of edges
  std::uint64_t crossings = 0;  ///< stops where edges cross
  std::uint64_t hidden_crossings =
      0;  ///< of them: of edges that bound nothing seen and are no lines: only the list changes (figure 2.59)
  std::uint64_t searches = 0;     ///< points that had to be looked for, because no edge ends there (dangling vertices)
  std::uint64_t most_active = 0;  ///< longest active list
  void operator+=(const SweepCounts& o);
};

/// The part of a line that a facet hides.
struct Finding {
  std::uint32_t line;
  HiddenInterval interval;
};

class ExactSweep {
 public:
  /// `pairs` is called where facets begin to overlap; it may be null. Edges no farther apart than `near_steps` may lie on
  /// each other.
  ExactSweep(const SweepScene& scene, StretchStudy& study, double near_steps, PairFinder* pairs, ScanEffort& effort)
      : scene_(scene), study_(study), near_steps_(near_steps), pairs_(pairs), effort_(effort) {}

  /// Until the effort is spent: then what is found is not all.
  void scan(const SweepBand& band);

  const std::vector<Finding>& findings() const { return findings_; }
  const std::vector<std::uint32_t>& near_lines() const { return near_lines_; }  ///< lines with another one along them
  const SweepCounts& counts() const { return counts_; }

 private:
  /// States of the lines of one edge.
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
  double x_ = 0, y_ = 0;  ///< where the scan stands
  std::uint64_t active_count_ = 0;

  std::vector<std::uint32_t> going_on_, touched_, old_nodes_;  ///< working memory of at_point()
  std::vector<std::uint32_t> left_facets_, right_facets_;      ///< and of exchange()
  std::vector<Finding> findings_;
  std::vector<std::uint32_t> near_lines_;
  SweepCounts counts_;
};

}  // namespace ligne::watkins
