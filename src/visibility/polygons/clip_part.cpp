#include "visibility/polygons/clip_part.hpp"

namespace ligne {

ClipPart whole_facet(const std::vector<Facet>& facets, const std::vector<ProjectedVertex>& vertices, std::uint32_t facet) {
  const Facet& f = facets[facet];
  ClipPart part;
  part.count = 3;
  for (unsigned k = 0; k < 3; ++k) {
    const std::uint32_t v = f.v[k], w = f.v[(k + 1) % 3];
    ContourEdge& e = part.edges[k];
    e.reversed = v > w;
    e.segment = e.reversed ? LatticeSegment{vertices[w].p, vertices[v].p} : LatticeSegment{vertices[v].p, vertices[w].p};
    e.source = side_source(facet, k);
  }
  return part;
}

ClipPart left_of(const ClipPart& triangle, const LatticeSegment& line) {
  std::array<double, 3> at{};
  int left = 0, right = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const ContourEdge& e = triangle.edges[k];
    at[k] = orientation(line.a, line.b, e.reversed ? e.segment.b : e.segment.a);
    left += at[k] > 0;
    right += at[k] < 0;
  }
  if (right == 0) return triangle;
  ClipPart part;
  if (left == 0) return part;
  SegmentParameter ends[2];
  int n = 0;
  std::uint32_t place = 0;  // the cut follows the edge that ends on its line or crosses it to the right
  for (std::size_t k = 0; k < 3; ++k) {
    const double first = at[k], last = at[(k + 1) % 3];
    ContourEdge e = triangle.edges[k];
    if (first * last < 0) {
      const SegmentParameter t = crossing(e.segment, line);
      ((first < 0) == e.reversed ? e.to : e.from) = t;
      ends[n++] = crossing(line, e.segment);
    } else if (last == 0 && first != 0 && n < 2) {
      ends[n++] = crossing(line, e.segment);
    }
    if (first > 0 || last > 0) part.edges[part.count++] = e;
    if (first > 0 && last <= 0) place = part.count++;
  }
  ContourEdge& cut = part.edges[place];
  cut.segment = line;
  cut.from = compare(ends[0], ends[1]) < 0 ? ends[0] : ends[1];
  cut.to = compare(ends[0], ends[1]) < 0 ? ends[1] : ends[0];
  cut.source = kCutSource;
  return part;
}

}  // namespace ligne
