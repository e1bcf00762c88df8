#pragma once
/// The counts of the scans as statistics with names.

#include "drawing/statistics.hpp"
#include "visibility/watkins/exact/exact_study.hpp"
#include "visibility/watkins/exact/line_study.hpp"

namespace ligne::watkins {

/// Counts of a scan that stops at every event.
void report(const ExactCounts& counts, Statistics& statistics);
/// Counts of a scan by a number of lines.
void report(const LineStudyResult& result, Statistics& statistics);

}  // namespace ligne::watkins
