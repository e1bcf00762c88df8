#include "scene/heal/agree_windings.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/no_index.hpp"

namespace ligne {
namespace {

bool joins_two_faces(const Topology& topology, std::size_t e) {
  const Edge& edge = topology.edges[e];
  return edge.face1 != kNone && edge.face0 != edge.face1 && !(topology.edge_flags[e] & kEdgeManyFaces);
}

/// The neighbours of each face across edges of two faces.
class Neighbours {
 public:
  struct Neighbour {
    std::uint32_t face;
    bool unlike;  ///< the windings disagree
  };

  Neighbours(std::size_t faces, const Topology& topology) : first_(faces + 1, 0) {
    for_each(topology, [&](std::uint32_t face, Neighbour) { ++first_[face + 1]; });
    for (std::size_t f = 0; f < faces; ++f) first_[f + 1] += first_[f];
    all_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for_each(topology, [&](std::uint32_t face, Neighbour n) { all_[next[face]++] = n; });
  }

  const Neighbour* begin(std::uint32_t face) const { return all_.data() + first_[face]; }
  const Neighbour* end(std::uint32_t face) const { return all_.data() + first_[face + 1]; }

 private:
  template <class Visit>
  static void for_each(const Topology& topology, Visit visit) {
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
      if (!joins_two_faces(topology, e)) continue;
      const Edge& edge = topology.edges[e];
      const bool unlike = (topology.edge_flags[e] & kEdgeUnlikeWound) != 0;
      visit(edge.face0, {edge.face1, unlike});
      visit(edge.face1, {edge.face0, unlike});
    }
  }

  std::vector<std::uint32_t> first_;
  std::vector<Neighbour> all_;
};

/// Reverses a face. Each edge keeps its flags, which belong to the corner where it begins.
void turn(Scene& scene, std::uint32_t face) {
  const std::span<std::uint32_t> corners = scene.faces.corners();
  for (std::size_t c = 0; c < scene.faces.contour_count(face); ++c) {
    const auto first = static_cast<std::ptrdiff_t>(scene.faces.corner_index(face, c));
    const auto count = static_cast<std::ptrdiff_t>(std::as_const(scene.faces).contour(face, c).size());
    std::reverse(corners.begin() + first + 1, corners.begin() + first + count);
    if (scene.corner_flags.empty()) continue;
    std::reverse(scene.corner_flags.begin() + first, scene.corner_flags.begin() + first + count);
  }
}

}  // namespace

std::size_t agree_windings(Scene& scene, const Topology& topology) {
  bool agree = (flags_of_any(topology) & kEdgeUnlikeWound) == 0;
  for (std::size_t e = 0; e < topology.edges.size() && agree; ++e) {
    agree = !(topology.edge_flags[e] & kEdgeUnlikeWound) || !joins_two_faces(topology, e);
  }
  if (agree) return 0;
  const Neighbours neighbours(scene.faces.size(), topology);
  enum : std::uint8_t { unknown, as_first, turned };
  std::vector<std::uint8_t> winding(scene.faces.size(), unknown);
  std::vector<std::uint32_t> together;
  std::size_t count = 0;
  for (std::uint32_t start = 0; start < scene.faces.size(); ++start) {
    if (winding[start] != unknown) continue;
    together.assign(1, start);
    winding[start] = as_first;
    bool two_sided = true;
    std::size_t turns = 0;
    for (std::size_t i = 0; i < together.size(); ++i) {
      const std::uint32_t face = together[i];
      turns += winding[face] == turned;
      for (auto n = neighbours.begin(face); n != neighbours.end(face); ++n) {
        const std::uint8_t wanted = (winding[face] == turned) != n->unlike ? turned : as_first;
        if (winding[n->face] == unknown) {
          winding[n->face] = wanted;
          together.push_back(n->face);
        } else {
          two_sided = two_sided && winding[n->face] == wanted;
        }
      }
    }
    if (!two_sided) continue;
    const std::uint8_t fewer = 2 * turns <= together.size() ? turned : as_first;
    for (const std::uint32_t face : together) {
      if (winding[face] != fewer) continue;
      turn(scene, face);
      ++count;
    }
  }
  return count;
}

}  // namespace ligne
