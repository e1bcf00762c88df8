#include "scene/creases/plane_rims.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

#include "base/indices_where.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"

namespace ligne {
namespace {

/// Least cosine between the normals of faces of one plane (0.05 degrees), and largest one at which edges bend (0.5 degrees).
constexpr double kOnePlaneCosine = 1 - 4e-7, kBentCosine = 1 - 4e-5;
/// Most edges of planes and curved surfaces at a vertex at which a border is followed.
constexpr std::ptrdiff_t kMostRimEnds = 64;

}  // namespace

void PlaneRims::list_ends() {
  is_listed_ = true;
  const auto may_be_rim = [&](std::size_t k) {
    const auto e = static_cast<std::uint32_t>(k);
    const bool is_open = patch_edges_[e] == PatchEdge::unknown || patch_edges_[e] == PatchEdge::sharp;
    return is_open && plane_face(e) != kNone;
  };
  for (const std::uint32_t e : indices_where(topology_.edges.size(), may_be_rim)) {
    ends_.push_back({topology_.edges[e].v0, e});
    ends_.push_back({topology_.edges[e].v1, e});
  }
  parallel_sort(ends_.begin(), ends_.end());
}

/// The face of an edge that is a plane, if the other one is curved and the edge bends; else kNone.
std::uint32_t PlaneRims::plane_face(std::uint32_t e) const {
  const Edge& edge = topology_.edges[e];
  if (edge.face1 == kNone || (topology_.edge_flags[e] & (kEdgeManyFaces | kEdgeUnlikeWound))) return kNone;
  const auto is_plane = [&](std::uint32_t f) { return patches_.patch_of[f] == kNone && !patches_.is_freeform[f]; };
  const bool first = is_plane(edge.face0);
  if (first == is_plane(edge.face1)) return kNone;
  if (glm::dot(face_normal(scene_, edge.face0), face_normal(scene_, edge.face1)) > kBentCosine) return kNone;
  return first ? edge.face0 : edge.face1;
}

std::vector<std::uint32_t> PlaneRims::way_on(std::uint32_t edge, std::uint32_t vertex, double longest,
                                             const std::function<bool(std::uint32_t)>& is_end) {
  std::vector<std::uint32_t> way;
  const std::uint32_t plane = plane_face(edge);
  if (plane == kNone) return way;
  if (!is_listed_) list_ends();
  const Point3 normal = face_normal(scene_, plane);
  for (double length = 0; length <= longest;) {
    std::uint32_t next = kNone;
    const auto first = std::lower_bound(ends_.begin(), ends_.end(), BendEnd{vertex, 0});
    for (auto end = first; end != ends_.end() && end->vertex == vertex; ++end) {
      if (end - first >= kMostRimEnds) return {};
      if (end->edge == edge || glm::dot(face_normal(scene_, plane_face(end->edge)), normal) < kOnePlaneCosine) continue;
      if (next != kNone) return {};
      next = end->edge;
    }
    if (next == kNone) return {};
    way.push_back(next);
    const Edge& at = topology_.edges[next];
    length += glm::distance(scene_.vertices[at.v0], scene_.vertices[at.v1]);
    vertex = at.v0 == vertex ? at.v1 : at.v0;
    edge = next;
    if (is_end(vertex)) return length <= longest ? way : std::vector<std::uint32_t>{};
  }
  return {};
}

}  // namespace ligne
