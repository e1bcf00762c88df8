#include "visibility/watkins/exact/exact_study.hpp"

#include <atomic>
#include <mutex>
#include <numeric>
#include <optional>

#include "base/parallel.hpp"
#include "visibility/watkins/exact/facets_near.hpp"

namespace ligne::watkins {

void ExactCounts::operator+=(const ExactCounts& o) {
  sweep += o.sweep;
  stretches += o.stretches;
  spans += o.spans;
  bands += o.bands;
}

ExactResult study_exactly(const std::vector<ProjectedVertex>& vertices, const std::vector<Facet>& all_facets,
                          std::span<const SweepLine> lines, const ExactOptions& options) {
  // Penetrations may be anywhere; without them only facets near a line matter.
  const std::vector<Facet> near =
      options.penetrations ? std::vector<Facet>{} : facets_near(lines, all_facets, vertices, options.coincidence_steps + 1);
  const std::vector<Facet>& facets = options.penetrations ? all_facets : near;
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
  std::atomic<bool> gave_up = false;  // set when a band has given up, which makes the whole study void
  std::mutex progress_mutex;
  std::size_t done = 0;
  parallel_tasks(bands.size(), [&](std::size_t b) {
    if (gave_up) return;
    ScanEffort effort(bands[b].end - bands[b].first);
    StretchStudy study(vertices, facets, lines, options.coincidence_steps, options.kind, effort);
    std::optional<PairFinder> pairs;
    if (options.penetrations) pairs.emplace(facets, result.penetrations[b], options.covers, effort);
    ExactSweep sweep(scene, study, options.coincidence_steps + 1, pairs ? &*pairs : nullptr, effort);
    sweep.scan(bands[b]);
    results[b] = {sweep.findings(), sweep.near_lines(), {sweep.counts(), study.counts(), study.span_counts(), 1}};
    if (effort.spent()) gave_up = true;
    if (options.progress) {
      const std::lock_guard lock(progress_mutex);
      options.progress(static_cast<double>(++done) / static_cast<double>(bands.size()));
    }
  });

  if (gave_up) {
    result.gave_up = true;
    result.penetrations.clear();
    return result;
  }
  result.near.assign(lines.size(), 0);
  std::vector<std::vector<Finding>> findings;
  for (BandResult& r : results) {
    findings.push_back(std::move(r.findings));
    for (const std::uint32_t l : r.near) result.near[l] = 1;
    result.counts += r.counts;
  }
  result.found = FoundIntervals(findings, lines.size());
  return result;
}

std::vector<Intersection> take_intersections(ExactResult& result, const std::vector<ProjectedVertex>& vertices,
                                             const std::vector<Facet>& facets, double least_steps) {
  PenetrationSearch all(facets, vertices);
  for (PenetrationSearch& p : result.penetrations) all.add(std::move(p));
  result.penetrations.clear();
  return all.finish(least_steps);
}

FoundIntervals::FoundIntervals(const std::vector<std::vector<Finding>>& findings, std::size_t line_count)
    : first_(line_count + 1, 0) {
  for (const auto& band : findings) {
    for (const Finding& f : band) ++first_[f.line + 1];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  intervals_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (const auto& band : findings) {
    for (const Finding& f : band) intervals_[next[f.line]++] = f.interval;
  }
}

const std::vector<LinePart>& FoundIntervals::visible_parts(std::size_t line, OpenParts& open) const {
  open.reset(0, 1);
  for (std::uint32_t i = first_[line]; i < first_[line + 1] && !open.empty(); ++i) open.take(intervals_[i]);
  return open.finish();
}

}  // namespace ligne::watkins
