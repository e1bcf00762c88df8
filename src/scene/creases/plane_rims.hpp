#pragma once
/// The borders of planes on curved surfaces.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "scene/creases/parallel_bends.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "scene/patches/borders/patch_edges.hpp"

namespace ligne {

/// Edges between a plane and a curved surface that bend by any angle, where the recognised surfaces say nothing. A plane
/// that cuts a curved surface meets it at an angle that may fall to nothing on the way round.
class PlaneRims {
 public:
  PlaneRims(const Scene& scene, const Topology& topology, const Patches& patches, std::span<const PatchEdge> patch_edges)
      : scene_(scene), topology_(topology), patches_(patches), patch_edges_(patch_edges) {}

  /// The edges by which the border of a plane goes on from a vertex behind one of its edges, up to the first vertex at which
  /// is_end() holds. Empty if the border branches, ends or is longer than `longest` before that, or if the edge is none of
  /// such a border.
  std::vector<std::uint32_t> way_on(std::uint32_t edge, std::uint32_t vertex, double longest,
                                    const std::function<bool(std::uint32_t)>& is_end);

 private:
  void list_ends();
  std::uint32_t plane_face(std::uint32_t edge) const;

  const Scene& scene_;
  const Topology& topology_;
  const Patches& patches_;
  std::span<const PatchEdge> patch_edges_;
  std::vector<BendEnd> ends_;  ///< of the edges between a plane and a curved surface; sorted; listed at the first way
  bool is_listed_ = false;
};

}  // namespace ligne
