#include "scene/contacts/face_neighbours.hpp"

#include <algorithm>

#include "base/no_index.hpp"

namespace ligne {

FaceNeighbours::FaceNeighbours(const Scene& scene, const std::vector<std::uint32_t>& faces) {
  std::vector<bool> at_face(scene.vertices.size(), false);
  for (const std::uint32_t f : faces) {
    for_each_edge(scene, f, [&](std::uint32_t v, std::uint32_t) { at_face[v] = true; });
  }
  for (const Object& object : scene.objects) {
    const auto first = std::lower_bound(faces.begin(), faces.end(), object.face_begin);
    if (first == faces.end() || *first >= object.face_end) continue;
    for (std::uint32_t f = object.face_begin; f < object.face_end; ++f) {
      for_each_edge(scene, f, [&](std::uint32_t v, std::uint32_t w) {
        if (at_face[v] && at_face[w]) uses_.push_back({std::min(v, w), std::max(v, w), f});
      });
    }
  }
  std::sort(uses_.begin(), uses_.end());
}

std::uint32_t FaceNeighbours::across(std::uint32_t face, std::uint32_t v, std::uint32_t w) const {
  const EdgeUse key{std::min(v, w), std::max(v, w), 0};
  const auto first = std::lower_bound(uses_.begin(), uses_.end(), key);
  if (first == uses_.end() || first->edge() != key.edge()) return kNone;
  const auto begin = static_cast<std::size_t>(first - uses_.begin());
  if (end_of_edge(begin) - begin != 2) return kNone;
  return uses_[begin].face == face ? uses_[begin + 1].face : uses_[begin].face;
}

}  // namespace ligne
