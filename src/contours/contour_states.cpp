#include "contours/contour_states.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

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

/// A hidden run near a cusp goes to and fro, so that it is as short as the distance of its ends, unless it is this many
/// times longer.
constexpr double kToAndFro = 4;

double weighed_length(const ContourRun& run, const ContourCurve& curve) {
  const CurvePoint from = curve.point_at(run.from), to = curve.point_at(run.to);
  const double length = to.length - from.length;
  return run.state < 0 ? std::max(glm::length(to.mm - from.mm), length / kToAndFro) : length;
}

/// One pass: runs shorter than the limit take the state of the longer neighbour.
void merge_short(std::vector<ContourRun>& runs, const ContourCurve& curve, double limit) {
  const std::size_t n = runs.size();
  if (n < 2) return;
  std::vector<double> lengths(n);
  for (std::size_t i = 0; i < n; ++i) lengths[i] = weighed_length(runs[i], curve);
  if (curve.closed && n > 2 && runs.front().state == runs.back().state) {
    lengths.front() = lengths.back() = lengths.front() + lengths.back();
  }
  std::vector<ContourRun> merged;
  std::vector<int> states(n);
  for (std::size_t i = 0; i < n; ++i) {
    states[i] = runs[i].state;
    if (lengths[i] >= limit) continue;
    const bool first = i == 0, last = i + 1 == n;
    const std::size_t before = first ? (curve.closed ? n - 1 : 1) : i - 1;
    const std::size_t after = last ? (curve.closed ? 0 : n - 2) : i + 1;
    states[i] = lengths[before] >= lengths[after] ? runs[before].state : runs[after].state;
  }
  for (std::size_t i = 0; i < n; ++i) append(merged, {runs[i].from, runs[i].to, states[i]});
  runs = std::move(merged);
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
  // From the shortest up, so that a crowd of tiny runs does not take a longer one with it.
  for (const double share : {1.0 / 16, 1.0 / 8, 1.0 / 4, 1.0 / 2, 1.0}) merge_short(runs, curve, share * shortest_mm);
}

}  // namespace ligne
