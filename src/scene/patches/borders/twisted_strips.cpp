#include "scene/patches/borders/twisted_strips.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "base/parallel_each.hpp"
#include "geometry/degrees.hpp"
#include "scene/model/edge_rows.hpp"
#include "scene/model/faces_and_edges.hpp"
#include "scene/patches/facets/flat_joints.hpp"

namespace ligne {
namespace {

/// Adjustable. Least ratio of the length of an edge across a strip to the short sides of its triangles. Wider triangles that
/// fold to and fro are meant: facets of gems and of low-poly vases.
constexpr double kSlender = 8;
/// Adjustable. Least ratio of the bends at two edges of one triangle.
constexpr double kLikeFold = 0.5;

class TwistedStrips {
 public:
  TwistedStrips(const Scene& scene, const Topology& topology, std::span<const glm::vec3> normals)
      : scene_(scene), topology_(topology), rows_(scene, topology, normals) {}

  /// Whether an edge folds against the next one on both sides, or against the next and that against the one behind it.
  bool contains(std::uint32_t e) const {
    const Edge& edge = topology_.edges[e];
    const Fold one = next(e, edge.face0), two = next(e, edge.face1);
    if (one && two) return one.kept != two.kept;
    const Fold& only = one ? one : two;
    if (!only) return false;
    const Fold behind = next(only.edge, only.face);
    return behind && behind.kept != only.kept;
  }

 private:
  /// The edge on the other side of a slender triangle that folds against the edge before it, the face behind it, and the
  /// vertex that both edges have in common.
  struct Fold {
    std::uint32_t edge = kNone, face = kNone, kept = kNone;
    explicit operator bool() const { return edge != kNone; }
  };

  Fold next(std::uint32_t e, std::uint32_t face) const {
    if (face == kNone || !is_triangle(scene_.faces, face)) return {};
    const auto corners = scene_.faces.contour(face, 0);
    const Edge& edge = topology_.edges[e];
    const std::uint32_t apex = corners[0] ^ corners[1] ^ corners[2] ^ edge.v0 ^ edge.v1;
    const auto length = [&](std::uint32_t a, std::uint32_t b) {
      return glm::distance(scene_.vertices[a], scene_.vertices[b]);
    };
    const double longest = length(edge.v0, edge.v1) / kSlender;
    const bool is_at_first = length(apex, edge.v0) <= longest;
    if (!is_at_first && length(apex, edge.v1) > longest) return {};
    const std::uint32_t kept = is_at_first ? edge.v1 : edge.v0;
    const std::uint32_t side = edge_between(topology_, apex, kept);
    if (side == kNone || !may_be_smooth(topology_, side)) return {};
    const double bend = rows_.bend(e, face), fold = -rows_.bend(side, face);
    const bool is_fold =
        bend * fold > 0 && std::abs(fold) >= kLikeFold * std::abs(bend) && std::abs(bend) >= kLikeFold * std::abs(fold);
    return is_fold ? Fold{side, other_face(topology_.edges[side], face), kept} : Fold{};
  }

  const Scene& scene_;
  const Topology& topology_;
  EdgeRows rows_;
};

}  // namespace

void smooth_twisted_strips(const Scene& scene, const Topology& topology, const MeshAngles& angles,
                           std::vector<PatchEdge>& edges) {
  const TwistedStrips strips(scene, topology, angles.normals);
  const auto flat = static_cast<float>(sine_cosine_degrees(kSurfaceCreaseDegrees).cosine);
  parallel_each(edges.size(), [&](std::size_t e) {
    if (angles.cosines[e] > flat) return;
    const auto number = static_cast<std::uint32_t>(e);
    if (may_be_smooth(topology, number) && strips.contains(number)) edges[e] = PatchEdge::inside;
  });
}

}  // namespace ligne
