#include "contours/outline_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include <glm/geometric.hpp>

#include "geometry/nearest_on_segment.hpp"
#include "geometry/parallel.hpp"

namespace ligne {
namespace {

constexpr double kEvidenceCellMm = 2;
/// Contours are asked about at steps of this length, mm; long edges are listed in pieces of it.
constexpr double kEvidenceStepMm = 1;

/// What an outline beside a contour says: it is seen; hidden; hidden in a hollow, which says little.
enum class Evidence : std::uint8_t { none, hollow, hidden, seen };

/// The edges of the outline on the page, in seen and hidden pieces.
class OutlinePieces {
 public:
  OutlinePieces() : finder_(kEvidenceCellMm) {}

  void expect(Point2 p, double reach) { finder_.expect(p - Point2(reach), p + Point2(reach)); }
  void add(Point2 from, Point2 to, Evidence evidence) {
    const auto pieces = static_cast<int>(std::ceil(std::max(1.0, glm::length(to - from) / kEvidenceStepMm)));
    for (int k = 0; k < pieces; ++k) {
      const auto at = [&](int i) { return from + double(i) / pieces * (to - from); };
      finder_.add({at(k), at(k + 1), 0, 0, static_cast<std::uint32_t>(evidence)});
    }
  }
  /// The strongest within reach.
  Evidence at(Point2 p, double reach) const {
    auto strongest = static_cast<std::uint32_t>(Evidence::none);
    finder_.near(p - Point2(reach), p + Point2(reach), [&](const PageSegment& s) {
      if (s.chain <= strongest) return;
      const Point2 nearest = s.from + nearest_on_segment(p, s.from, s.to) * (s.to - s.from);
      if (glm::length(nearest - p) <= reach) strongest = s.chain;
    });
    return static_cast<Evidence>(strongest);
  }

 private:
  SegmentFinder finder_;  ///< PageSegment::chain: the evidence
};

/// A part of a visible run, and where it is asked about.
struct Part {
  double from, to;  ///< as CurvePoint::at
  Point2 middle;
  double reach;
  double length;
};

std::vector<Part> parts_of_run(const ContourRun& run, const ContourCurve& curve, const ContourChain& chain) {
  std::vector<Part> parts;
  for (double from = run.from; from < run.to;) {
    const double segment = std::min(std::floor(from), double(chain.size() - 1));
    const double end = std::min(run.to, segment + 1);
    const double length = curve.point_at(end).length - curve.point_at(from).length;
    const auto steps = static_cast<int>(std::ceil(std::max(1.0, length / kEvidenceStepMm)));
    const auto i = static_cast<std::size_t>(segment);
    const double reach = std::max(chain.nodes[i].most_mm, chain.nodes[i + 1].most_mm);
    for (int k = 0; k < steps; ++k) {
      const auto at = [&](double step) { return from + step / steps * (end - from); };
      parts.push_back({at(k), k + 1 == steps ? end : at(k + 1), curve.point_at(at(k + 0.5)).mm, reach, length / steps});
    }
    from = end;
  }
  return parts;
}

/// The parts of a visible run that are hidden.
std::vector<ContourRun> hidden_parts(std::span<const Part> parts, const OutlinePieces& pieces, double shortest_mm) {
  std::vector<ContourRun> hidden;
  double length = 0, all = 0, hollow = 0;
  bool any_seen = false, open = false;
  const auto finish = [&] {
    if (open && length <= shortest_mm) hidden.pop_back();
    open = false;
  };
  for (const Part& part : parts) {
    const Evidence evidence = pieces.at(part.middle, part.reach);
    any_seen |= evidence == Evidence::seen;
    all += part.length;
    if (evidence == Evidence::hollow || evidence == Evidence::hidden) hollow += part.length;
    if (evidence != Evidence::hidden) {
      finish();
      continue;
    }
    if (!open) {
      hidden.push_back({part.from, part.to, kHiddenState});
      length = 0;
      open = true;
    }
    hidden.back().to = part.to;
    length += part.length;
  }
  finish();
  // Where nothing of the outline is seen all along, hollows hide it too.
  if (!any_seen && 2 * hollow > all) return {{parts.front().from, parts.back().to, kHiddenState}};
  return hidden;
}

}  // namespace

void hide_behind_outlines(std::vector<SeenContour>& seen, const SmoothContours& contours, const View& view,
                          const Lattice& lattice, const std::vector<Stroke>& edges, double shortest_mm) {
  std::vector<std::vector<std::vector<Part>>> parts(seen.size());  // by contour and visible run
  parallel_tasks(seen.size(), [&](std::size_t c) {
    for (const ContourRun& run : seen[c].runs) {
      if (run.state >= 0 && run.from < run.to) parts[c].push_back(parts_of_run(run, seen[c].curve, contours.chains[c]));
    }
  });
  OutlinePieces pieces;
  for (const auto& of_contour : parts) {
    for (const std::vector<Part>& of_run : of_contour) {
      for (const Part& part : of_run) pieces.expect(part.middle, part.reach);
    }
  }
  auto stroke = edges.begin();
  for (std::size_t k = 0; k < contours.replaced.size(); ++k) {
    const auto& ends = contours.replaced[k].ends;
    const auto place = [&](double t) { return page_point(view, ends[0] + t * (ends[1] - ends[0])); };
    const Evidence unseen = contours.bulges[k] ? Evidence::hidden : Evidence::hollow;
    double hidden_from = 0;
    for (; stroke != edges.end() && stroke->source == contours.first_edge + k; ++stroke) {
      if (!stroke->visible) continue;
      if (hidden_from < stroke->t_from) pieces.add(place(hidden_from), place(stroke->t_from), unseen);
      pieces.add(lattice.to_mm(stroke->from), lattice.to_mm(stroke->to), Evidence::seen);
      hidden_from = stroke->t_to;
    }
    if (hidden_from < 1) pieces.add(place(hidden_from), place(1), unseen);
  }
  parallel_tasks(seen.size(), [&](std::size_t c) {
    std::vector<ContourRun> hidden;
    for (const std::vector<Part>& of_run : parts[c]) {
      const std::vector<ContourRun> found = hidden_parts(of_run, pieces, shortest_mm);
      hidden.insert(hidden.end(), found.begin(), found.end());
    }
    if (!hidden.empty()) hide(seen[c].runs, hidden);
  });
}

}  // namespace ligne
