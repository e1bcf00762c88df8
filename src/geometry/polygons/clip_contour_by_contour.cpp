#include "geometry/polygons/clip_contour_by_contour.hpp"

#include <algorithm>

#include "geometry/polygons/edge_overlay.hpp"

namespace ligne {
namespace {

/// Collects the parts of edges that border a set of points, one edge after the other.
class BorderCollector {
 public:
  /// Adds the part from-to of the edge, which has the set on its left, on its right, on both sides or on none.
  /// `continues`: the part continues the part added before, with no corner between them.
  void part(const ContourEdge& edge, SegmentParameter from, SegmentParameter to, bool left, bool right, bool continues) {
    if (left == right) return;
    if (continues && !edges_.empty() && edges_.back().reversed == right && edges_.back().segment == edge.segment &&
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

/// A bounding box of corners rounded to the fine lattice, enlarged by one fine step.
class FineBox {
 public:
  void extend(const ContourEdge& edge) {
    for (const FinePoint p : {edge.begin(), edge.end()}) {
      low_ = {std::min(low_.x, p.x - 1), std::min(low_.y, p.y - 1)};
      high_ = {std::max(high_.x, p.x + 1), std::max(high_.y, p.y + 1)};
    }
  }
  bool meets(const ContourEdge& edge) const {
    const FinePoint p = edge.begin(), q = edge.end();
    return std::min(p.x, q.x) <= high_.x && std::max(p.x, q.x) >= low_.x && std::min(p.y, q.y) <= high_.y &&
           std::max(p.y, q.y) >= low_.y;
  }

 private:
  FinePoint low_{INT64_MAX, INT64_MAX}, high_{INT64_MIN, INT64_MIN};
};

/// The study of an edge takes the signs of both ends of each other edge.
std::uint64_t signs_of_edge(const EdgeOverlay& overlay) { return 2 * (overlay.size() - 1); }

}  // namespace

ClipResult clip_contour_by_contour(std::span<const ContourFace> subject, std::span<const ContourFace> clip, bool closed,
                                   std::uint64_t* signs) {
  EdgeOverlay overlay;
  for (const ContourFace& face : subject) overlay.add(face, 0);
  const std::size_t subject_edges = overlay.size();
  for (const ContourFace& face : clip) overlay.add(face, 1);
  FineBox box;
  for (std::size_t i = 0; i < subject_edges; ++i) box.extend(overlay.edge(i));
  std::uint64_t studied = 0;
  BorderCollector inside, outside;
  for (std::size_t i = 0; i < overlay.size(); ++i) {
    const ContourEdge edge = overlay.edge(i);
    if (i >= subject_edges && !box.meets(edge)) continue;  // results lie within the subject
    ++studied;
    overlay.for_each_part(
        i, edge.from, edge.to, [&](SegmentParameter from, SegmentParameter to, const EdgeSides& b, bool corner) {
          inside.part(edge, from, to, b.left[0] > 0 && b.left[1] > 0, b.right[0] > 0 && b.right[1] > 0, !corner);
          outside.part(edge, from, to, b.left[0] > 0 && b.left[1] <= 0, b.right[0] > 0 && b.right[1] <= 0, !corner);
        });
  }
  if (signs) *signs += studied * signs_of_edge(overlay);
  return {link_edges(inside.take(), closed), link_edges(outside.take(), closed)};
}

bool contours_overlap(std::span<const ContourFace> a, std::span<const ContourFace> b, std::uint64_t& signs) {
  EdgeOverlay overlay;
  for (const ContourFace& face : a) overlay.add(face, 0);
  for (const ContourFace& face : b) overlay.add(face, 1);
  bool overlap = false;
  for (std::size_t i = 0; i < overlay.size() && !overlap; ++i) {
    signs += signs_of_edge(overlay);
    const ContourEdge edge = overlay.edge(i);
    overlay.for_each_part(i, edge.from, edge.to, [&](SegmentParameter, SegmentParameter, const EdgeSides& s, bool) {
      overlap |= (s.left[0] > 0 && s.left[1] > 0) || (s.right[0] > 0 && s.right[1] > 0);
    });
  }
  return overlap;
}

}  // namespace ligne
