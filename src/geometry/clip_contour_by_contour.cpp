#include "geometry/clip_contour_by_contour.hpp"

#include "geometry/edge_overlay.hpp"

namespace ligne {
namespace {

/// Collects the parts of one edge after the other that border a set of points.
class BorderCollector {
 public:
  /// The part from-to of the edge has the set on its left, on its right, on both banks or on none. `goes_on`: it continues the part given
  /// before, and nothing ends there.
  void part(const ContourEdge& edge, SegmentParameter from, SegmentParameter to, bool left, bool right, bool goes_on) {
    if (left == right) return;
    if (goes_on && !edges_.empty() && edges_.back().reversed == right && edges_.back().segment == edge.segment &&
        compare(edges_.back().to, from) == 0) {
      edges_.back().to = to;
    } else {
      edges_.push_back({edge.segment, from, to, edge.source, right});
    }
  }

  std::vector<ContourEdge> take() { return std::move(edges_); }

 private:
  std::vector<ContourEdge> edges_;
};

}  // namespace

ClipResult clip_contour_by_contour(std::span<const ContourFace> subject, std::span<const ContourFace> clip, bool closed) {
  EdgeOverlay overlay;
  for (const ContourFace& face : subject) overlay.add(face, 0);
  for (const ContourFace& face : clip) overlay.add(face, 1);
  BorderCollector inside, outside;
  for (std::size_t i = 0; i < overlay.size(); ++i) {
    const ContourEdge edge = overlay.edge(i);
    overlay.for_each_part(i, edge.from, edge.to, [&](SegmentParameter from, SegmentParameter to, const Banks& b, bool corner) {
      inside.part(edge, from, to, b.left[0] > 0 && b.left[1] > 0, b.right[0] > 0 && b.right[1] > 0, !corner);
      outside.part(edge, from, to, b.left[0] > 0 && b.left[1] <= 0, b.right[0] > 0 && b.right[1] <= 0, !corner);
    });
  }
  return {link_edges(inside.take(), closed), link_edges(outside.take(), closed)};
}

}  // namespace ligne
