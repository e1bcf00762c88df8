#include "scene/patches/borders/whole_borders.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <map>

#include "base/no_index.hpp"
#include "geometry/degrees.hpp"
#include "scene/model/faces_and_edges.hpp"
#include "scene/patches/borders/edge_chains.hpp"

namespace ligne {
namespace {

// Adjustable.
/// A patch may be a band if more than this fraction of its border has evidence. One long side of a strip is less than
/// half of its border. Both sides exceed this fraction, unless the strip is two thirds as wide as it is long.
constexpr double kMostCurved = 0.6;
/// A patch is no band if it meets one other patch along this fraction of the border that has evidence. The cone at the
/// tip of a shaft does, since it has only one side.
constexpr double kOneSide = 0.8;
/// A patch is no band beside another one if it is deeper than one row along this fraction of their common border: where a
/// free form bends between rows, each of them is a band.
constexpr double kMostDeep = 0.5;
/// Least part of the common border of two patches that is alone, where it is a sharp edge whatever these patches are.
constexpr double kMostAlone = 0.9;
/// Least tangent fraction of a chain's length that makes the whole chain tangent, and largest fraction with evidence
/// against it.
constexpr double kMostTangent = 0.6, kMostAgainst = 0.1;
/// Angle between facets, in degrees, from which on the rules for meshes decide: at the sides of coarse fillets, facets bend
/// by less.
constexpr double kTooBent = 20;

class WholeBorders {
 public:
  WholeBorders(const Scene& scene, const Topology& topology, const Patches& patches,
               std::span<const BorderEvidence> evidence, std::vector<PatchEdge>& edges)
      : scene_(scene), topology_(topology), patches_(patches), evidence_(evidence), edges_(edges) {}

  void run() {
    decide_angled();
    decide_chains();
  }

 private:
  std::array<std::uint32_t, 2> patches_at(std::size_t e) const {
    const Edge& edge = topology_.edges[e];
    return {patches_.patch_of[edge.face0], patches_.patch_of[edge.face1]};
  }

  double length_of(std::size_t e) const { return edge_length(scene_, topology_.edges[e]); }

  /// Whether the facets of a free form and of what it borders on bend by kTooBent.
  bool is_bent(std::size_t e) const {
    const auto [p, q] = patches_at(e);
    if (p != kNone && q != kNone) return false;
    const Edge& edge = topology_.edges[e];
    return glm::dot(face_normal(scene_, edge.face0), face_normal(scene_, edge.face1)) < mesh_bent_;
  }

  static bool is_angled(BorderEvidence evidence) {
    return evidence == BorderEvidence::angled || evidence == BorderEvidence::alone;
  }

  /// Per vertex: 1 if all faces around it belong to one patch.
  std::vector<std::uint8_t> inner_vertices() const {
    constexpr std::uint32_t kMixed = kNone - 1;
    std::vector<std::uint32_t> of_vertex(scene_.vertices.size(), kNone);
    for (std::uint32_t f = 0; f < scene_.faces.size(); ++f) {
      const std::uint32_t patch = patches_.patch_of[f] == kNone ? kMixed : patches_.patch_of[f];
      for (const std::uint32_t v : corners_of(scene_.faces, f))
        of_vertex[v] = of_vertex[v] == kNone || of_vertex[v] == patch ? patch : kMixed;
    }
    std::vector<std::uint8_t> inner(of_vertex.size());
    for (std::size_t v = 0; v < inner.size(); ++v) inner[v] = of_vertex[v] != kNone && of_vertex[v] != kMixed;
    return inner;
  }

  /// Whether a face on the border of a cylinder or a cone is in one of several rows of facets that lie in one direction.
  bool is_deep(const std::vector<std::uint8_t>& inner, std::uint32_t face) const {
    const SurfaceKind kind = patches_.list[patches_.patch_of[face]].surface.kind;
    if (kind != SurfaceKind::cylinder && kind != SurfaceKind::cone) return false;
    return std::ranges::any_of(scene_.faces.contour(face, 0), [&](std::uint32_t v) { return inner[v]; });
  }

  void decide_angled() {
    if (std::ranges::none_of(evidence_, is_angled)) return;
    struct Border {
      double length = 0, curved = 0;  ///< of all edges; of the edges that have evidence
    };
    struct Shared {
      double length = 0, angled = 0, alone = 0;  ///< of the edges with evidence, and of those that meet at an angle
      std::array<double, 2> deep{};              ///< of those beside which the one and the other patch is_deep()
    };
    std::vector<Border> borders(patches_.list.size());
    const std::vector<std::uint8_t> inner = inner_vertices();
    std::map<std::array<std::uint32_t, 2>, Shared> shared;  // by two patches, the lower number first
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (topology_.edges[e].face1 == kNone) continue;
      const auto [p, q] = patches_at(e);
      if (p == q) continue;
      const double length = length_of(e), curved = evidence_[e] != BorderEvidence::none ? length : 0;
      for (const std::uint32_t patch : {p, q}) {
        if (patch == kNone) continue;
        borders[patch].length += length;
        borders[patch].curved += curved;
      }
      if (curved == 0 || p == kNone || q == kNone) continue;
      Shared& both = shared[{std::min(p, q), std::max(p, q)}];
      both.length += length;
      const Edge& edge = topology_.edges[e];
      for (const std::uint32_t face : {edge.face0, edge.face1})
        if (is_deep(inner, face)) both.deep[patches_.patch_of[face] == std::max(p, q)] += length;
      if (is_angled(evidence_[e])) both.angled += length;
      if (evidence_[e] == BorderEvidence::alone) both.alone += length;
    }
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (!is_angled(evidence_[e]) || edges_[e] != PatchEdge::unknown) continue;
      const auto [p, q] = patches_at(e);
      const Shared& both = shared[{std::min(p, q), std::max(p, q)}];
      const auto may_be_band = [&](std::uint32_t patch) {
        const Border& border = borders[patch];
        return border.curved > kMostCurved * border.length && both.length < kOneSide * border.curved;
      };
      const bool is_between_bands =
          std::ranges::max(both.deep) < kMostDeep * both.length && (may_be_band(p) || may_be_band(q));
      if (both.alone >= kMostAlone * both.angled || !is_between_bands) edges_[e] = PatchEdge::sharp;
    }
  }

  void decide_chains() {
    std::vector<BorderEdge> sides;  // one for each patch at an edge
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      if (evidence_[e] == BorderEvidence::none) continue;
      for (const std::uint32_t patch : patches_at(e)) {
        if (patch != kNone) sides.push_back({e, patch});
      }
    }
    DisjointSets chains = edge_chains(scene_, topology_, sides);
    struct Lengths {
      double all = 0, tangent = 0, against = 0;
    };
    std::vector<Lengths> lengths(sides.size());
    for (std::uint32_t i = 0; i < sides.size(); ++i) {
      const BorderEvidence evidence = evidence_[sides[i].edge];
      const double length = length_of(sides[i].edge);
      Lengths& sum = lengths[chains.find(i)];
      sum.all += length;
      if (evidence == BorderEvidence::tangent) sum.tangent += length;
      if (evidence == BorderEvidence::against || is_angled(evidence)) sum.against += length;
    }
    for (std::uint32_t i = 0; i < sides.size(); ++i) {
      const std::uint32_t e = sides[i].edge;
      // The rules for meshes decide edges that the file shades smooth, and those that bend as creases may.
      if (edges_[e] != PatchEdge::unknown || (topology_.edge_flags[e] & kEdgeSmooth) || is_bent(e)) continue;
      const Lengths& sum = lengths[chains.find(i)];
      if (sum.tangent >= kMostTangent * sum.all && sum.against <= kMostAgainst * sum.all) edges_[e] = PatchEdge::tangent;
    }
  }

  const Scene& scene_;
  const Topology& topology_;
  const Patches& patches_;
  std::span<const BorderEvidence> evidence_;
  std::vector<PatchEdge>& edges_;
  const double mesh_bent_ = sine_cosine_degrees(kTooBent).cosine;
};

}  // namespace

void decide_by_whole_borders(const Scene& scene, const Topology& topology, const Patches& patches,
                             std::span<const BorderEvidence> evidence, std::vector<PatchEdge>& edges) {
  WholeBorders(scene, topology, patches, evidence, edges).run();
}

}  // namespace ligne
