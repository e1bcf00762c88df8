#include "scene/patches/borders/patch_edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "geometry/degrees.hpp"
#include "scene/model/edge_rows.hpp"
#include "scene/model/faces_and_edges.hpp"
#include "scene/patches/borders/twisted_strips.hpp"
#include "scene/patches/borders/whole_borders.hpp"
#include "scene/patches/facet_graph.hpp"
#include "scene/patches/freeform.hpp"

namespace ligne {
namespace {

/// Adjustable. Added to the angle of sharp edges, in degrees: despite rounding, surfaces that meet at exactly that
/// angle make no edge.
constexpr double kSlackDegrees = 0.01;
/// Adjustable, radians. A free form that turns by less than kLeastTurn over its first facet counts as flat, and has no
/// tangent line at a plane. A free form joins a surface smoothly if their normals differ by at most kTangentSlack (1 degree)
/// plus the fraction kTangentPart of that turn.
constexpr double kLeastTurn = 0.01, kTangentSlack = 0.0175, kTangentPart = 0.4;
/// Adjustable. Normals that differ by more than kTangentSlack plus this fraction of the turn over the first facet are
/// evidence against a tangent edge. A smaller difference may be the error of a coarse facet.
constexpr double kApartPart = 1.2;
/// Adjustable. Least fraction of a chain's length with evidence for a kind that makes the whole chain that kind, and
/// largest fraction with evidence against it.
constexpr double kMostOfChain = 0.6, kLittleOfChain = 0.1;

/// Adjustable. Largest fraction of the common border of two patches at which the surface may go on from one to the other if
/// they are no bands. At the mitre of two fillets it does on one side, where their normals are equal.
constexpr double kMostOpen = 0.5;

/// Adjustable. Least sag, in those of the facets across, of a curve through the middles of two patches that turns by their
/// angle: a tessellator would have divided it, so the patches are fillets that meet at a mitre.
constexpr double kMitreSags = 8;

/// Adjustable. Most sides of a face of a fan. Beside a polygon of n sides, the search for its sides would take n^2.
constexpr std::size_t kMostFanSides = 4;

/// Adjustable. Most facets across a patch whose curvature in this direction may be an accident.
constexpr int kMostShallowFacets = 2;

/// The common border of two patches.
struct SharedBorder {
  double length = 0, open = 0;  ///< of all edges; of those at which the surface goes on
  double sine = 0;              ///< of the largest angle between the two surfaces
};

class EdgeClassifier {
 public:
  EdgeClassifier(const Scene& scene, const Topology& topology, std::span<const glm::vec3> normals, const Patches& patches,
                 double sharp_degrees)
      : scene_(scene),
        topology_(topology),
        normals_(normals),
        patches_(patches),
        rows_(scene, topology, normals),
        sharp_(sine_cosine_degrees(std::min(180.0, sharp_degrees + kSlackDegrees)).cosine),
        flat_(sine_cosine_degrees(kFlatBend).cosine),
        bent_(sine_cosine_degrees(kLargestBend).cosine),
        mesh_bent_(sine_cosine_degrees(kMeshBend).cosine),
        chains_(patches.borders.size()) {
    for (const FreeformBorder& border : patches.borders) {
      Chain& chain = chains_[border.chain];
      chain.length += border.length;
      const PatchEdge kind = kind_of(border);
      if (kind == PatchEdge::sharp) chain.sharp += border.length;
      if (kind == PatchEdge::sharp && border.angle > kTangentSlack + kApartPart * border.turn) chain.apart += border.length;
      if (kind == PatchEdge::tangent) chain.tangent += border.length;
    }
  }

  PatchEdge operator()(std::size_t e) const {
    const Edge& edge = topology_.edges[e];
    if (edge.face1 == kNone || (topology_.edge_flags[e] & kSpoken)) return PatchEdge::unknown;
    const std::uint32_t p = patches_.patch_of[edge.face0], q = patches_.patch_of[edge.face1];
    if (p != kNone && p == q) return PatchEdge::inside;
    const bool has_surfaces = p != kNone && q != kNone;
    if (!has_surfaces && (patches_.is_freeform[edge.face0] || patches_.is_freeform[edge.face1]))
      return border_of_freeform(e);
    const Point3 n0(normals_[edge.face0]), n1(normals_[edge.face1]);
    const double bend = glm::dot(n0, n1);
    if (bend < bent_ || (bend > flat_ && !has_surfaces)) return PatchEdge::unknown;
    double cosine = 0;
    for (const std::uint32_t v : {edge.v0, edge.v1}) {
      const Point3& at = scene_.vertices[v];
      cosine += glm::dot(patches_.normal(edge.face0, at, n0), patches_.normal(edge.face1, at, n1)) / 2;
    }
    if (cosine <= sharp_) {
      // Strips of a free form, as those between meridians of a dish, lie on cylinders that meet at such angles.
      const bool is_doubtful = has_surfaces || (topology_.edge_flags[e] & kEdgeSmooth);
      return is_doubtful ? PatchEdge::unknown : PatchEdge::sharp;
    }
    if (p == kNone && q == kNone) return PatchEdge::unknown;
    const bool is_inside = bend_alike(edge, n0) || (has_surfaces && is_between_bands(static_cast<std::uint32_t>(e)));
    return is_inside ? PatchEdge::inside : PatchEdge::tangent;
  }

  /// The evidence of an edge. `kind`: the class that operator() gives it.
  BorderEvidence evidence(std::size_t e, PatchEdge kind) const {
    const Edge& edge = topology_.edges[e];
    if (edge.face1 == kNone || (topology_.edge_flags[e] & kSpoken)) return BorderEvidence::none;
    const std::uint32_t p = patches_.patch_of[edge.face0], q = patches_.patch_of[edge.face1];
    const bool is_border =
        p != q && (p != kNone || patches_.is_freeform[edge.face0]) && (q != kNone || patches_.is_freeform[edge.face1]);
    if (!is_border || glm::dot(Point3(normals_[edge.face0]), Point3(normals_[edge.face1])) < bent_)
      return BorderEvidence::none;
    if (kind == PatchEdge::tangent) return BorderEvidence::tangent;
    if (kind != PatchEdge::unknown) return BorderEvidence::against;
    if (p != kNone && q != kNone)
      return ends_rows(static_cast<std::uint32_t>(e)) ? BorderEvidence::alone : BorderEvidence::angled;
    const auto border = std::ranges::lower_bound(patches_.borders, e, {}, &FreeformBorder::edge);
    if (border == patches_.borders.end() || border->edge != e) return BorderEvidence::open;
    if (kind_of(*border) == PatchEdge::tangent) return BorderEvidence::tangent;
    const bool is_against = border->turn > 0 && border->angle > kTangentSlack + kApartPart * border->turn;
    return is_against && !border->is_fleck && !is_in_row(*border) ? BorderEvidence::against : BorderEvidence::open;
  }

 private:
  static constexpr std::uint16_t kSpoken =
      kEdgeManyFaces | kEdgeUnlikeWound | kEdgeSharp | kEdgeCrossing | kEdgeFileHidden | kEdgeInner;

  /// Lengths of a chain of borders of a free form: in all, of each kind, and `apart`, of the borders that can not be
  /// tangent.
  struct Chain {
    double length = 0, sharp = 0, tangent = 0, apart = 0;
  };

  PatchEdge kind_of(const FreeformBorder& border) const {
    if (border.is_fleck) return PatchEdge::unknown;
    if (border.angle > kTangentSlack + kTangentPart * border.turn) {
      const bool is_sharp = !border.is_beside_band && border.angle >= std::acos(sharp_) && !is_in_row(border);
      return is_sharp ? PatchEdge::sharp : PatchEdge::unknown;
    }
    // Surfaces that the file shades smooth, such as limit surfaces, have no lines where their patches bend differently.
    const bool is_smooth = topology_.edge_flags[border.edge] & kEdgeSmooth;
    const bool bends_otherwise = border.bends_otherwise && !is_beside_shallow_row(border);
    const bool has_line = border.is_beside_plane || (bends_otherwise && !is_smooth);
    const bool turns = border.turn >= kLeastTurn || bends_otherwise;
    return turns && has_line ? PatchEdge::tangent : PatchEdge::unknown;
  }

  PatchEdge border_of_freeform(std::size_t e) const {
    if (patches_.is_freeform[topology_.edges[e].face0] && patches_.is_freeform[topology_.edges[e].face1])
      return PatchEdge::unknown;
    const auto border = std::ranges::lower_bound(patches_.borders, e, {}, &FreeformBorder::edge);
    if (border == patches_.borders.end() || border->edge != e) return PatchEdge::unknown;
    const Chain& chain = chains_[border->chain];
    const double most = kMostOfChain * chain.length, little = kLittleOfChain * chain.length;
    if (chain.tangent >= most && chain.apart <= little) {
      // Beside recognised surfaces, the rules for meshes decide if the facets bend by at least kMeshBend.
      const Edge& edge = topology_.edges[e];
      const bool is_bent = glm::dot(Point3(normals_[edge.face0]), Point3(normals_[edge.face1])) < mesh_bent_;
      return is_bent && !border->is_beside_plane ? PatchEdge::unknown : PatchEdge::tangent;
    }
    const bool is_sharp = chain.sharp >= most && chain.tangent <= little && !(topology_.edge_flags[e] & kEdgeSmooth);
    return is_sharp ? PatchEdge::sharp : PatchEdge::unknown;
  }

  /// Whether one row of facets goes on from the free form into a surface. A cut may have left of the free form what has no
  /// next edge: then it is one facet deep, and tells nothing of its angle at the border.
  bool is_in_row(const FreeformBorder& border) const {
    const Edge& edge = topology_.edges[border.edge];
    const auto [free, beyond] =
        patches_.is_freeform[edge.face0] ? std::pair(edge.face0, edge.face1) : std::pair(edge.face1, edge.face0);
    if (patches_.patch_of[beyond] == kNone || !rows_.next({border.edge, beyond}, kEvenBends)) return false;
    return rows_.next({border.edge, free}, kEvenBends) || !rows_.next({border.edge, free}, kRoundingBends);
  }

  /// Whether one row of facets goes on from the free form into a surface that is one or two facets deep. Facets between two
  /// sections of a fillet lie on a cylinder, whatever the way of the fillet: it tells nothing of the curvature across.
  bool is_beside_shallow_row(const FreeformBorder& border) const {
    const Edge& edge = topology_.edges[border.edge];
    return is_in_row(border) && is_shallow(border.edge, patches_.is_freeform[edge.face0] ? edge.face1 : edge.face0);
  }

  /// Whether an edge is none of those between the bands of a free form: no edge beside it bends as it does. Tessellators
  /// make rows that bend alike of like depths, so behind a facet that is much deeper than that on the other side none
  /// counts, nor does one at which a much narrower row begins.
  bool ends_rows(std::uint32_t e) const {
    const Edge& edge = topology_.edges[e];
    const std::array faces{edge.face0, edge.face1};
    const std::array depths{depth_behind(scene_, scene_.faces.contour(faces[0], 0), edge),
                            depth_behind(scene_, scene_.faces.contour(faces[1], 0), edge)};
    for (const std::size_t k : {0, 1}) {
      if (depths[k] >= kPlaneDepths * depths[1 - k]) continue;
      const EdgeRows::Step next = rows_.next({e, faces[k]}, kRoundingBends);
      if ((next && !is_narrow(next, depths[k])) || is_in_fan(e, faces[k])) return false;
    }
    return true;
  }

  /// Whether the face behind a row is much less deep than the one before it.
  bool is_narrow(const EdgeRows::Step& row, double depth) const {
    const auto contour = scene_.faces.contour(row.face, 0);
    return depth >= kPlaneDepths * depth_behind(scene_, contour, topology_.edges[row.edge]);
  }

  /// Whether an edge that shares an end with another one, as those at the tip of a cone do, bends on behind a face.
  bool is_in_fan(std::uint32_t e, std::uint32_t face) const {
    const auto along = [&](std::uint32_t edge) {
      return glm::normalize(scene_.vertices[topology_.edges[edge].v1] - scene_.vertices[topology_.edges[edge].v0]);
    };
    const auto contour = scene_.faces.contour(face, 0);
    if (contour.size() > kMostFanSides) return false;
    const double angle = rows_.bend(e, face);
    for (std::size_t k = 0; k < contour.size(); ++k) {
      const std::uint32_t side = edge_between(topology_, contour[k], contour[k + 1 == contour.size() ? 0 : k + 1]);
      if (side == kNone || side == e || topology_.edges[side].face1 == kNone) continue;
      const bool is_like = rows_.bend(side, face) * angle >= kRoundingBends.least * angle * angle;
      if (is_like && std::abs(glm::dot(along(side), along(e))) > kRoundingBends.cosine) return true;
    }
    return false;
  }

  /// Whether one row of facets, alike in width, goes on between two patches of which one is one or two facets deep. The
  /// bands of an ellipsoid are such patches: each lies on some cone or sphere by accident, and tells nothing of the
  /// curvature across its borders.
  bool is_between_bands(std::uint32_t e) const {
    const auto beside = rows_.beside(e, kEvenBends);
    if (!beside) return false;
    const auto [near, far] = std::minmax((*beside)[0].distance, (*beside)[1].distance);
    return far < kEvenBends.most * near &&
           (is_shallow(e, topology_.edges[e].face0) || is_shallow(e, topology_.edges[e].face1));
  }

  bool is_shallow(std::uint32_t e, std::uint32_t face) const {
    EdgeRows::Step step{e, face};
    for (int k = 0; k < kMostShallowFacets; ++k) {
      step = rows_.next(step, kEvenBends);
      if (!step || patches_.patch_of[step.face] != patches_.patch_of[face]) return true;
    }
    return false;
  }

  struct Bent {
    double across = 0, largest = 0;  ///< curvatures
  };

  Bent bent_at(std::uint32_t face, const Point3& at, const Point3& across) const {
    const std::uint32_t p = patches_.patch_of[face];
    if (p == kNone) return {};
    const Patch& patch = patches_.list[p];
    const double k = patch.surface.curvature(at, across);
    return {patch.outward ? k : -k, patch.surface.largest_curvature(at)};
  }

  bool bend_alike(const Edge& edge, const Point3& normal) const {
    const Point3 &a = scene_.vertices[edge.v0], &b = scene_.vertices[edge.v1], middle = (a + b) * 0.5;
    const Point3 across = glm::cross(patches_.normal(edge.face0, middle, normal), b - a);
    const double length = glm::length(across);
    if (!(length > 0)) return false;
    const Bent first = bent_at(edge.face0, middle, across / length), second = bent_at(edge.face1, middle, across / length);
    return std::abs(first.across - second.across) <= kLikeCurvature * std::max(first.largest, second.largest);
  }

  const Scene& scene_;
  const Topology& topology_;
  std::span<const glm::vec3> normals_;
  const Patches& patches_;
  EdgeRows rows_;
  double sharp_, flat_, bent_, mesh_bent_;  ///< cosines
  std::vector<Chain> chains_;
};

}  // namespace

std::vector<PatchEdge> classify_patch_edges(const Scene& scene, const Topology& topology, const MeshAngles& angles,
                                            const Patches& patches, double sharp_degrees) {
  const EdgeClassifier classify(scene, topology, angles.normals, patches, sharp_degrees);
  std::vector<PatchEdge> edges(topology.edges.size());
  const bool has_surfaces = !patches.list.empty();
  std::vector<BorderEvidence> evidence(has_surfaces ? edges.size() : 0);
  // All others stay unknown.
  const std::vector<std::uint32_t> outside = edges_outside_freeforms(topology, patches);
  parallel_blocks(outside.size(), kShortWorkBlock, [&](std::size_t begin, std::size_t end) {
    for (const std::uint32_t e : std::span(outside).subspan(begin, end - begin)) {
      edges[e] = classify(e);
      if (has_surfaces) evidence[e] = classify.evidence(e, edges[e]);
    }
  });
  if (has_surfaces) decide_by_whole_borders(scene, topology, patches, evidence, edges);
  for (const std::uint32_t e : patches.plane_edges) edges[e] = PatchEdge::inside;
  smooth_twisted_strips(scene, topology, angles, edges);
  return edges;
}

void mark_bands(const Scene& scene, const Topology& topology, std::span<const glm::vec3> normals,
                std::span<const PatchEdge> edges, Patches& patches) {
  const double bent = sine_cosine_degrees(kLargestBend).cosine;
  std::map<std::array<std::uint32_t, 2>, SharedBorder> shared;  // by two patches, the lower number first
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const Edge& edge = topology.edges[e];
    if (edge.face1 == kNone) continue;
    const auto [p, q] = std::minmax(patches.patch_of[edge.face0], patches.patch_of[edge.face1]);
    if (q == kNone || p == q) continue;
    const Point3 n0(normals[edge.face0]), n1(normals[edge.face1]);
    SharedBorder& both = shared[{p, q}];
    const double length = edge_length(scene, edge);
    both.length += length;
    const bool is_line = edges[e] == PatchEdge::tangent || edges[e] == PatchEdge::sharp;
    if (!is_line && glm::dot(n0, n1) >= bent) both.open += length;
    for (const std::uint32_t v : {edge.v0, edge.v1}) {
      const Point3& at = scene.vertices[v];
      const Point3 turn = glm::cross(patches.normal(edge.face0, at, n0), patches.normal(edge.face1, at, n1));
      both.sine = std::max(both.sine, glm::length(turn));
    }
  }
  std::erase_if(shared, [](const auto& item) { return item.second.open <= kMostOpen * item.second.length; });
  if (shared.empty()) return;
  std::vector<double> area(patches.list.size(), 0);
  for (std::uint32_t f = 0; f < patches.patch_of.size(); ++f) {
    if (patches.patch_of[f] != kNone) area[patches.patch_of[f]] += glm::length(double_area(scene, f)) / 2;
  }
  for (const auto& [pair, both] : shared) {
    const double depth = std::min(area[pair[0]], area[pair[1]]) / both.length;
    const double sag = std::max(patches.list[pair[0]].sag, patches.list[pair[1]].sag);
    // The sag of an arc is an eighth of its length times its turn.
    if (depth * both.sine / 8 > kMitreSags * sag) continue;
    for (const std::uint32_t patch : pair) patches.list[patch].is_band = true;
  }
}

}  // namespace ligne
