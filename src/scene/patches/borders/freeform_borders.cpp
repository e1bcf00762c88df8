#include "scene/patches/borders/freeform_borders.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "base/indices_where.hpp"
#include "base/no_index.hpp"
#include "geometry/degrees.hpp"
#include "scene/patches/borders/edge_chains.hpp"
#include "scene/patches/borders/patch_edges.hpp"
#include "scene/patches/borders/patch_outlines.hpp"
#include "scene/patches/find_patches.hpp"
#include "scene/patches/freeform.hpp"

namespace ligne {
namespace {

// Adjustable.
/// The normal at an edge is extrapolated from the first facet behind it and from facets near that one. They are at most
/// kMostRings arcs away, at most kMostFacets in all, and, except for direct neighbours, at most kLookInDepths depths of
/// the first facet behind the edge.
constexpr double kLookInDepths = 2.2;
constexpr int kMostRings = 3;
constexpr std::size_t kMostFacets = 24;
/// Largest angle, in degrees, between a facet of a free form and a surface on its far side that continues it: half of
/// the default crease angle.
constexpr double kBeyondDegrees = 15;
/// Facets beyond the ends of an edge count up to so many of its lengths away.
constexpr double kBesideLengths = 1;
/// Least spread of the facets' middles behind the edge, as a fraction of the first facet's depth. With less, they do
/// not show how the form turns.
constexpr double kLeastSpread = 0.25;
/// Largest number of corners of a plane that are tested for its depth, evenly spread: thousands of edges may lie beside
/// it.
constexpr std::size_t kMostPlaneCorners = 64;
/// Largest number of edges of a chain that may be a flaw of a smooth mesh.
constexpr std::uint32_t kFleckEdges = 2;

/// Least bend, in radians (0.14 degrees), at the border of a plane: what bends less is a part of the plane of which a
/// decimation has moved corners. A form that turns by so little over half of its first facet has no tangent line either.
constexpr double kLeastBend = 0.0025;

/// Least difference between the curvatures of a free form and a surface that counts, as a fraction of the larger one. A
/// smaller one may be an error of the first facets of a free form that the surface is a part of.
constexpr double kUnlikeCurvature = 0.5;
/// Largest turn over the first facet, in radians, that gives a usable curvature.
constexpr double kLargestTurn = 1;

constexpr double kUnknownTurn = 2 * std::numbers::pi;

double angle_between(const Point3& a, const Point3& b) { return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)); }

class BorderFinder {
 public:
  BorderFinder(const Scene& scene, const Topology& topology, const FacetGraph& graph, const FacetSurfaces& surfaces,
               std::span<const PatchOutline> outlines)
      : scene_(scene),
        topology_(topology),
        graph_(graph),
        patch_of_(surfaces.patch_of),
        patches_(surfaces.patches),
        outlines_(outlines),
        is_freeform_(surfaces.is_freeform) {}

  std::vector<FreeformBorder> run() {
    const auto ends = [&](std::uint32_t f, const FacetGraph::Arc& arc) {
      return !is_freeform_[arc.facet] && !continues_plane(f, arc.facet);
    };
    const std::vector<std::uint32_t> at_border = indices_where(graph_.size(), [&](std::size_t i) {
      const auto f = static_cast<std::uint32_t>(i);
      return is_freeform_[f] && !graph_.is_sliver[f] &&
             std::ranges::any_of(graph_.arcs_of(f), [&](const FacetGraph::Arc& arc) { return ends(f, arc); });
    });
    if (at_border.empty()) return {};
    reached_by_.assign(graph_.size(), kNone);
    for (const std::uint32_t f : at_border) {
      for (const FacetGraph::Arc& arc : graph_.arcs_of(f)) {
        if (ends(f, arc)) add(f, arc);
      }
    }
    std::ranges::sort(found_, {}, &Found::edge);
    number_chains();
    return {found_.begin(), found_.end()};
  }

 private:
  struct Found : FreeformBorder {
    std::uint32_t facet = 0;   ///< the first facet of the free form
    std::uint32_t beyond = 0;  ///< see number_beyond()
  };

  /// Part of a line.
  struct Interval {
    double low = 1e300, high = -1e300;

    void add(double x) {
      low = std::min(low, x);
      high = std::max(high, x);
    }
    double middle() const { return (low + high) / 2; }
  };

  /// An edge of a free form: its ends, and the unit vectors along it and into the first facet.
  struct Side {
    Point3 from, to, along{0, 0, 0}, inwards{0, 0, 0};
    double length() const { return glm::distance(from, to); }

    /// How far points lie behind the edge.
    double depth(const Point3& p) const { return glm::dot(p - from, inwards); }

    /// The weight of what lies beside the edge, continued at both ends: its length along the edge. The small facets round
    /// the end of a fillet tell little of the side of its long ones.
    double weight(const Interval& along_edge) const {
      const double size = length(), low = -kBesideLengths * size, high = (1 + kBesideLengths) * size;
      return std::max(0.0, std::min(along_edge.high, high) - std::max(along_edge.low, low));
    }
  };

  Interval depths(std::uint32_t f, const Side& side) const {
    Interval depths;
    for (const std::uint32_t v : graph_.vertices[f]) depths.add(side.depth(scene_.vertices[v]));
    return depths;
  }

  double weight(std::span<const std::uint32_t> vertices, const Side& side) const {
    Interval along;
    for (const std::uint32_t v : vertices) along.add(glm::dot(scene_.vertices[v] - side.from, side.along));
    return side.weight(along);
  }

  /// Whether a plane beyond an edge is much deeper than the first facet of the free form.
  bool is_deep(std::uint32_t plane, const Side& side, double first) const {
    const auto corners = graph_.vertices[plane];
    const std::size_t step = corners.size() / kMostPlaneCorners + 1;
    for (std::size_t i = 0; i < corners.size(); i += step) {
      if (side.depth(scene_.vertices[corners[i]]) <= -kPlaneDepths * first) return true;
    }
    return false;
  }

  /// Lists the free-form facets near f in facets_: f first, then its neighbours.
  void reach(std::uint32_t f, std::uint32_t edge) {
    facets_.assign(1, f);
    reached_by_[f] = edge;
    std::size_t next = 0;
    for (int ring = 0; ring < kMostRings; ++ring) {
      for (const std::size_t last = facets_.size(); next < last; ++next) {
        for (const FacetGraph::Arc& arc : graph_.arcs_of(facets_[next])) {
          if (!is_freeform_[arc.facet] || graph_.is_sliver[arc.facet] || reached_by_[arc.facet] == edge) continue;
          if (facets_.size() >= kMostFacets) break;
          reached_by_[arc.facet] = edge;
          facets_.push_back(arc.facet);
        }
      }
      if (ring == 0) near_ = facets_.size();
    }
  }

  /// The line of least squares through normals over depths.
  struct Line {
    double count = 0, sum = 0, squares = 0;
    Point3 normals{0, 0, 0}, products{0, 0, 0};

    void add(double weight, double depth, const Point3& normal) {
      count += weight;
      sum += weight * depth;
      squares += weight * depth * depth;
      normals += weight * normal;
      products += weight * depth * normal;
    }
    /// Sum of the squares of the distances of the depths from their mean, and the mean of these; 0 without samples.
    double total_spread() const { return count > 0 ? squares - sum * sum / count : 0; }
    double spread() const { return count > 0 ? total_spread() / count : 0; }
    Point3 slope() const { return (products - sum / count * normals) / total_spread(); }
    Point3 begin() const { return (normals - sum * slope()) / count; }
  };

  /// Unit normal at an edge, and its change per unit of distance behind the edge.
  struct Continued {
    Point3 normal, slope{0, 0, 0};
  };

  /// Extrapolates the normal of the free form to an edge, by least squares. The data are the normals of the facets near
  /// f, each at the middle of its depths, and the normals of other surfaces that continue the form on its far side,
  /// since it may be only one facet deep. Each counts by its weight(), or all alike if those of weight are of one depth. A
  /// facet alone counts as flat. If its neighbours do not show how the form turns, the turn is kUnknownTurn. `opposite`:
  /// number_beyond() of the facet on the other side of the edge.
  Continued continued(std::uint32_t f, std::uint32_t edge, std::uint32_t opposite, const Side& side, double first) {
    reach(f, edge);
    Line weighted, equal;
    const auto add_sample = [&](double weight, double depth, const Point3& normal) {
      weighted.add(weight, depth, normal);
      equal.add(1, depth, normal);
    };
    for (std::size_t i = 0; i < facets_.size(); ++i) {
      const std::uint32_t g = facets_[i];
      const double s = depths(g, side).middle();
      if (s < 0 || (i >= near_ && s > kLookInDepths * first)) continue;
      add_sample(weight(graph_.vertices[g], side), s, graph_.frames[g].normal);
      for (const FacetGraph::Arc& arc : graph_.arcs_of(g)) {
        const std::uint32_t beyond = arc.edge == edge ? opposite : number_beyond(arc.facet);
        if (is_freeform_[arc.facet] || beyond == opposite) continue;
        if (glm::dot(graph_.frames[g].normal, graph_.frames[arc.facet].normal) < beyond_cosine_) continue;
        const Edge& far = topology_.edges[arc.edge];
        const Point3 at = 0.5 * (scene_.vertices[far.v0] + scene_.vertices[far.v1]);
        const double depth = side.depth(at);
        if (depth < s || depth > kLookInDepths * first) continue;
        add_sample(weight(std::array{far.v0, far.v1}, side), depth, other_normal(arc.facet, at));
      }
    }
    const Continued none{graph_.frames[f].normal,
                         facets_.size() > 1 ? kUnknownTurn / first * side.inwards : Point3(0, 0, 0)};
    const double least = kLeastSpread * first;
    const bool is_spread = weighted.spread() > least * least;
    if (!is_spread && !(equal.total_spread() > least * least)) return none;
    const Line& line = is_spread ? weighted : equal;
    const Point3 slope = line.slope(), begins = line.begin();
    const double size = glm::length(begins);
    return size > 0 ? Continued{begins / size, slope} : none;
  }

  /// Whether a facet lies in the plane beside it but for corners that a decimation has moved.
  bool continues_plane(std::uint32_t f, std::uint32_t beyond) const {
    return patch_of_[beyond] == kNone && angle_between(graph_.frames[f].normal, graph_.frames[beyond].normal) < kLeastBend;
  }

  /// Whether a facet meets all others at an angle.
  bool stands_alone(std::uint32_t f) const {
    return std::ranges::all_of(graph_.arcs_of(f), [&](const FacetGraph::Arc& arc) {
      return glm::dot(graph_.frames[f].normal, graph_.frames[arc.facet].normal) <= edge_cosine_;
    });
  }

  /// Numbers the plane or surface of a facet: planes by their facets, and then patches.
  std::uint32_t number_beyond(std::uint32_t facet) const {
    const std::uint32_t patch = patch_of_[facet];
    return patch == kNone ? facet : static_cast<std::uint32_t>(graph_.size()) + patch;
  }

  Point3 other_normal(std::uint32_t facet, const Point3& at) const {
    const std::uint32_t p = patch_of_[facet];
    if (p == kNone) return graph_.frames[facet].normal;
    const Point3 normal = patches_[p].surface.normal(at);
    return patches_[p].outward ? normal : -normal;
  }

  void add(std::uint32_t f, const FacetGraph::Arc& arc) {
    Side side{scene_.vertices[topology_.edges[arc.edge].v0], scene_.vertices[topology_.edges[arc.edge].v1]};
    side.inwards = glm::cross(graph_.frames[f].normal, side.to - side.from);
    if (glm::dot(side.inwards, graph_.frames[f].middle - side.from) < 0) side.inwards = -side.inwards;
    const double size = glm::length(side.inwards);
    if (!(size > 0)) return;
    side.inwards /= size;
    side.along = glm::normalize(side.to - side.from);
    const double first = depths(f, side).high;
    const Continued free = continued(f, arc.edge, number_beyond(arc.facet), side, first);
    const Point3 middle = 0.5 * (side.from + side.to), other = other_normal(arc.facet, middle);
    Found border;
    border.edge = arc.edge;
    border.facet = f;
    border.length = side.length();
    border.turn = glm::length(free.slope) * first;
    border.angle = angle_between(free.normal, other);
    if (border.turn > 0) {
      const Point3 way = free.slope / glm::length(free.slope);
      const double gone = std::clamp(glm::dot(other - free.normal, way), 0.0, border.turn / 2);
      border.angle = angle_between(glm::normalize(free.normal + gone * way), other);
    }
    const std::uint32_t patch = patch_of_[arc.facet];
    border.is_beside_band = patch != kNone && outlines_[patch].is_band();
    border.is_beside_plane = patch == kNone && is_deep(arc.facet, side, first);
    // A profile may end anywhere within a free form, and its curvature at the end is no parameter.
    const bool has_curvature = patch != kNone && patches_[patch].surface.kind <= SurfaceKind::torus;
    if (has_curvature && border.turn > 0 && border.turn <= kLargestTurn) {
      const double here = glm::dot(free.slope, side.inwards), k = patches_[patch].surface.curvature(middle, side.inwards);
      const double there = patches_[patch].outward ? k : -k;
      border.bends_otherwise = std::abs(here - there) > kUnlikeCurvature * std::max(std::abs(here), std::abs(there));
    }
    border.beyond = number_beyond(arc.facet);
    found_.push_back(border);
  }

  void number_chains() {
    std::vector<BorderEdge> borders;
    borders.reserve(found_.size());
    for (const Found& border : found_) borders.push_back({border.edge, border.beyond});
    DisjointSets sets = edge_chains(scene_, topology_, borders);
    std::vector<std::uint32_t> sizes(found_.size(), 0);
    for (std::uint32_t i = 0; i < found_.size(); ++i) ++sizes[found_[i].chain = sets.find(i)];
    for (Found& border : found_) {
      border.is_fleck = border.turn == 0 && sizes[border.chain] <= kFleckEdges && !stands_alone(border.facet);
    }
  }

  const Scene& scene_;
  const Topology& topology_;
  const FacetGraph& graph_;
  std::span<const std::uint32_t> patch_of_;
  std::span<const Patch> patches_;
  std::span<const PatchOutline> outlines_;
  std::span<const std::uint8_t> is_freeform_;
  std::vector<std::uint32_t> reached_by_;  ///< per facet: the edge from which it was reached last
  std::vector<std::uint32_t> facets_;      ///< result of reach()
  std::size_t near_ = 0;                   ///< number of facets_ that are f and its neighbours
  std::vector<Found> found_;
  const double beyond_cosine_ = sine_cosine_degrees(kBeyondDegrees).cosine;
  const double edge_cosine_ = sine_cosine_degrees(kSurfaceCreaseDegrees).cosine;
};

}  // namespace

std::vector<FreeformBorder> freeform_borders(const Scene& scene, const Topology& topology, const FacetGraph& graph,
                                             const FacetSurfaces& surfaces, std::span<const PatchOutline> outlines) {
  return BorderFinder(scene, topology, graph, surfaces, outlines).run();
}

}  // namespace ligne
