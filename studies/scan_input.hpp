#pragma once
/// Scenes as a scan by lines takes them, and what a scan costs.

#include <cstdint>
#include <string>
#include <vector>

#include "studies/experiments.hpp"
#include "visibility/watkins/exact/line_study.hpp"

namespace ligne::studies {

/// A scene on A4, with its lines of intersection: without them a scan would not know where faces come
/// out of each other.
struct ScanInput {
  std::string name;
  ProjectedScene scene;
  std::vector<Facet> facets;
  std::vector<watkins::SweepLine> lines;
};

ScanInput make_scan_input(const NamedScene& named);

/// The cost of a scan of the whole page by one group of lines; no seam breaks the coherence.
struct ScanCost {
  double seconds = 0;  ///< of the scan alone, the least of some
  watkins::ScanCounts scan;
  watkins::SpanCounts spans;
};

ScanCost scan_cost(const ScanInput& input, std::uint32_t lines, bool whole, const watkins::ScanOptions& options, int times);

/// The scenes over which the experiments on scan lines go: squares, a city, a ball, boxes that penetrate, and the models.
std::vector<NamedScene> scan_scenes(const StudyRequest& request);

}  // namespace ligne::studies
