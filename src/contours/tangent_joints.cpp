/// Where a cylinder runs into a fillet, as at the foot of a column, the contour of the cylinder crosses the tangent line
/// between both surfaces, or turns back there, and the visible part of that line begins at the crossing. The visibility
/// of the line is that of the mesh, so it begins at some vertex of the mesh beside that place.

#include "contours/contour_junctions.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include <glm/geometric.hpp>

#include "base/indices_where.hpp"
#include "base/no_index.hpp"
#include "contours/contour_lines.hpp"
#include "geometry/nearest_on_segment.hpp"
#include "linework/map/nodes.hpp"
#include "linework/stroke_geometry.hpp"

namespace ligne {
namespace {

/// Ends of strokes on an edge lie within this distance of it: more than the lattice, less than any pen.
constexpr double kOnEdgeMm = 0.01;
constexpr double kTangentCellMm = 2;

/// A place at which a visible contour crosses the edge between two surfaces, and that edge.
struct Joint {
  CurvePoint place;
  Point3 at{0, 0, 0};
  std::uint32_t face = kNone;  ///< of the contour before it
  std::array<Point2, 2> edge{};
};

bool is_seen(const SeenContour& contour, double at) {
  return std::ranges::any_of(contour.runs, [&](const ContourRun& run) {
    return run.state >= 0 && run.from <= at && at <= run.to && run.from < run.to;
  });
}

std::vector<Joint> seen_joints(const Scene& scene, const View& view, const SmoothContours& contours,
                               const std::vector<SeenContour>& seen) {
  std::vector<Joint> joints;
  for (std::size_t c = 0; c < seen.size(); ++c) {
    const ContourChain& chain = contours.chains[c];
    for (std::size_t i = 1; i < chain.size(); ++i) {
      const ContourNode& node = chain.nodes[i];
      if (!node.is_joint || !is_seen(seen[c], static_cast<double>(i))) continue;
      const CurvePoint place = seen[c].curve.point_at(static_cast<double>(i));
      const auto page = [&](std::uint32_t v) { return page_point(view, scene.vertices[v]); };
      joints.push_back({place, node.on_surface, contours.faces[c][i - 1], {page(node.edge[0]), page(node.edge[1])}});
    }
  }
  return joints;
}

bool is_tangent(const Stroke& s) { return s.visible && s.line_class == LineClass::tangent; }

class TangentJoiner {
 public:
  TangentJoiner(StrokeModel& model, const View& view, std::vector<Joint> joints)
      : model_(model),
        view_(view),
        joints_(std::move(joints)),
        tangents_(indices_where(model.strokes.size(), [&](std::size_t i) { return is_tangent(model.strokes[i]); })),
        nodes_(model.strokes, tangents_),
        finder_(model.lattice, kTangentCellMm) {
    for (std::uint32_t i = 0; i < tangents_.size(); ++i) {
      const Stroke& s = model.strokes[tangents_[i]];
      finder_.add({mm(s.from), mm(s.to), s.z_from, s.z_to, i});
    }
  }

  void run() {
    for (const Joint& joint : joints_) {
      if (const auto end = nearest_end(joint)) join(joint, *end);
    }
  }

 private:
  Point2 mm(LatticePoint p) const { return model_.lattice.to_mm(p); }

  Stroke& stroke_of(std::uint32_t end) { return model_.strokes[tangents_[end / 2]]; }

  /// The free end on the edge of the joint that is nearest to it.
  std::optional<std::uint32_t> nearest_end(const Joint& joint) {
    const Point2 a = joint.edge[0], b = joint.edge[1];
    std::optional<std::uint32_t> best;
    double nearest = 0;
    finder_.near(a, b, kOnEdgeMm, [&](const OutlineSegment& piece) {
      for (const std::uint32_t end : {2 * piece.chain, 2 * piece.chain + 1}) {
        const Point2 place = mm(tip(stroke_of(end), end).p);
        const double distance = glm::distance(place, joint.place.mm);
        const bool is_free = nodes_.degree(nodes_.of(end)) == 1;
        if (!is_free || squared_distance(place, a, b) > kOnEdgeMm * kOnEdgeMm || (best && distance >= nearest)) continue;
        best = end;
        nearest = distance;
      }
    });
    return best;
  }

  void join(const Joint& joint, std::uint32_t end) {
    const StrokeTip own = tip(stroke_of(end), end), far = tip(stroke_of(end), end ^ 1);
    const float weight = view_.camera.perspective ? static_cast<float>(joint.place.weight) : own.w;
    const StrokeTip at{model_.lattice.snap(joint.place.mm), static_cast<float>(joint.place.depth), weight};
    Stroke s = stroke_between(stroke_of(end), own, at);
    const Point2 here = mm(s.from), other = mm(far.p);
    if (s.from == s.to) return;
    if (glm::dot(mm(s.to) - here, here - other) < 0) {
      shorten(end, s.to);
      return;
    }
    s.t_from = 0;
    s.t_to = 1;
    s.source = model_.edge_count + static_cast<std::uint32_t>(model_.intersections.size());
    model_.intersections.push_back({{to_model_point(view_, here, s.z_from), joint.at}, {joint.face, kNone}, false});
    model_.strokes.push_back(s);
  }

  /// Ends a stroke that runs past a joint there.
  void shorten(std::uint32_t end, LatticePoint place) {
    Stroke& s = stroke_of(end);
    const bool first = end % 2 == 0;
    const double length = glm::distance(mm(s.from), mm(s.to)), rest = glm::distance(mm(first ? s.to : s.from), mm(place));
    if (!(rest < length)) return;
    move_end(s, first, {first ? 1 - rest / length : rest / length, place});
    nodes_.unlink(end);
  }

  StrokeModel& model_;
  const View& view_;
  std::vector<Joint> joints_;
  std::vector<std::uint32_t> tangents_;  ///< strokes
  Nodes nodes_;                          ///< of these
  SegmentFinder finder_;                 ///< of these; OutlineSegment::chain is the index in tangents_
};

}  // namespace

void join_tangents_to_contours(StrokeModel& model, const Scene& scene, const View& view, const SmoothContours& contours,
                               const std::vector<SeenContour>& seen) {
  std::vector<Joint> joints = seen_joints(scene, view, contours, seen);
  if (!joints.empty()) TangentJoiner(model, view, std::move(joints)).run();
}

}  // namespace ligne
