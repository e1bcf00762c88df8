#include "contours/tangent_corners.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "base/no_index.hpp"
#include "geometry/nearest_on_segment.hpp"

namespace ligne {
namespace {

/// Ends of strokes on an edge lie within this distance of it: more than the lattice, less than any pen.
constexpr double kOnEdgeMm = 0.01;
constexpr double kTangentCellMm = 2;

/// A place at which a visible contour turns back, and the edge on which it lies.
struct Corner {
  Point2 mm{0, 0};
  double depth = 0, weight = 1;
  Point3 at{0, 0, 0};
  std::uint32_t face = kNone;  ///< of the contour before it
  std::array<Point2, 2> edge{};
};

bool is_seen(const SeenContour& contour, double at) {
  return std::ranges::any_of(contour.runs, [&](const ContourRun& run) {
    return run.state >= 0 && run.from <= at && at <= run.to && run.from < run.to;
  });
}

std::vector<Corner> seen_corners(const Scene& scene, const View& view, const SmoothContours& contours,
                                 const std::vector<SeenContour>& seen) {
  std::vector<Corner> corners;
  for (std::size_t c = 0; c < seen.size(); ++c) {
    const ContourChain& chain = contours.chains[c];
    for (std::size_t i = 1; i < chain.size(); ++i) {
      const ContourNode& node = chain.nodes[i];
      if (!node.is_corner || !is_seen(seen[c], static_cast<double>(i))) continue;
      const CurvePoint place = seen[c].curve.point_at(static_cast<double>(i));
      const auto page = [&](std::uint32_t v) { return page_point(view, scene.vertices[v]); };
      corners.push_back({place.mm,
                         place.depth,
                         place.weight,
                         node.on_surface,
                         contours.faces[c][i - 1],
                         {page(node.edge[0]), page(node.edge[1])}});
    }
  }
  return corners;
}

bool is_tangent(const Stroke& s) { return s.visible && s.line_class == LineClass::tangent; }

class TangentJoiner {
 public:
  TangentJoiner(StrokeModel& model, const View& view, std::vector<Corner> corners)
      : model_(model), view_(view), corners_(std::move(corners)), finder_(model.lattice, kTangentCellMm) {
    for (const Corner& corner : corners_) finder_.expect(corner.edge[0], corner.edge[1], kOnEdgeMm);
    for (std::uint32_t i = 0; i < model.strokes.size(); ++i) {
      const Stroke& s = model.strokes[i];
      if (!is_tangent(s)) continue;
      finder_.add({mm(s.from), mm(s.to), s.z_from, s.z_to, i});
      ends_.push_back(s.from);
      ends_.push_back(s.to);
    }
    std::ranges::sort(ends_);
  }

  void run() {
    for (const Corner& corner : corners_) {
      if (const auto end = nearest_end(corner)) join(corner, *end);
    }
  }

 private:
  Point2 mm(LatticePoint p) const { return model_.lattice.to_mm(p); }

  LatticePoint place_of(const EndOfStroke& end) const {
    const Stroke& s = model_.strokes[end.stroke];
    return end.first ? s.from : s.to;
  }

  bool is_free(LatticePoint p) const {
    const auto [first, last] = std::equal_range(ends_.begin(), ends_.end(), p);
    return last - first == 1;
  }

  /// The free end on the edge of the corner that is nearest to it.
  std::optional<EndOfStroke> nearest_end(const Corner& corner) const {
    const Point2 a = corner.edge[0], b = corner.edge[1];
    std::optional<EndOfStroke> best;
    double nearest = 0;
    finder_.near(a, b, kOnEdgeMm, [&](const OutlineSegment& piece) {
      for (const bool first : {true, false}) {
        const EndOfStroke end{piece.chain, first};
        const LatticePoint place = place_of(end);
        const double distance = glm::distance(mm(place), corner.mm);
        if (squared_distance(mm(place), a, b) > kOnEdgeMm * kOnEdgeMm || !is_free(place)) continue;
        if (best && distance >= nearest) continue;
        best = end;
        nearest = distance;
      }
    });
    return best;
  }

  void join(const Corner& corner, const EndOfStroke& end) {
    const Stroke old = model_.strokes[end.stroke];
    Stroke s = old;
    s.from = place_of(end);
    s.to = model_.lattice.snap(corner.mm);
    const Point2 here = mm(s.from), other = mm(end.first ? old.to : old.from);
    if (s.from == s.to) return;
    if (glm::dot(mm(s.to) - here, here - other) < 0) {
      shorten(end, s.to, corner.depth);
      return;
    }
    s.t_from = 0;
    s.t_to = 1;
    s.z_from = end.first ? old.z_from : old.z_to;
    s.z_to = static_cast<float>(corner.depth);
    s.w_from = end.first ? old.w_from : old.w_to;
    if (view_.camera.perspective) s.w_to = static_cast<float>(corner.weight);
    s.source = model_.edge_count + static_cast<std::uint32_t>(model_.intersections.size());
    model_.intersections.push_back({{to_model_point(view_, here, s.z_from), corner.at}, {corner.face, kNone}, false});
    model_.strokes.push_back(s);
  }

  /// Ends a stroke that runs past a corner there.
  void shorten(const EndOfStroke& end, LatticePoint place, double depth) {
    Stroke& s = model_.strokes[end.stroke];
    const double length = glm::distance(mm(s.from), mm(s.to)),
                 rest = glm::distance(mm(end.first ? s.to : s.from), mm(place));
    if (!(rest < length)) return;
    const double t = source_parameter(s, end.first ? 1 - rest / length : rest / length);
    (end.first ? s.from : s.to) = place;
    (end.first ? s.t_from : s.t_to) = t;
    (end.first ? s.z_from : s.z_to) = static_cast<float>(depth);
  }

  StrokeModel& model_;
  const View& view_;
  std::vector<Corner> corners_;
  SegmentFinder finder_;            ///< of visible tangent lines; OutlineSegment::chain is the stroke
  std::vector<LatticePoint> ends_;  ///< of these, sorted
};

}  // namespace

void join_tangents_at_corners(StrokeModel& model, const Scene& scene, const View& view, const SmoothContours& contours,
                              const std::vector<SeenContour>& seen) {
  std::vector<Corner> corners = seen_corners(scene, view, contours, seen);
  if (!corners.empty()) TangentJoiner(model, view, std::move(corners)).run();
}

}  // namespace ligne
