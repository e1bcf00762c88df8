#pragma once
/// A whole page by scan lines: groups of lines in parallel (Kaplan and Greenberg 1979), with strokes and spans joined across
/// the seams.

#include <cstdint>
#include <span>
#include <vector>

#include "drawing/result_models.hpp"
#include "visibility/watkins/exact/exact_study.hpp"
#include "visibility/watkins/line_scan.hpp"
#include "visibility/watkins/state_tracking.hpp"

namespace ligne::watkins {

/// A line as the first task hands it to the second: its edges in order, its segments, and whether anything changed.
struct PreparedLine {
  std::uint32_t line = 0;
  bool first = false, exchanged = false;  ///< it begins a group; edges have changed places
  bool study = true;                      ///< otherwise the spans of the line before are carried on
  std::vector<ActiveEdge> slots;
  std::vector<std::uint32_t> order, gone, ended_edges;
  std::vector<SegmentEnds> ends;
  std::vector<ScanSegment<double>> real_segments;
  std::vector<ScanSegment<std::int32_t>> whole_segments;
};

/// Seconds that the two tasks have worked.
struct PipelineTimes {
  double preparing = 0, studying = 0;
};

/// Scans the lines [first, end). The scans have the same scene and options, without ScanOptions::recognise.
PipelineTimes scan_in_two_tasks(LineScan& preparing, LineScan& studying, std::uint32_t first, std::uint32_t end,
                                std::uint32_t ahead);

struct LineStudyOptions {
  ScanOptions scan{};
  double coincidence_steps = 0;
  bool track = true;  ///< computes the hidden parts of the lines
  bool collect_spans = false;
  /// Scan lines per group; 0: about 32 groups, for any number of threads. The first line of each group is studied.
  std::uint32_t group = 0;
  bool states = false;              ///< track edges by their states, too
  std::uint32_t ahead = 0;          ///< lines prepared ahead in two tasks; 0: one task does both
  const SkewFaces* skew = nullptr;  ///< faces of the scene without a plane; null: none
};

struct LineStudyResult {
  FoundIntervals found;
  std::vector<Span> spans;  ///< line by line, from left to right
  ScanCounts scan;
  SpanCounts span_method;
  TrackCounts tracking;
  std::uint64_t groups = 0;
  TrackedParts by_states;                ///< if LineStudyOptions::states
  std::vector<Intersection> points;      ///< then: marks where faces penetrate without an edge, line by line
  std::vector<PenetrationPoint> places;  ///< then: these points in grid units
  std::vector<Intersection> curves;      ///< then: where skew faces penetrate others
  PipelineTimes pipeline;
};

LineStudyResult study_by_lines(const ProjectedScene& scene, const std::vector<Facet>& facets,
                               std::span<const SweepLine> lines, const LineGrid& grid, const LineStudyOptions& options);

/// The scan lines of spans on the page. `whole`: with whole coordinates.
LineGrid grid_of(const ProjectedScene& scene, const SpanLines& lines, bool whole);

/// `count` scan lines over the height of the window, each in the middle of its strip. `whole`: with whole coordinates.
LineGrid grid_of_lines(const ProjectedScene& scene, std::uint32_t count, bool whole = false);

void report(const LineStudyResult& result, Statistics& statistics);

}  // namespace ligne::watkins
