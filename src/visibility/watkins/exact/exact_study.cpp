#include "visibility/watkins/exact/exact_study.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <optional>

#include "base/parallel.hpp"
#include "visibility/common/facet.hpp"
#include "visibility/watkins/exact/sweep_scene.hpp"

namespace ligne::watkins {
namespace {

/// The facets that matter to a scan for a few lines.

/// Grid cells along each side of the page. Tuned.
constexpr std::uint32_t kCells = 512;

/// The lattice cells that a line crosses.
class CellMarks {
 public:
  explicit CellMarks(double margin) : margin_(margin), marked_(std::size_t{kCells} * kCells, 0) {}

  /// Marks the cells row by row, with the margin on all sides.
  void mark(const SweepLine& line) {
    LatticePoint a = line.from.p, b = line.to.p;
    if (b.y < a.y) std::swap(a, b);
    const std::uint32_t last = cell(b.y + margin_);
    for (std::uint32_t row = cell(a.y - margin_); row <= last; ++row) {
      double x0 = a.x, x1 = b.x;
      if (b.y > a.y) {
        const double slope = (double(b.x) - a.x) / (double(b.y) - a.y);
        const double y0 = std::clamp(row * kSize - kLatticeLimit - margin_, double(a.y), double(b.y));
        const double y1 = std::clamp((row + 1) * kSize - kLatticeLimit + margin_, double(a.y), double(b.y));
        x0 = a.x + (y0 - a.y) * slope;
        x1 = a.x + (y1 - a.y) * slope;
      }
      const std::uint32_t end = cell(std::max(x0, x1) + margin_);
      for (std::uint32_t column = cell(std::min(x0, x1) - margin_); column <= end; ++column)
        marked_[std::size_t{row} * kCells + column] = 1;
    }
  }

  bool any(double x0, double y0, double x1, double y1) const {
    const std::uint32_t c0 = cell(x0), c1 = cell(x1), last = cell(y1);
    for (std::uint32_t row = cell(y0); row <= last; ++row) {
      const auto begin = marked_.begin() + static_cast<std::ptrdiff_t>(std::size_t{row} * kCells);
      if (std::find(begin + c0, begin + c1 + 1, 1) != begin + c1 + 1) return true;
    }
    return false;
  }

 private:
  static constexpr double kSize = 2.0 * kLatticeLimit / kCells;

  static std::uint32_t cell(double v) {
    return static_cast<std::uint32_t>(std::clamp((v + kLatticeLimit) / kSize, 0.0, kCells - 1.0));
  }

  double margin_;
  std::vector<std::uint8_t> marked_;
};

/// The facets near any of the lines on the page, in order: all that can hide a line or lie along it.
std::vector<Facet> facets_near(std::span<const SweepLine> lines, const std::vector<Facet>& facets,
                               const std::vector<ProjectedVertex>& vertices, double margin_steps) {
  CellMarks marks(margin_steps);
  for (const SweepLine& line : lines) {
    if (line.to_study()) marks.mark(line);
  }
  std::vector<Facet> near;
  for (const Facet& f : facets) {
    const LatticePoint a = vertices[f.v[0]].p, b = vertices[f.v[1]].p, c = vertices[f.v[2]].p;
    const auto [x0, x1] = std::minmax({a.x, b.x, c.x});
    const auto [y0, y1] = std::minmax({a.y, b.y, c.y});
    if (marks.any(x0, y0, x1, y1)) near.push_back(f);
  }
  return near;
}

}  // namespace

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
    : intervals_(line_count, [&](const auto& put) {
        for (const auto& band : findings) {
          for (const Finding& f : band) put(f.line, f.interval);
        }
      }) {}

const std::vector<LinePart>& FoundIntervals::visible_parts(std::size_t line, OpenParts& open) const {
  open.reset(0, 1);
  for (const HiddenInterval& interval : intervals_[line]) {
    if (open.empty()) break;
    open.take(interval);
  }
  return open.finish();
}

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

}  // namespace ligne::watkins
