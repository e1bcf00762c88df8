#pragma once
/// Named statistics from the counts of the scans.

#include "drawing/statistics.hpp"
#include "visibility/watkins/exact/exact_study.hpp"
#include "visibility/watkins/exact/line_study.hpp"

namespace ligne::watkins {

/// Counts of an exact scan.
void report(const ExactCounts& counts, Statistics& statistics);
/// Counts of a scan by lines.
void report(const LineStudyResult& result, Statistics& statistics);

}  // namespace ligne::watkins
