#include "contours/surfaces/outline_probes.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "base/disjoint_sets.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "contours/contour_sights.hpp"
#include "contours/surfaces/lines_beside.hpp"
#include "linework/map/nodes.hpp"
#include "view/clip.hpp"

namespace ligne {
namespace {

// Adjustable parameters.
/// Distance of a probe behind its edge: kPushedBack of the object's size, but at least kPushedBackEdges lengths of the
/// edge. Folds of a mesh go back by a triangle or two, and beyond a cusp a surface stays steep for a few more.
constexpr double kPushedBack = 0.25;
constexpr double kPushedBackEdges = 10;
/// Number of steps from triangle to triangle, over sides, in which a fold of a coarse mesh comes back below its edge.
constexpr int kFoldSteps = 5;
/// Distance of a probe beside its edge on the page, as a fraction of the edge's length there, or of the size of its
/// triangles if that is less.
constexpr double kMovedOff = 0.05;
/// Largest distance of a contour from an edge that it replaces, as a fraction of the size of the triangles there; at
/// least half a pen width is allowed. Contours rise above chords by less than an eighth of their length.
constexpr double kNearEdge = 0.2;
/// Length of the tail that counts as the end of a contour, in reaches: a contour may turn inwards before it ends.
constexpr double kTailInReaches = 2;

/// The visible pieces of contours.
class VisibleContours {
 public:
  VisibleContours(const std::vector<SeenContour>& seen, const Lattice& lattice, double reach_mm)
      : reach_mm_(reach_mm), pieces_(lattice), tails_(lattice) {
    for (const SeenContour& contour : seen) {
      const ContourCurve& curve = contour.curve;
      const std::size_t n = contour.runs.size();
      for (std::size_t r = 0; r < n; ++r) {
        const ContourRun& run = contour.runs[r];
        if (run.state < 0) continue;
        std::vector<CurvePoint> points = curve.part(run.from, run.to);
        unfold(points, reach_mm_);  // as it is drawn
        for (std::size_t i = 1; i < points.size(); ++i) pieces_.add(points[i - 1].mm, points[i].mm);
        const auto ends = [&](bool first) {
          if (first ? r > 0 : r + 1 < n) return contour.runs[first ? r - 1 : r + 1].state < 0;
          return !curve.closed || contour.runs[first ? n - 1 : 0].state < 0;
        };
        if (ends(false)) add_tail(points);
        if (!ends(true)) continue;
        std::reverse(points.begin(), points.end());
        add_tail(points);
      }
    }
  }
  const LinesBeside& pieces() const { return pieces_; }
  /// The last parts of the pieces before their ends.
  const LinesBeside& tails() const { return tails_; }

 private:
  void add_tail(const std::vector<CurvePoint>& points) {
    double left = kTailInReaches * reach_mm_;
    for (std::size_t i = points.size(); --i > 0 && left > 0;) {
      tails_.add(points[i - 1].mm, points[i].mm);
      left -= glm::length(points[i].mm - points[i - 1].mm);
    }
  }

  double reach_mm_;
  LinesBeside pieces_, tails_;
};

/// The place where a part of an edge ends: at an end of the edge, where its probe becomes hidden, or where a contour begins
/// to run beside it.
enum class EndAt : std::uint8_t { vertex, hidden, contour };

/// A part of an edge whose probe is visible.
struct Candidate {
  Stroke stroke;  ///< its stroke on the edge itself
  std::uint32_t edge;
  Point2 middle;
  double near_mm;
  /// Distance within which the end of a contour belongs to its own ends. Where it was cut beside a contour, the two
  /// may be as far apart as the contour and the edge.
  std::array<double, 2> end_reach_mm{0, 0};
  std::array<EndAt, 2> end_at{EndAt::vertex, EndAt::vertex};
  std::array<std::optional<Point2>, 2> crossing{};  ///< where the edge goes behind another line near that end
};

Candidate candidate(const Stroke& probe, std::uint32_t edge, const SmoothContours& contours, const View& view,
                    const Lattice& lattice, double pen_width_mm) {
  const auto& ends = contours.replaced[edge].ends;
  const HomogeneousPoint a = to_homogeneous(view, ends[0]), b = to_homogeneous(view, ends[1]);
  const HomogeneousPoint from = interpolate(a, b, probe.t_from), to = interpolate(a, b, probe.t_to);
  const auto mm = [](const HomogeneousPoint& h) { return Point2{h.x / h.w, h.y / h.w}; };
  Candidate c{probe, edge, (mm(from) + mm(to)) * 0.5, 0};
  c.stroke.from = lattice.snap(mm(from));
  c.stroke.to = lattice.snap(mm(to));
  c.stroke.z_from = static_cast<float>(from.z / from.w);
  c.stroke.z_to = static_cast<float>(to.z / to.w);
  if (view.camera.perspective) {
    c.stroke.w_from = static_cast<float>(from.w);
    c.stroke.w_to = static_cast<float>(to.w);
  }
  c.stroke.needs_overlap_check = true;
  c.end_at = {probe.t_from > 0 ? EndAt::hidden : EndAt::vertex, probe.t_to < 1 ? EndAt::hidden : EndAt::vertex};
  c.near_mm = std::max(pen_width_mm / 2, kNearEdge * contours.replaced_size_mm[edge]);
  return c;
}

/// Candidates and parts of candidates that no contour replaces. `alone`: no contour is near their middle, in any
/// direction. `beside`: no contour runs along them.
struct Missing {
  std::vector<Candidate> alone, beside;
};

/// The contours and the page on which they are drawn.
struct ProbePage {
  const SmoothContours& contours;
  const View& view;
  const Lattice& lattice;
  double pen_width_mm, reach_mm;
};

void look_at(const Candidate& c, const VisibleContours& near, const ProbePage& page, Missing& missing) {
  const auto& [contours, view, lattice, pen_width_mm, reach_mm] = page;
  const auto is_alone = [&](Point2 p) { return !near.pieces().any_within(p, c.near_mm); };
  if (is_alone(c.middle)) {
    missing.alone.push_back(c);
    return;
  }
  const Point2 from = lattice.to_mm(c.stroke.from), to = lattice.to_mm(c.stroke.to);
  for (const auto& [first, last] : near.pieces().uncovered(from, to, c.near_mm, pen_width_mm / 2)) {
    const auto at = [&](double fraction) {
      return fraction == 1 ? c.stroke.t_to : c.stroke.t_from + fraction * (c.stroke.t_to - c.stroke.t_from);
    };
    Stroke stroke = c.stroke;
    stroke.t_from = at(first);
    stroke.t_to = at(last);
    Candidate part = candidate(stroke, c.edge, contours, view, lattice, pen_width_mm);
    const double cut_reach_mm = std::max(reach_mm, c.near_mm);
    part.end_reach_mm = {first > 0 ? cut_reach_mm : reach_mm, last < 1 ? cut_reach_mm : reach_mm};
    part.end_at = {first > 0 ? EndAt::contour : c.end_at[0], last < 1 ? EndAt::contour : c.end_at[1]};
    (is_alone(part.middle) ? missing.alone : missing.beside).push_back(part);
  }
}

/// The nodes of candidates, and after them of others.
Nodes nodes_of(const std::vector<Candidate>& candidates, const std::vector<Candidate>& others = {}) {
  std::vector<Stroke> strokes;
  strokes.reserve(candidates.size() + others.size());
  for (const Candidate& c : candidates) strokes.push_back(c.stroke);
  for (const Candidate& c : others) strokes.push_back(c.stroke);
  return Nodes(strokes);
}

/// Sets of the first `count` candidates that are connected.
DisjointSets connected(const Nodes& nodes, std::size_t count) {
  DisjointSets runs(count);
  for (std::uint32_t end = 0; end < 2 * count; ++end) runs.join(end / 2, nodes.first(nodes.of(end)) / 2);
  return runs;
}

/// Removes connected runs of candidates that are shorter than the reach or than Candidate::near_mm, and returns them: ends
/// moved to crossings leave such remnants.
std::vector<Candidate> take_short(std::vector<Candidate>& candidates, const Lattice& lattice, double reach_mm) {
  DisjointSets runs = connected(nodes_of(candidates), candidates.size());
  std::vector<double> length(candidates.size(), 0), least(candidates.size(), reach_mm);
  for (std::uint32_t i = 0; i < candidates.size(); ++i) {
    const Candidate& c = candidates[i];
    length[runs.find(i)] += glm::length(lattice.to_mm(c.stroke.to) - lattice.to_mm(c.stroke.from));
    least[runs.find(i)] = std::max(least[runs.find(i)], c.near_mm);
  }
  std::vector<Candidate> kept, taken;
  for (std::uint32_t i = 0; i < candidates.size(); ++i) {
    (length[runs.find(i)] >= least[runs.find(i)] ? kept : taken).push_back(candidates[i]);
  }
  candidates = std::move(kept);
  return taken;
}

/// Keeps the runs whose two ends both meet an end of a contour, an end of `others`, a visible outline of the mesh, or a line
/// behind which the edge goes. Outlines do not count if they run beside the whole run. One such end is enough if no contour
/// is near it, and if a contour begins to run beside the edge at the other end.
void keep_between_ends(std::vector<Candidate>& parts, const std::vector<Candidate>& others, const VisibleContours& near,
                       const StrokeModel& model, double pen_width_mm) {
  if (parts.empty()) return;
  LinesBeside outlines(model.lattice);
  for (const Stroke& s : model.strokes) {
    if (s.visible && s.line_class == LineClass::outline)
      outlines.add(model.lattice.to_mm(s.from), model.lattice.to_mm(s.to));
  }
  const Nodes nodes = nodes_of(parts, others);
  const auto end_count = static_cast<std::uint32_t>(2 * parts.size());
  DisjointSets runs = connected(nodes, parts.size());
  std::vector<std::uint8_t> apart(parts.size(), 0);
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    const Stroke& s = parts[i].stroke;
    const Point2 from = model.lattice.to_mm(s.from), to = model.lattice.to_mm(s.to);
    apart[runs.find(i)] |= !outlines.uncovered(from, to, parts[i].near_mm, 0).empty();
  }
  std::vector<std::uint32_t> open(parts.size(), 0), met(parts.size(), 0);
  std::vector<std::uint8_t> leads_away(parts.size(), 0), leads_to_contour(parts.size(), 0);
  for (std::uint32_t end = 0; end < end_count; ++end) {
    bool continues = false, meets_other = false;
    nodes.for_each_end(nodes.of(end), [&](std::uint32_t e) { (e < end_count ? continues : meets_other) |= e != end; });
    if (continues) continue;
    Candidate& part = parts[end / 2];
    const std::uint32_t run = runs.find(end / 2);
    ++open[run];
    const Point2 from = model.lattice.to_mm(part.stroke.from), to = model.lattice.to_mm(part.stroke.to);
    const Point2 mm = end % 2 == 0 ? from : to;
    const double reach_mm = part.end_reach_mm[end % 2];
    if (part.end_at[end % 2] == EndAt::hidden) {
      std::optional<Point2>& crossing = part.crossing[end % 2];
      crossing = outlines.crossing(mm, to - from, reach_mm);
      if (!crossing) crossing = near.pieces().crossing(mm, to - from, reach_mm);
    }
    const bool meets = meets_other || near.tails().any_within(mm, reach_mm) || part.crossing[end % 2] ||
                       (apart[run] && outlines.any_within(mm, pen_width_mm / 2));
    met[run] += meets;
    leads_to_contour[run] |= !meets && part.end_at[end % 2] == EndAt::contour;
    leads_away[run] |= meets && !near.pieces().any_within(mm, part.near_mm);
  }
  std::vector<Candidate> kept;
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    const std::uint32_t run = runs.find(i);
    if (open[run] == 2 && (met[run] == 2 || (leads_away[run] && leads_to_contour[run]))) kept.push_back(parts[i]);
  }
  parts = std::move(kept);
}

/// Whether a triangle covers a point of the page.
bool covers(const std::array<Point2, 3>& p, Point2 q) {
  int left = 0, right = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point2 along = p[(k + 1) % 3] - p[k], to = q - p[k];
    const double side = along.x * to.y - along.y * to.x;
    left += side >= 0;
    right += side <= 0;
  }
  return left == 3 || right == 3;
}

/// Whether the mesh goes back below the probe of a side, whose ends on the page are given, within few triangles from it.
bool folds_back(const Scene& scene, const View& view, const SmoothPatch& patch, std::uint32_t side,
                const std::array<Point2, 2>& probe) {
  std::vector<std::uint32_t> triangles{side / 3, patch.across[side] / 3};
  std::size_t begin = 0;
  for (int step = 0; step < kFoldSteps; ++step) {
    const std::size_t end = triangles.size();
    for (; begin < end; ++begin) {
      for (std::uint32_t s = 3 * triangles[begin]; s < 3 * triangles[begin] + 3; ++s) {
        const std::uint32_t across = patch.across[s];
        if (across == kNone || std::ranges::find(triangles, across / 3) != triangles.end()) continue;
        triangles.push_back(across / 3);
        std::array<Point2, 3> p;
        for (std::uint32_t k = 0; k < 3; ++k) p[k] = page_point(view, scene.vertices[patch.triangles[across / 3].v[k]]);
        for (const double part : {0.25, 0.5, 0.75}) {
          if (covers(p, probe[0] + part * (probe[1] - probe[0]))) return true;
        }
      }
    }
  }
  return false;
}

}  // namespace

std::array<Point3, 2> outline_probe(const Scene& scene, const View& view, const SmoothPatch& patch, std::uint32_t side,
                                    const ProbeOffsets& offsets) {
  const auto point = [&](std::uint32_t corner) { return scene.vertices[patch.triangles[corner / 3].v[corner % 3]]; };
  const Point3 a = point(side), b = point(next_corner(side));
  const Point2 pa = page_point(view, a), d = page_point(view, b) - pa;
  const double length = glm::length(d);
  // Away from the third corners, which both lie on one side of an outline.
  Point2 off = length > 0 ? Point2{-d.y, d.x} / length : Point2{0, 0};
  const Point2 inwards = page_point(view, point(previous_corner(side))) +
                         page_point(view, point(previous_corner(patch.across[side]))) - 2.0 * pa;
  if (glm::dot(off, inwards) > 0) off = -off;
  const double off_mm = offsets.slack_mm + kMovedOff * std::min(length, offsets.size_mm);
  const double at_least = kPushedBack * offsets.object_size, far = kPushedBackEdges * glm::length(b - a);
  const std::array<Point2, 2> beside{pa + off_mm * off, pa + d + off_mm * off};
  const bool is_fold = far < at_least || folds_back(scene, view, patch, side, beside);
  const double back = is_fold ? std::max(at_least, far) : 0;
  const auto moved = [&](const Point3& p) {
    const double unit_mm = glm::length(page_direction(view, p, view.camera.right));
    const Point3 beside = p + (off_mm / unit_mm) * (off.x * view.camera.right + off.y * view.camera.down);
    return beside - back * glm::normalize(to_eye(view.camera, beside));
  };
  return {moved(a), moved(b)};
}

double size_on_page(const Scene& scene, const View& view, const SmoothPatch& patch, std::uint32_t side) {
  const auto point = [&](std::uint32_t corner) { return scene.vertices[patch.triangles[corner / 3].v[corner % 3]]; };
  const Point3 a = point(side), along = point(next_corner(side)) - a;
  double longest = 0, height = 0;
  for (const std::uint32_t s : {side, patch.across[side]}) {
    std::array<Point2, 3> p;
    for (std::uint32_t k = 0; k < 3; ++k) p[k] = page_point(view, point(s - s % 3 + k));
    longest = std::max({longest, glm::length(p[1] - p[0]), glm::length(p[2] - p[1]), glm::length(p[0] - p[2])});
    height = std::max(height, glm::length(glm::cross(along, point(previous_corner(s)) - a)));
  }
  const double unit_mm = glm::length(page_direction(view, a, view.camera.right)), length = glm::length(along);
  if (!(length > 0)) return longest;
  // The surface rises above its chord by an eighth of the length times the turn of the normals along it.
  const Point3 turn = patch.normals[patch.sector[next_corner(side)]] - patch.normals[patch.sector[side]];
  const double rise = std::abs(glm::dot(turn, along)) / 8;
  // The contour of two slender triangles, as along a cylinder, is as near to their edge as they are wide and it rises.
  return std::min(longest, unit_mm * (height / length + rise) / kNearEdge);
}

void add_missing_outlines(StrokeModel& model, const View& view, const SmoothContours& contours,
                          const std::vector<Stroke>& probes, const std::vector<SeenContour>& seen, const ProbeSizes& sizes) {
  const double pen_width_mm = sizes.pen_width_mm, reach_mm = sizes.reach_mm;
  const ProbePage page{contours, view, model.lattice, pen_width_mm, reach_mm};
  std::vector<Candidate> candidates;
  for (const Stroke& probe : probes) {
    if (!probe.visible) continue;
    candidates.push_back(candidate(probe, probe.source - contours.first_probe, contours, view, model.lattice, pen_width_mm));
    candidates.back().end_reach_mm = {reach_mm, reach_mm};
  }
  if (candidates.empty()) return;
  const VisibleContours near(seen, model.lattice, reach_mm);
  std::vector<Missing> found(block_count(candidates.size(), kSearchBlock));
  parallel_blocks(candidates.size(), kSearchBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) look_at(candidates[i], near, page, found[begin / kSearchBlock]);
  });
  std::vector<Candidate> missing, parts;
  for (const Missing& m : found) {
    missing.insert(missing.end(), m.alone.begin(), m.alone.end());
    parts.insert(parts.end(), m.beside.begin(), m.beside.end());
  }
  // Short ones stay only where they lie between the ends of other lines.
  const std::vector<Candidate> remnants = take_short(missing, model.lattice, reach_mm);
  parts.insert(parts.end(), remnants.begin(), remnants.end());
  keep_between_ends(parts, missing, near, model, pen_width_mm);
  missing.insert(missing.end(), parts.begin(), parts.end());
  const Nodes nodes = nodes_of(missing);
  for (std::uint32_t i = 0; i < missing.size(); ++i) {
    Candidate& c = missing[i];
    for (const std::uint32_t side : {0u, 1u}) {
      if (nodes.degree(nodes.of(2 * i + side)) > 1) continue;
      LatticePoint& end = side == 0 ? c.stroke.from : c.stroke.to;
      if (c.crossing[side]) {
        end = model.lattice.snap(*c.crossing[side]);
      } else if (const auto contour = near.pieces().nearest_end(model.lattice.to_mm(end), c.end_reach_mm[side])) {
        end = model.lattice.snap(*contour);
      }
    }
    if (c.stroke.from == c.stroke.to) continue;
    c.stroke.source = model.edge_count + static_cast<std::uint32_t>(model.intersections.size());
    model.intersections.push_back(contours.replaced[c.edge]);
    model.strokes.push_back(c.stroke);
  }
}

}  // namespace ligne
