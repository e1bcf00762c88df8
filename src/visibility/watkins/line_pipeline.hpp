#pragma once
/// The scan by lines in two tasks ([Boulle1980] 2.3.6.3): one prepares the segments of the lines that follow, the other
/// studies the lines that are prepared.
///
/// [Boulle1980] gives each task a processor, and they meet on every line. Here they meet after `ahead` lines, so the work
/// is in proportion to the meetings that it pays for; with 1 it is as there. A step is two independent tasks, so any number
/// of threads gives the same result and none waits for one that has not begun.
///
/// The first task knows what enters, ends and changes places, but not what is visible. So it can not recognise changes
/// among hidden elements (2.3.5.5): it asks for a study after every change, as 2.3.5.1 does.

#include <cstdint>
#include <vector>

#include "visibility/watkins/line_scan.hpp"

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

}  // namespace ligne::watkins
