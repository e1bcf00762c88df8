#pragma once
/// Finds the neighbours of some faces of a scene.

#include <compare>
#include <cstdint>
#include <tuple>
#include <vector>

#include "scene/model/scene.hpp"

namespace ligne {

/// Calls visit(v, w) for every edge of the face, holes too, in the direction of its contours.
template <class Visit>
void for_each_edge(const Scene& scene, std::uint32_t face, Visit visit) {
  for (std::size_t c = 0; c < scene.faces.contour_count(face); ++c) {
    const auto contour = scene.faces.contour(face, c);
    for (std::size_t i = 0; i < contour.size(); ++i) visit(contour[i], contour[(i + 1) % contour.size()]);
  }
}

/// Neighbours of a few faces, found without the topology of the whole scene.
class FaceNeighbours {
 public:
  /// Takes O(corners of the objects that own the faces). `faces`: ascending.
  FaceNeighbours(const Scene& scene, const std::vector<std::uint32_t>& faces);

  /// The neighbour of one of the faces across the edge from v to w; kNone on a border and where more than two faces
  /// meet.
  std::uint32_t across(std::uint32_t face, std::uint32_t v, std::uint32_t w) const;

  /// Calls visit(face, neighbour, v, w) for every edge of two faces, at least one of which was given.
  template <class Visit>
  void for_each_pair(Visit visit) const {
    for (std::size_t begin = 0, end = 0; begin < uses_.size(); begin = end) {
      end = end_of_edge(begin);
      if (end - begin == 2) visit(uses_[begin].face, uses_[begin + 1].face, uses_[begin].v0, uses_[begin].v1);
    }
  }

 private:
  struct EdgeUse {
    std::uint32_t v0, v1, face;
    auto edge() const { return std::tie(v0, v1); }
    friend auto operator<=>(const EdgeUse&, const EdgeUse&) = default;
  };
  std::size_t end_of_edge(std::size_t begin) const {
    std::size_t end = begin + 1;
    while (end < uses_.size() && uses_[end].edge() == uses_[begin].edge()) ++end;
    return end;
  }

  std::vector<EdgeUse> uses_;  ///< the edges between vertices of the faces, sorted by edge
};

}  // namespace ligne
