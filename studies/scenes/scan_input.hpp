#pragma once
/// Scenes as input of a scan by lines, and the cost of a scan.

#include <cstdint>
#include <string>
#include <vector>

#include "studies/experiments.hpp"
#include "visibility/watkins/exact/line_study.hpp"

namespace ligne::studies {

/// A scene on A4 with its lines of intersection, which tell the scan where faces penetrate each other.
struct ScanInput {
  std::string name;
  ProjectedScene scene;
  std::vector<Facet> facets;
  std::vector<watkins::SweepLine> lines;
};

ScanInput make_scan_input(const NamedScene& named);

/// The cost of scanning the whole page with one group of lines, so no seam breaks the coherence.
struct ScanCost {
  double seconds = 0;  ///< time of the scan alone, least of several runs
  watkins::ScanCounts scan;
  watkins::SpanCounts spans;
};

ScanCost scan_cost(const ScanInput& input, std::uint32_t lines, bool whole, const watkins::ScanOptions& options, int times);

/// The scenes of the scan line experiments: squares, a city, a ball, penetrating boxes, and the models.
std::vector<NamedScene> scan_scenes(const StudyRequest& request);

}  // namespace ligne::studies
