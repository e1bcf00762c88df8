#include "contours/contour_states.hpp"

#include <algorithm>

namespace ligne {
namespace {

void append(std::vector<ContourRun>& runs, const ContourRun& run) {
  if (!(run.from < run.to)) return;
  if (!runs.empty() && runs.back().state == run.state) {
    runs.back().to = run.to;
  } else {
    runs.push_back(run);
  }
}

}  // namespace

std::vector<ContourRun> runs_of(const std::vector<Stroke>& strokes, std::uint32_t first_source, std::size_t segments,
                                bool hidden_too) {
  std::vector<ContourRun> runs;
  auto stroke = std::lower_bound(strokes.begin(), strokes.end(), first_source,
                                 [](const Stroke& s, std::uint32_t source) { return s.source < source; });
  for (std::size_t i = 0; i < segments; ++i) {
    const std::uint32_t source = first_source + static_cast<std::uint32_t>(i);
    const double at = double(i);
    double end = 0;
    const int other = hidden_too ? kOutsideState : kHiddenState;
    for (; stroke != strokes.end() && stroke->source == source; ++stroke) {
      append(runs, {at + end, at + stroke->t_from, other});
      append(runs, {at + stroke->t_from, at + stroke->t_to, stroke->visible ? int(stroke->level) : kHiddenState});
      end = stroke->t_to;
    }
    append(runs, {at + end, at + 1, other});
  }
  return runs;
}

void put_in(std::vector<ContourRun>& runs, const std::vector<ContourRun>& changed) {
  std::vector<ContourRun> out;
  auto next = changed.begin();
  for (const ContourRun& run : runs) {
    double from = run.from;
    for (; next != changed.end() && next->from < run.to; ++next) {
      append(out, {from, next->from, run.state});
      append(out, {std::max(from, next->from), next->to, next->state});
      from = next->to;
    }
    append(out, {from, run.to, run.state});
  }
  runs = std::move(out);
}

void drop_short_runs(std::vector<ContourRun>& runs, const ContourCurve& curve, double shortest_mm) {
  const std::size_t n = runs.size();
  if (n < 2) return;
  std::vector<double> lengths(n);
  for (std::size_t i = 0; i < n; ++i) lengths[i] = curve.point_at(runs[i].to).length - curve.point_at(runs[i].from).length;
  if (curve.closed && n > 2 && runs.front().state == runs.back().state) {
    lengths.front() = lengths.back() = lengths.front() + lengths.back();
  }
  std::vector<ContourRun> merged;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t before = i > 0 ? i - 1 : curve.closed ? n - 1 : 1;
    const std::size_t after = i + 1 < n ? i + 1 : curve.closed ? 0 : n - 2;
    const std::size_t longer = lengths[before] >= lengths[after] ? before : after;
    append(merged, {runs[i].from, runs[i].to, runs[lengths[i] < shortest_mm ? longer : i].state});
  }
  runs = std::move(merged);
}

}  // namespace ligne
