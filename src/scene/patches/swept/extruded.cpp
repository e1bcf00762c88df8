#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <unordered_map>

#include "base/indices_where.hpp"
#include "scene/patches/freeform.hpp"
#include "scene/patches/swept/swept_facets.hpp"

namespace ligne {
namespace {

// Adjustable.
/// Largest sine of the angle between rulings, however far their ends may lie beside it, and that of which programs that
/// compute the corners one by one are capable.
constexpr double kMostSine = 0.02, kLikeSine = 1e-4;
/// Least length of a ruling in tolerances of its ends: shorter ones have any direction.
constexpr double kLeastLength = 8;
/// Most directions of rulings that are tried from a facet: those of its longest edges.
constexpr std::size_t kMostTries = 2;
/// Number of facets from which the search begins, and least number of them from which as many strips are found as a surface
/// has.
constexpr std::size_t kSamples = 64, kFewestSuccesses = 1;
/// Least number of strips beside each other that are not looked at again.
constexpr std::size_t kFewestStrips = 3;
/// Least number of strips of a surface: corners that are rounded to a grid divide circles into pieces of four or five.
constexpr std::size_t kFewestKept = 6;
/// Largest part of the ends of strips across which these go on smoothly into others: the bands of a bent tube are strips
/// between parallel rulings, too.
constexpr double kMostOfEnds = 0.25;

class ExtrudedFinder {
 public:
  ExtrudedFinder(const FacetObject& object, const FacetPatches& surfaces, SweptPatches& swept)
      : object_(object),
        graph_(object.graph),
        surfaces_(surfaces),
        swept_(swept),
        tolerance_(swept_tolerance(object.object)),
        found_(surfaces.patches.size()),
        counts_(found_, 0),
        is_arc_(found_, 1),
        is_done_(object.graph.size(), 0),
        stamp_(object.graph.size(), 0) {}

  void run() {
    std::vector<std::uint32_t> seeds;
    for (std::uint32_t f = 0; f < graph_.size(); ++f) {
      if (surfaces_.patch_of[f] != kNone && surfaces_.patch_of[f] < found_) ++counts_[surfaces_.patch_of[f]];
      if (is_free(f) && !graph_.arcs_of(f).empty()) seeds.push_back(f);
    }
    const std::size_t step = seeds.size() / kSamples;
    if (step >= 2) {
      std::size_t successes = 0;
      for (std::size_t i = 0; i < seeds.size(); i += step) successes += is_done_[seeds[i]] || try_seed(seeds[i]);
      if (successes < kFewestSuccesses) return;
    }
    // Surfaces that are found leave fewer strips to others, never more.
    const auto has_strips = [&](std::size_t i) {
      return is_free(seeds[i]) && std::ranges::any_of(directions_at(seeds[i]), [&](const Point3& direction) {
               return has_few_strips(seeds[i], direction);
             });
    };
    for (const std::uint32_t i : indices_where(seeds.size(), has_strips, kSearchBlock)) try_seed(seeds[i]);
  }

 private:
  bool is_free(std::uint32_t f) const { return surfaces_.is_freeform[f] && surfaces_.patch_of[f] == kNone; }

  Point3 way(std::uint32_t e) const {
    const Edge& edge = object_.topology.edges[e];
    return object_.scene.vertices[edge.v1] - object_.scene.vertices[edge.v0];
  }

  /// Whether an edge is a ruling, and long enough to tell.
  bool is_ruling(std::uint32_t e, const Point3& direction) const {
    const Point3 along = way(e);
    const double length = glm::length(along), off = glm::length(glm::cross(along, direction));
    if (!(length >= kLeastLength * tolerance_)) return false;
    return off <= std::max(tolerance_, kLikeSine * length) && off <= kMostSine * length;
  }

  /// Whether a facet may be a part of an extruded surface of that direction: it has no surface, or lies on one by
  /// accident.
  bool may_join(std::uint32_t f, const Point3& direction) const {
    const std::uint32_t p = surfaces_.patch_of[f];
    if (p == kNone) return true;
    const PatchSurface& s = surfaces_.patches[p].surface;
    return p < found_ && (s.kind != SurfaceKind::cylinder || glm::length(glm::cross(s.axis, direction)) <= kMostSine);
  }

  /// The facets beside each other over rulings, from a seed on. Improves the direction.
  std::vector<std::uint32_t> walk(std::uint32_t seed, Point3& direction) {
    std::vector<std::uint32_t> facets{seed};
    stamp_[seed] = ++round_;
    Point3 sum(0, 0, 0);
    for (std::size_t i = 0; i < facets.size(); ++i) {
      for (const FacetGraph::Arc& arc : graph_.arcs_of(facets[i])) {
        if (!is_ruling(arc.edge, direction) || !may_join(arc.facet, direction)) continue;
        const Point3 along = way(arc.edge);
        sum += glm::dot(along, direction) < 0 ? -along : along;
        if (stamp_[arc.facet] == round_) continue;
        stamp_[arc.facet] = round_;
        facets.push_back(arc.facet);
      }
    }
    if (facets.size() > 1) direction = glm::normalize(sum);
    return facets;
  }

  /// Unit vectors along the longest edges of a facet over which it goes on.
  std::vector<Point3> directions_at(std::uint32_t seed) const {
    struct Ruling {
      double length;
      std::uint32_t edge;
    };
    std::vector<Ruling> rulings;
    for (const FacetGraph::Arc& arc : graph_.arcs_of(seed)) rulings.push_back({glm::length(way(arc.edge)), arc.edge});
    std::ranges::stable_sort(rulings, std::ranges::greater{}, &Ruling::length);
    std::vector<Point3> directions;
    for (std::size_t i = 0; i < std::min(rulings.size(), kMostTries); ++i) {
      if (!(rulings[i].length >= kLeastLength * tolerance_)) break;
      directions.push_back(way(rulings[i].edge) / rulings[i].length);
    }
    return directions;
  }

  /// Whether walk() reaches kFewestStrips facets.
  bool has_few_strips(std::uint32_t seed, const Point3& direction) const {
    std::array<std::uint32_t, kFewestStrips> facets{seed};
    std::size_t count = 1;
    for (std::size_t i = 0; i < count; ++i) {
      for (const FacetGraph::Arc& arc : graph_.arcs_of(facets[i])) {
        if (!is_ruling(arc.edge, direction) || !may_join(arc.facet, direction)) continue;
        if (std::find(facets.begin(), facets.begin() + static_cast<std::ptrdiff_t>(count), arc.facet) !=
            facets.begin() + static_cast<std::ptrdiff_t>(count))
          continue;
        facets[count++] = arc.facet;
        if (count == kFewestStrips) return true;
      }
    }
    return false;
  }

  /// Whether as many strips as a surface has were found from a facet on.
  bool try_seed(std::uint32_t seed) {
    if (is_done_[seed] || !is_free(seed)) return false;
    for (Point3 direction : directions_at(seed)) {
      if (walk(seed, direction).size() < kFewestStrips) continue;
      const std::vector<std::uint32_t> facets = walk(seed, direction);
      if (facets.size() < kFewestStrips) continue;
      for (const std::uint32_t f : facets) is_done_[f] = 1;
      if (facets.size() < kFewestKept) return false;
      make_patches(facets, direction);
      return true;
    }
    return false;
  }

  void make_patches(const std::vector<std::uint32_t>& facets, const Point3& direction) {
    PatchSurface frame{
        .kind = SurfaceKind::extruded, .at = object_.scene.vertices[graph_.vertices[facets[0]][0]], .axis = direction};
    const std::array<Point3, 2> xy = frame_of(direction);
    std::unordered_map<std::uint32_t, std::size_t> counts;
    for (const std::uint32_t f : facets) ++counts[surfaces_.patch_of[f]];
    const auto is_whole = [&](std::uint32_t p) { return p == kNone || counts.at(p) == counts_[p]; };
    std::vector<SweptFacet> swept;
    for (const std::uint32_t f : facets) {
      if (!is_whole(surfaces_.patch_of[f])) continue;
      if (const auto ends = ends_of(f, frame.at, xy)) swept.push_back({f, *ends});
    }
    const FacetProfile profile = profile_of(std::move(swept), surfaces_, 2 * tolerance_);
    std::vector<ProfilePiece> pieces = smooth_pieces(profile.points, profile.sides, {is_arc_, {}, 2 * tolerance_});
    std::erase_if(pieces, [&](const ProfilePiece& piece) {
      return piece.sides.size() < kFewestKept || goes_on(profile, piece, direction);
    });
    swept_.add(frame, xy, profile, pieces);
  }

  /// The ends of a facet in the plane across the rulings; nothing if it does not lie in their direction.
  std::optional<std::array<Point2, 2>> ends_of(std::uint32_t f, const Point3& at, const std::array<Point3, 2>& xy) const {
    const auto place = [&](std::uint32_t v) {
      const Point3 p = object_.scene.vertices[v] - at;
      return Point2(glm::dot(p, xy[0]), glm::dot(p, xy[1]));
    };
    const Point3& normal = graph_.frames[f].normal;
    const Point2 across = glm::normalize(Point2(-glm::dot(normal, xy[1]), glm::dot(normal, xy[0])));
    const auto along = [&](std::uint32_t v) { return glm::dot(place(v), across); };
    const auto [low, high] = std::ranges::minmax(graph_.vertices[f], {}, along);
    const std::array<Point2, 2> ends{place(low), place(high)};
    const Point2 side = ends[1] - ends[0];
    const double width = glm::length(side);
    if (!(width > 2 * tolerance_)) return std::nullopt;
    const double off = largest_offset(tolerance_, width);
    const auto is_beside = [&](std::uint32_t v) { return std::abs(cross(side, place(v) - ends[0])) > off * width; };
    if (std::ranges::any_of(graph_.vertices[f], is_beside)) return std::nullopt;
    return ends;
  }

  /// Whether the strips of a piece go on smoothly at their ends, into strips as deep.
  bool goes_on(const FacetProfile& profile, const ProfilePiece& piece, const Point3& direction) const {
    double length = 0, smooth = 0;
    for (const std::uint32_t side : piece.sides) {
      const double width = glm::distance(profile.points[profile.sides[side].from], profile.points[profile.sides[side].to]);
      for (const std::uint32_t f : profile.facets[side]) {
        length += 2 * width;
        for (const FacetGraph::Arc& arc : graph_.arcs_of(f)) {
          const bool is_curved = surfaces_.is_freeform[arc.facet] || surfaces_.patch_of[arc.facet] != kNone;
          if (!is_curved || is_ruling(arc.edge, direction)) continue;
          const Edge& edge = object_.topology.edges[arc.edge];
          const double depth = depth_behind(object_.scene, graph_.vertices[f], edge);
          if (depth <= kPlaneDepths * depth_behind(object_.scene, graph_.vertices[arc.facet], edge))
            smooth += glm::length(way(arc.edge));
        }
      }
    }
    return smooth > kMostOfEnds * length;
  }

  const FacetObject& object_;
  const FacetGraph& graph_;
  const FacetPatches& surfaces_;
  SweptPatches& swept_;
  double tolerance_;
  std::size_t found_;                  ///< number of patches that were found before
  std::vector<std::size_t> counts_;    ///< per such patch: its facets
  std::vector<std::uint8_t> is_arc_;   ///< per such patch
  std::vector<std::uint8_t> is_done_;  ///< per facet: in strips that were looked at
  std::vector<std::uint32_t> stamp_;   ///< per facet: the value of round_ when a walk visited it last
  std::uint32_t round_ = 0;
};

}  // namespace

void find_extruded(const FacetObject& object, const FacetPatches& surfaces, SweptPatches& swept) {
  ExtrudedFinder(object, surfaces, swept).run();
}

}  // namespace ligne
