#include "scene/patches/freeform.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <unordered_map>

#include "base/indices_where.hpp"
#include "base/no_index.hpp"
#include "scene/model/faces_and_edges.hpp"
#include "scene/patches/borders/patch_outlines.hpp"
#include "scene/patches/facet_rows.hpp"
#include "scene/patches/find_patches.hpp"

namespace ligne {

double depth_behind(const Scene& scene, std::span<const std::uint32_t> corners, const Edge& edge) {
  const Point3& from = scene.vertices[edge.v0];
  const Point3 along = glm::normalize(scene.vertices[edge.v1] - from);
  double depth = 0;
  for (const std::uint32_t v : corners) depth = std::max(depth, glm::length(glm::cross(along, scene.vertices[v] - from)));
  return depth;
}

namespace {

// Adjustable.
/// Most corners of a piece that cuts left of a facet of four.
constexpr std::size_t kMostPieceCorners = 6;
/// Least part of the border of a few facets with patches at which the rows of these go on, where the facets are no planes.
constexpr double kMostOfBorder = 0.5;
/// Least parts of the border of a facet amid a free form beside which facets are about as deep, and beside which they are
/// single triangles: panels of domes have none. Adjustable.
constexpr double kAlikeBorder = 0.75, kTriangleBorder = 0.1;
/// Most corners of such a facet and of those beside it, whose depth is measured from each common edge: planes have
/// thousands.
constexpr std::size_t kMostAmidCorners = 64;
/// Most faces of a facet in a slightly curved wall, and least length of the sides at which it goes on, in lengths of its
/// longest side.
constexpr std::size_t kMostWallFaces = 4;
constexpr double kSlightSides = 1.5;
/// Sines of the bends at which it goes on, 0.14 to 0.5 degrees: decimations bend planes by less.
constexpr double kLeastSlightSine = 0.00244346, kSlightSine = 0.00872654;
/// Least number of corners of a facet that may be a plane by its depth or by the surfaces beside it: free forms have
/// triangles of any shape.
constexpr std::size_t kPlaneCorners = 4;
/// Largest number of arcs of a facet whose opposite sides are compared: all pairs of them.
constexpr std::size_t kMostSides = 16;
/// Largest factor between the bends on opposite sides of a facet that goes on in a row. Adjustable.
constexpr double kLikeBends = 2.2;
/// Largest angle between a plane and a surface that runs into it, as a fraction of the bend of their facets. A plane has
/// half of a step of the surface as its bend and no angle; a facet that goes on in a row has an angle of half of its own
/// step.
constexpr double kTangentPart = 0.01;
/// Least depth of such a plane, in depths of the facet of the surface. Facets of a free form are less unlike.
constexpr double kTangentDepths = 1.5;
/// Largest depth of such a plane, in lengths of the edge. A strip along a fillet has the normal of the surface at its end,
/// too.
constexpr double kLongestDepth = 8;

/// Largest bend of two triangles that are the halves of one facet, as a part of the least bend of their other edges, and
/// the least sine of that bend: planes meet at 10 degrees or more. Adjustable.
constexpr double kHalfPart = 0.04, kLeastHalfSine = 0.17364818;

/// Finds planes beside the narrow facets of fillets and free forms.
class WidePlanes {
 public:
  WidePlanes(const Scene& scene, const Topology& topology, const FacetGraph& graph)
      : scene_(scene), topology_(topology), graph_(graph) {}

  /// Whether a facet of four corners or more is much deeper than those beside it, but for planes like it to which it does
  /// not bend alike on opposite sides.
  bool is_wide(std::uint32_t f) const {
    if (graph_.vertices[f].size() < kPlaneCorners) return false;
    const auto arcs = graph_.arcs_of(f);
    const auto is_like_it = [&](const FacetGraph::Arc& arc) {
      return !graph_.has_many_corners(arc.facet) && !is_narrow(f, arc);
    };
    if (std::ranges::none_of(arcs, is_like_it)) return true;
    return is_wide_across(f) && std::ranges::all_of(arcs, [&](const FacetGraph::Arc& arc) {
             return !is_like_it(arc) || is_wide_across(arc.facet);
           });
  }

 private:
  /// Whether a facet is much deeper than the one beyond an arc.
  bool is_narrow(std::uint32_t f, const FacetGraph::Arc& arc) const {
    if (graph_.has_many_corners(arc.facet)) return false;
    if (graph_.is_sliver[arc.facet]) return true;
    const Edge& edge = topology_.edges[arc.edge];
    return depth_behind(scene_, graph_.vertices[f], edge) >=
           kPlaneDepths * depth_behind(scene_, graph_.vertices[arc.facet], edge);
  }

  /// Whether facets far narrower than the facet itself lie on two opposite sides of it, and no two others, to which it bends
  /// alike, lie on opposite sides: these would be strips of a fillet or bands of a vase. Edges without a common vertex are
  /// opposite.
  bool is_wide_across(std::uint32_t f) const {
    const auto arcs = graph_.arcs_of(f);
    if (graph_.vertices[f].size() < kPlaneCorners || arcs.size() > kMostSides) return false;
    double width = std::numeric_limits<double>::infinity();
    for (const FacetGraph::Arc& arc : arcs)
      width = std::min(width, depth_behind(scene_, graph_.vertices[f], topology_.edges[arc.edge]));
    const auto is_far_narrower = [&](const FacetGraph::Arc& arc) {
      if (graph_.has_many_corners(arc.facet)) return false;
      return width >= kPlaneDepths * depth_behind(scene_, graph_.vertices[arc.facet], topology_.edges[arc.edge]);
    };
    bool is_wide = false;
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      const bool is_one_narrow = is_far_narrower(arcs[i]);
      for (std::size_t k = 0; k < i; ++k) {
        if (share_vertex(topology_.edges[arcs[i].edge], topology_.edges[arcs[k].edge])) continue;
        const bool is_other_narrow = is_far_narrower(arcs[k]);
        if (is_one_narrow && is_other_narrow) {
          is_wide = true;
        } else if (!is_one_narrow && !is_other_narrow) {
          const double ratio = bend_at(graph_, f, arcs[i]) / bend_at(graph_, f, arcs[k]);
          if (ratio >= 1 / kLikeBends && ratio <= kLikeBends) return false;
        }
      }
    }
    return is_wide;
  }

  const Scene& scene_;
  const Topology& topology_;
  const FacetGraph& graph_;
};

/// Whether a facet of four corners or more is a plane into which a surface runs: at both ends of an edge, its normal is that
/// of the surface, while the facets bend there, and it is much deeper than that of the surface.
bool is_tangent_plane(const Scene& scene, const Topology& topology, const FacetGraph& graph, const FacetSurfaces& surfaces,
                      std::uint32_t f) {
  if (graph.vertices[f].size() < kPlaneCorners) return false;
  const Point3& normal = graph.frames[f].normal;
  const auto sine = [&](const Point3& other) { return glm::length(glm::cross(normal, other)); };
  return std::ranges::any_of(graph.arcs_of(f), [&](const FacetGraph::Arc& arc) {
    const std::uint32_t p = surfaces.patch_of[arc.facet];
    if (p == kNone) return false;
    const Edge& edge = topology.edges[arc.edge];
    const double bend = sine(graph.frames[arc.facet].normal);
    const double depth = depth_behind(scene, graph.vertices[f], edge);
    if (bend < kLeastRowSine || depth < kTangentDepths * depth_behind(scene, graph.vertices[arc.facet], edge)) return false;
    if (depth > kLongestDepth * edge_length(scene, edge)) return false;
    return std::ranges::all_of(std::array{edge.v0, edge.v1}, [&](std::uint32_t v) {
      return sine(surfaces.patches[p].surface.normal(scene.vertices[v])) <= kTangentPart * bend;
    });
  });
}

/// Tells which facets belong to regions of kFewestFreeform facets or more that have no surface and are no planes. Visits
/// only the facets near those asked for.
class RegionFinder {
 public:
  RegionFinder(const Scene& scene, const Topology& topology, const FacetGraph& graph, const FacetSurfaces& surfaces)
      : scene_(scene),
        topology_(topology),
        graph_(graph),
        surfaces_(surfaces),
        planes_(scene, topology, graph),
        state_(graph.size(), State::unknown),
        group_(graph.size()) {}

  bool is_in_region(std::uint32_t f) {
    if (state_[f] == State::unknown) visit_from(f);
    return state_[f] == State::region;
  }

  /// A facet that stands for the connected ones of a facet in no region, after is_in_region().
  std::uint32_t group_of(std::uint32_t f) const { return group_[f]; }

  bool is_free(std::uint32_t f) const {
    return surfaces_.patch_of[f] == kNone && !graph_.has_many_corners(f) && !graph_.is_sliver[f] && !planes_.is_wide(f) &&
           !is_tangent_plane(scene_, topology_, graph_, surfaces_, f);
  }

 private:
  enum class State : std::uint8_t { unknown, alone, region };

  /// Decides about a facet and those that are visited from it.
  void visit_from(std::uint32_t f) {
    state_[f] = State::alone;
    group_[f] = f;
    if (!is_free(f)) return;
    visited_.assign(1, f);
    bool is_region = false;
    for (std::size_t i = 0; i < visited_.size() && !is_region; ++i) {
      for (const FacetGraph::Arc& arc : graph_.arcs_of(visited_[i])) {
        is_region |= state_[arc.facet] == State::region;
        if (state_[arc.facet] != State::unknown) continue;
        state_[arc.facet] = State::alone;
        const bool joins = is_free(arc.facet);
        group_[arc.facet] = joins ? f : arc.facet;
        if (joins) visited_.push_back(arc.facet);
      }
      is_region |= visited_.size() >= kFewestFreeform;
    }
    if (!is_region) return;
    for (const std::uint32_t visited : visited_) state_[visited] = State::region;
  }

  const Scene& scene_;
  const Topology& topology_;
  const FacetGraph& graph_;
  const FacetSurfaces& surfaces_;
  WidePlanes planes_;
  std::vector<State> state_;  ///< per facet; alone: in no region
  std::vector<std::uint32_t> group_, visited_;
};

/// The border between a few facets without a surface and the patches around them.
struct RowBorder {
  double length = 0, in_row = 0;  ///< of all edges; of those at which the rows of the patches go on

  void add(const Scene& scene, const Topology& topology, const FacetGraph& graph, std::span<const std::uint32_t> patch_of,
           const EdgeRows& rows, std::uint32_t f) {
    for (const FacetGraph::Arc& arc : graph.arcs_of(f)) {
      if (patch_of[arc.facet] == kNone) continue;
      const Edge& edge = topology.edges[arc.edge];
      const auto faces = graph.faces[arc.facet];
      const std::uint32_t beyond = std::ranges::find(faces, edge.face0) != faces.end() ? edge.face0 : edge.face1;
      const double part = edge_length(scene, edge);
      length += part;
      const EdgeRows::Step step = rows.next({arc.edge, beyond}, kEvenBends);
      const auto is_inside = [&](const FacetGraph::Arc& next) {
        return next.edge == step.edge && patch_of[next.facet] != kNone;
      };
      if (step && std::ranges::any_of(graph.arcs_of(arc.facet), is_inside)) in_row += part;
    }
  }
  bool is_row() const { return length > 0 && in_row >= kMostOfBorder * length; }
};

/// Whether a facet is a part of a free form of triangles, some of which lie in one plane: beside all of its
/// edges lie facets without a surface that bend by little, beside most of its border they are about as deep, and beside a
/// part of it single triangles.
bool is_amid_triangles(const Scene& scene, const Topology& topology, const FacetGraph& graph,
                       std::span<const std::uint32_t> patch_of, std::uint32_t f) {
  const auto arcs = graph.arcs_of(f);
  const auto is_large = [&](std::uint32_t g) { return graph.vertices[g].size() > kMostAmidCorners; };
  if (is_large(f)) return false;
  std::size_t sides = 0;
  for (const std::uint32_t face : graph.faces[f]) sides += scene.faces.contour(face, 0).size();
  // The faces of a disc are joined by one inner edge less than there are faces.
  if (arcs.size() + 2 * (graph.faces[f].size() - 1) != sides) return false;
  double length = 0, alike = 0, triangles = 0;
  for (const FacetGraph::Arc& arc : arcs) {
    const std::uint32_t g = arc.facet;
    if (patch_of[g] != kNone || is_large(g)) return false;
    const Edge& edge = topology.edges[arc.edge];
    const double part = edge_length(scene, edge);
    length += part;
    const double depth = depth_behind(scene, graph.vertices[g], edge);
    if (depth_behind(scene, graph.vertices[f], edge) < kPlaneDepths * depth) alike += part;
    if (graph.vertices[g].size() == 3) triangles += part;
  }
  return length > 0 && alike >= kAlikeBorder * length && triangles >= kTriangleBorder * length;
}

/// Whether a facet is a part of a slightly curved wall of long triangles, a few of which lie in one plane: single triangles
/// without a surface, to which it bends by very little, lie beside both of its long sides.
bool is_in_slight_wall(const Scene& scene, const Topology& topology, const FacetGraph& graph,
                       std::span<const std::uint32_t> patch_of, std::uint32_t f) {
  if (graph.faces[f].size() > kMostWallFaces) return false;
  double slight = 0, longest = 0;
  for (const FacetGraph::Arc& arc : graph.arcs_of(f)) {
    const double length = edge_length(scene, topology.edges[arc.edge]);
    longest = std::max(longest, length);
    if (patch_of[arc.facet] != kNone || graph.vertices[arc.facet].size() != 3) continue;
    const double sine = std::abs(bend_at(graph, f, arc));
    if (sine >= kLeastSlightSine && sine <= kSlightSine) slight += length;
  }
  return slight > 0 && slight >= kSlightSides * longest;
}

/// The arc of a single triangle at its longest edge, or null if there is none.
const FacetGraph::Arc* longest_arc(const Scene& scene, const Topology& topology, const FacetGraph& graph, std::uint32_t f) {
  const auto corners = graph.vertices[f];
  if (corners.size() != 3 || graph.faces[f].size() != 1) return nullptr;
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k)
    longest = std::max(longest, glm::distance(scene.vertices[corners[k]], scene.vertices[corners[(k + 1) % 3]]));
  for (const FacetGraph::Arc& arc : graph.arcs_of(f)) {
    if (edge_length(scene, topology.edges[arc.edge]) == longest) return &arc;
  }
  return nullptr;
}

/// The other half of a facet of four corners that do not quite lie in a plane, as where the edges of a part were made
/// inexactly, or kNone: a triangle bends to it, over the longest edge of both, by far less than both do elsewhere.
std::uint32_t other_half(const Scene& scene, const Topology& topology, const FacetGraph& graph, std::uint32_t f) {
  const FacetGraph::Arc* diagonal = longest_arc(scene, topology, graph, f);
  if (!diagonal || graph.is_sliver[f] || graph.is_sliver[diagonal->facet]) return kNone;
  const FacetGraph::Arc* back = longest_arc(scene, topology, graph, diagonal->facet);
  if (!back || back->edge != diagonal->edge) return kNone;
  const double least = std::max(kLeastHalfSine, std::abs(bend_at(graph, f, *diagonal)) / kHalfPart);
  const bool is_half = std::ranges::all_of(std::array{f, diagonal->facet}, [&](std::uint32_t half) {
    return std::ranges::all_of(graph.arcs_of(half), [&](const FacetGraph::Arc& arc) {
      return arc.edge == diagonal->edge || std::abs(bend_at(graph, half, arc)) >= least;
    });
  });
  return is_half ? diagonal->facet : kNone;
}

/// Whether a triangle and its other_half() lie beside facets of four corners or more alone. A free form of triangles has
/// others beside them.
bool is_half_facet(const Scene& scene, const Topology& topology, const FacetGraph& graph,
                   std::span<const std::uint32_t> patch_of, std::uint32_t f) {
  const std::uint32_t other = other_half(scene, topology, graph, f);
  if (other == kNone) return false;
  bool has_others = false;
  for (const std::uint32_t half : {f, other}) {
    for (const FacetGraph::Arc& arc : graph.arcs_of(half)) {
      if (arc.facet == f || arc.facet == other) continue;
      if (patch_of[arc.facet] != kNone || graph.vertices[arc.facet].size() < kPlaneCorners) return false;
      has_others = true;
    }
  }
  return has_others;
}

}  // namespace

std::vector<std::uint8_t> freeform_facets(const Scene& scene, const Topology& topology, const FacetGraph& graph,
                                          const FacetSurfaces& surfaces, const EdgeRows& edge_rows) {
  const std::span<const std::uint32_t> patch_of = surfaces.patch_of;
  std::vector<std::uint8_t> freeform(graph.size());
  // Facets that the shape of a single one does not decide.
  const std::vector<std::uint32_t> others = indices_where(graph.size(), [&](std::size_t i) {
    const auto f = static_cast<std::uint32_t>(i);
    const bool is_triangle = graph.vertices[f].size() == 3 && graph.faces[f].size() == 1 &&
                             !(patch_of[f] == kNone && is_half_facet(scene, topology, graph, patch_of, f));
    freeform[f] = patch_of[f] == kNone && (graph.is_sliver[f] || is_triangle);
    return patch_of[f] == kNone && !freeform[f];
  });
  if (others.empty()) return freeform;
  RegionFinder regions(scene, topology, graph, surfaces);
  const FacetRows rows(scene, topology, graph, patch_of);
  const WidePlanes planes(scene, topology, graph);
  std::unordered_map<std::uint32_t, RowBorder> borders;  // by group
  const auto may_be_cut = [&](std::uint32_t f) {
    return graph.vertices[f].size() <= kMostPieceCorners && !planes.is_wide(f);
  };
  for (const std::uint32_t f : others) {
    if (!regions.is_in_region(f) && (regions.is_free(f) || may_be_cut(f)))
      borders[regions.group_of(f)].add(scene, topology, graph, patch_of, edge_rows, f);
  }
  for (const std::uint32_t f : others)
    freeform[f] = regions.is_in_region(f) || borders[regions.group_of(f)].is_row() || rows.is_in_row(f) ||
                  rows.ends_row(f) || rows.is_in_long_row(f) || is_amid_triangles(scene, topology, graph, patch_of, f) ||
                  is_in_slight_wall(scene, topology, graph, patch_of, f);
  return freeform;
}

bool is_part(const Scene& scene, const Patches& patches, const Object& object) {
  /// Adjustable. Most part of the area that free forms take.
  constexpr double kMostFreeArea = 0.5;
  const auto is_free = [&](std::uint32_t f) { return patches.is_freeform[f] && patches.patch_of[f] == kNone; };
  double others = 0, free = 0;
  for (std::uint32_t f = object.face_begin; f < object.face_end; ++f) {
    if (!is_free(f)) others += glm::length(double_area(scene, f));
  }
  const double most = kMostFreeArea / (1 - kMostFreeArea) * others;
  for (std::uint32_t f = object.face_begin; f < object.face_end && free <= most; ++f) {
    if (is_free(f)) free += glm::length(double_area(scene, f));
  }
  return free <= most;
}

}  // namespace ligne
