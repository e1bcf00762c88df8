#include "visibility/watkins/report_counts.hpp"

#include <string>

namespace ligne::watkins {
namespace {

void report(const SpanCounts& counts, Statistics& statistics) {
  for (const auto& [name, value] : counts.named()) statistics.count("span method: " + std::string(name), value);
}

}  // namespace

void report(const ExactCounts& counts, Statistics& statistics) {
  statistics.count("bands", counts.bands);
  statistics.count("events at points", counts.sweep.points);
  statistics.count("of these, dangling vertices", counts.sweep.searches);
  statistics.count("events at crossings", counts.sweep.crossings);
  statistics.count("of these, without a line", counts.sweep.hidden_crossings);
  statistics.count("longest active list", counts.sweep.most_active);
  statistics.count("line intervals", counts.stretches.stretches);
  statistics.count("line intervals known to be hidden", counts.stretches.carried);
  statistics.count("line intervals with nothing in front", counts.stretches.in_front);
  statistics.count("scan lines studied", counts.stretches.studied);
  statistics.count("line-facet tests", counts.stretches.facet_tests);
  report(counts.spans, statistics);
}

void report(const LineStudyResult& result, Statistics& statistics) {
  statistics.count("groups of lines", result.groups);
  statistics.count("scan lines", result.scan.lines);
  statistics.count("scan lines studied", result.scan.studied);
  statistics.count("of these, at the beginning of a group", result.scan.studied_first);
  statistics.count("of these, where edges are exchanged", result.scan.studied_exchanges);
  statistics.count("of these, where edges enter or end", result.scan.studied_ends);
  statistics.count("segments on them", result.scan.segments);
  statistics.count("edges that entered", result.scan.entered);
  statistics.count("exchanges of edges between lines", result.scan.exchanges);
  statistics.count("changes skipped: continued edges", result.scan.passed_chains);
  statistics.count("changes skipped: hidden points", result.scan.passed_points);
  statistics.count("changes skipped: hidden exchanges", result.scan.passed_exchanges);
  statistics.count("edges examined", result.tracking.positions);
  statistics.count("line-facet tests", result.tracking.facet_tests);
  report(result.span_method, statistics);
}

}  // namespace ligne::watkins
