#pragma once
/// The directed edges of the contours of faces.

#include <cstddef>

#include "scene/model/polygon_faces.hpp"

namespace ligne {

/// Number of faces in a block, and of vertices in a part, where half-edges are sorted by parallel_counting_sort().
/// Adjustable.
inline constexpr std::size_t kFacesPerBlock = 16'384, kVerticesPerPart = 4096;

/// Calls visit(from, to, face, corner) for every directed edge of every contour of the faces [begin, end).
template <class Visit>
void for_each_half_edge(const PolygonFaces& faces, std::size_t begin, std::size_t end, Visit visit) {
  if (faces.all_triangles()) {
    const auto corners = faces.corners();
    for (std::size_t f = begin, k = 3 * begin; f < end; ++f, k += 3) {
      visit(corners[k], corners[k + 1], f, k);
      visit(corners[k + 1], corners[k + 2], f, k + 1);
      visit(corners[k + 2], corners[k], f, k + 2);
    }
    return;
  }
  for (std::size_t f = begin; f < end; ++f) {
    for (std::size_t c = 0; c < faces.contour_count(f); ++c) {
      const auto contour = faces.contour(f, c);
      const std::size_t first = faces.corner_index(f, c);
      for (std::size_t k = 0; k < contour.size(); ++k) {
        visit(contour[k], contour[k + 1 == contour.size() ? 0 : k + 1], f, first + k);
      }
    }
  }
}

}  // namespace ligne
