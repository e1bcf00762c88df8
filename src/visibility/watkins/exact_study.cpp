#include "visibility/watkins/exact_study.hpp"

#include <mutex>
#include <numeric>

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>

namespace ligne::watkins {

void ExactCounts::operator+=(const ExactCounts& o) {
  sweep += o.sweep;
  stretches += o.stretches;
  spans += o.spans;
  bands += o.bands;
}

ExactResult study_exactly(const std::vector<ProjectedVertex>& vertices, const std::vector<Facet>& facets, std::span<const SweepLine> lines,
                          const ExactOptions& options) {
  const SweepScene scene = make_sweep_scene(vertices, facets, lines);
  const std::vector<SweepBand> bands = make_bands(scene);
  struct BandResult {
    std::vector<Finding> findings;
    std::vector<std::uint32_t> near;
    ExactCounts counts;
  };
  std::vector<BandResult> results(bands.size());
  ExactResult result;
  if (options.penetrations) result.penetrations.assign(bands.size(), PenetrationSearch(facets, vertices));
  std::mutex progress_mutex;
  std::size_t done = 0;
  tbb::parallel_for(std::size_t{0}, bands.size(), [&](std::size_t b) {
    StretchStudy study(vertices, facets, lines, options.coincidence_steps, options.kind);
    ExactSweep sweep(scene, facets, study, options.coincidence_steps + 1, options.penetrations ? &result.penetrations[b] : nullptr);
    sweep.scan(bands[b]);
    results[b] = {sweep.findings(), sweep.near_lines(), {sweep.counts(), study.counts(), study.span_counts(), 1}};
    if (options.progress) {
      const std::lock_guard lock(progress_mutex);
      options.progress(static_cast<double>(++done) / static_cast<double>(bands.size()));
    }
  }, tbb::simple_partitioner{});

  // Seams: a line that runs through several bands gets the findings of all; what they have in common is the same interval.
  result.first.assign(lines.size() + 1, 0);
  result.near.assign(lines.size(), 0);
  for (const BandResult& r : results) {
    for (const Finding& f : r.findings) ++result.first[f.line + 1];
    for (const std::uint32_t l : r.near) result.near[l] = 1;
    result.counts += r.counts;
  }
  std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
  result.intervals.resize(result.first.back());
  std::vector<std::uint32_t> next(result.first.begin(), result.first.end() - 1);
  for (const BandResult& r : results) {
    for (const Finding& f : r.findings) result.intervals[next[f.line]++] = f.interval;
  }
  return result;
}

const std::vector<LinePart>& visible_parts(const ExactResult& result, std::size_t line, OpenParts& open) {
  open.reset(0, 1);
  for (std::uint32_t i = result.first[line]; i < result.first[line + 1]; ++i) open.take(result.intervals[i]);
  return open.finish();
}

}  // namespace ligne::watkins
