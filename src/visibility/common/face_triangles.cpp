#include "visibility/common/face_triangles.hpp"

#include <algorithm>

namespace ligne::zbuffer {

void append_borders(std::span<const Triangle> triangles, std::vector<Side>& all, std::vector<Side>& sides) {
  all.clear();
  for (const Triangle& t : triangles) {
    for (int k = 0; k < 3; ++k) all.push_back({std::min(t.v[k], t.v[(k + 1) % 3]), std::max(t.v[k], t.v[(k + 1) % 3])});
  }
  std::sort(all.begin(), all.end());
  for (std::size_t i = 0; i < all.size();) {
    std::size_t same = i;
    while (same < all.size() && all[same] == all[i]) ++same;
    if ((same - i) % 2 == 1) sides.push_back(all[i]);
    i = same;
  }
}

std::vector<Triangle> by_face(std::vector<Triangle> triangles) {
  std::uint32_t faces = 0;
  for (const Triangle& t : triangles) faces = std::max(faces, t.face + 1);
  std::vector<std::uint32_t> next(std::size_t{faces} + 1, 0);
  bool divided = false;
  for (const Triangle& t : triangles) divided |= next[t.face + 1]++ > 0;
  if (!divided) return triangles;  // as they lie on the page
  for (std::uint32_t f = 0; f < faces; ++f) next[f + 1] += next[f];
  std::vector<Triangle> sorted(triangles.size());
  for (const Triangle& t : triangles) sorted[next[t.face]++] = t;
  return sorted;
}

}  // namespace ligne::zbuffer
