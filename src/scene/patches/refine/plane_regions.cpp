#include "scene/patches/refine/plane_regions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/no_index.hpp"
#include "scene/contacts/chord_errors.hpp"
#include "scene/creases/face_normals.hpp"
#include "scene/model/faces_and_edges.hpp"
#include "scene/model/planarity.hpp"
#include "scene/patches/refine/chord_corners.hpp"

namespace ligne {
namespace {

/// Least cosine between normals that are one but for the rounding to float.
constexpr double kSameNormalCosine = 1 - 1e-6;
/// Least cosine between the normals of two faces of one plane: 0.008 degrees, as roundings to float32 turn small faces.
constexpr double kInPlaneCosine = 1 - 1e-8;

/// Least cosine of the angle by which rounding may have turned a sliver (60 degrees).
constexpr double kTurnedCosine = 0.5;
/// Adjustable: length of chains of such slivers.
constexpr int kLongestChainOfSlivers = 4;

/// A directed side of a face: its first and its second vertex.
using Side = std::array<std::uint32_t, 2>;

class RegionFinder {
 public:
  RegionFinder(const Scene& scene, const Topology& topology, const Patches& patches, const std::vector<std::uint8_t>& lines,
               std::span<const std::uint32_t> borders)
      : scene_(scene), topology_(topology), patches_(patches), lines_(lines), borders_(borders), sets_(scene.faces.size()) {}

  PlaneRegions find() {
    find_normals();
    join_faces();
    mark_borders();
    list_regions();
    for (std::size_t r = 0; r < found_.list.size(); ++r) make_loops(sides_[r], found_.list[r]);
    leave_out_facets();
    for (std::uint32_t& region : found_.region_of) {
      if (region != kNone && found_.list[region].loops.empty()) region = kNone;
    }
    return std::move(found_);
  }

 private:
  bool is_plane(std::uint32_t face) const { return normals_[face] != Point3(0.0); }

  void find_normals() {
    normals_.assign(scene_.faces.size(), Point3(0.0));
    for (std::uint32_t f = 0; f < normals_.size(); ++f) {
      const bool is_curved = patches_.patch_of[f] != kNone || (!patches_.is_freeform.empty() && patches_.is_freeform[f]);
      if (!is_curved) normals_[f] = face_normal(scene_, f);
    }
    take_slivers();
  }

  /// Counts slivers in a plane as parts of it. Rounding determines their own normals, so that they count as free forms; the
  /// plane would have a border that it shares with nothing.
  void take_slivers() {
    const std::vector<glm::vec3> normals = face_normals(scene_, topology_);
    const auto is_sliver = [&](std::uint32_t f) {
      if (is_plane(f) || patches_.patch_of[f] != kNone || scene_.faces.contour(f, 0).size() != 3) return false;
      return glm::dot(Point3(normals[f]), face_normal(scene_, f)) < kSameNormalCosine;
    };
    std::vector<std::pair<std::uint32_t, std::uint32_t>> taken;
    for (const Edge& edge : topology_.edges) {
      if (edge.face1 == kNone) continue;
      for (const auto& [face, plane] : {std::pair(edge.face0, edge.face1), std::pair(edge.face1, edge.face0)}) {
        if (!is_plane(plane) || !is_sliver(face)) continue;
        if (glm::dot(Point3(normals[face]), normals_[plane]) >= kSameNormalCosine) taken.emplace_back(face, plane);
      }
    }
    for (const auto& [face, plane] : taken) normals_[face] = normals_[plane];
  }

  /// Whether planes may be one across an edge.
  bool may_join(std::size_t e) const {
    const std::vector<std::uint32_t>& material = scene_.face_material;
    const Edge& edge = topology_.edges[e];
    return edge.face1 != kNone && lines_[e] == 0 && !(topology_.edge_flags[e] & (kEdgeManyFaces | kEdgeUnlikeWound)) &&
           is_plane(edge.face0) && is_plane(edge.face1) &&
           (material.empty() || material[edge.face0] == material[edge.face1]);
  }

  void join_faces() {
    for (std::size_t e = 0; e < topology_.edges.size(); ++e) {
      const Edge& edge = topology_.edges[e];
      if (may_join(e) && glm::dot(normals_[edge.face0], normals_[edge.face1]) >= kInPlaneCosine)
        sets_.join(edge.face0, edge.face1);
    }
    for (int pass = 0; pass < kLongestChainOfSlivers && join_turned_slivers(); ++pass) {
    }
  }

  /// Joins slivers that rounding has turned: sets of faces that lie, within the precision, in the planes of neighbours that
  /// are larger or do not lie in theirs. Takes the largest of these. Returns whether there are any.
  bool join_turned_slivers() {
    std::vector<double> areas(normals_.size(), 0);
    for (std::uint32_t f = 0; f < normals_.size(); ++f) areas[sets_.find(f)] += glm::length(double_area(scene_, f));
    std::vector<std::uint32_t> planes(normals_.size(), kNone);  // by the representative face of a set: a neighbour
    for (std::size_t e = 0; e < topology_.edges.size(); ++e) {
      if (!may_join(e)) continue;
      const Edge& edge = topology_.edges[e];
      for (const auto& [face, other] : {std::pair(edge.face0, edge.face1), std::pair(edge.face1, edge.face0)}) {
        const std::uint32_t set = sets_.find(face);
        const double area = areas[sets_.find(other)];
        if (sets_.find(other) == set || (planes[set] != kNone && area <= areas[sets_.find(planes[set])])) continue;
        if (lies_in(face, other) && (area > areas[set] || !lies_in(other, face))) planes[set] = other;
      }
    }
    std::vector<std::uint8_t> is_apart(normals_.size(), 0);
    for (std::uint32_t f = 0; f < normals_.size(); ++f) {
      const std::uint32_t set = sets_.find(f);
      if (planes[set] != kNone && !is_apart[set]) is_apart[set] = !lies_in(f, planes[set]);
    }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> turned;
    for (std::uint32_t f = 0; f < normals_.size(); ++f) {
      const std::uint32_t plane = planes[sets_.find(f)];
      if (plane != kNone && !is_apart[sets_.find(f)]) turned.emplace_back(f, plane);
    }
    for (const auto& [face, plane] : turned) {
      normals_[face] = normals_[plane];
      sets_.join(face, plane);
    }
    return !turned.empty();
  }

  /// Whether the corners of a face lie in the plane of another one, within the precision.
  bool lies_in(std::uint32_t face, std::uint32_t plane) const {
    const Point3 at = scene_.vertices[scene_.faces.contour(plane, 0)[0]];
    const double precision = object_precision(scene_, face);
    return glm::dot(normals_[face], normals_[plane]) >= kTurnedCosine &&
           std::ranges::all_of(scene_.faces.contour(face, 0), [&](std::uint32_t v) {
             const Point3 way = scene_.vertices[v] - at;
             return std::abs(glm::dot(way, normals_[plane])) <= planarity_tolerance(precision, glm::length(way));
           });
  }

  void mark_borders() {
    borders_surface_.assign(normals_.size(), 0);
    for (const std::uint32_t e : borders_) {
      const Edge& edge = topology_.edges[e];
      if (edge.face1 == kNone) continue;
      for (const auto& [face, other] : {std::pair(edge.face0, edge.face1), std::pair(edge.face1, edge.face0)}) {
        if (is_plane(face) && patches_.patch_of[other] != kNone) borders_surface_[sets_.find(face)] = 1;
      }
    }
  }

  void list_regions() {
    found_.region_of.assign(normals_.size(), kNone);
    std::vector<std::uint32_t> number(normals_.size(), kNone);
    for (std::uint32_t f = 0; f < normals_.size(); ++f) {
      if (!is_plane(f) || !borders_surface_[sets_.find(f)]) continue;
      std::uint32_t& region = number[sets_.find(f)];
      if (region == kNone) {
        region = static_cast<std::uint32_t>(found_.list.size());
        found_.list.push_back({scene_.vertices[scene_.faces.contour(f, 0)[0]], normals_[f], {}});
        sides_.emplace_back();
      }
      found_.region_of[f] = region;
      for_sides(scene_.faces, f, [&](std::uint32_t v, std::uint32_t w) { sides_[region].push_back({v, w}); });
    }
  }

  /// Sets the loops of a region from the sides of its faces, unless its border touches itself or has several outer parts.
  void make_loops(std::vector<Side>& sides, PlaneRegion& region) const {
    std::sort(sides.begin(), sides.end());
    const std::vector<Side> all = sides;
    std::erase_if(sides, [&](const Side& s) { return std::binary_search(all.begin(), all.end(), Side{s[1], s[0]}); });
    for (std::size_t i = 1; i < sides.size(); ++i) {
      if (sides[i][0] == sides[i - 1][0]) return;
    }
    std::vector<std::vector<std::uint32_t>> loops;
    std::vector<std::uint8_t> is_done(sides.size(), 0);
    std::size_t outer = kNone, outers = 0;
    for (std::size_t i = 0; i < sides.size(); ++i) {
      if (is_done[i]) continue;
      std::vector<std::uint32_t>& loop = loops.emplace_back();
      for (std::size_t at = i; !is_done[at];) {
        is_done[at] = 1;
        loop.push_back(sides[at][0]);
        const auto next = std::lower_bound(sides.begin(), sides.end(), Side{sides[at][1], 0});
        if (next == sides.end() || (*next)[0] != sides[at][1]) return;
        at = static_cast<std::size_t>(next - sides.begin());
      }
      if (area_of(loop, region) > 0) outer = loops.size() - 1, ++outers;
    }
    if (outers != 1) return;
    std::swap(loops[0], loops[outer]);
    region.loops = std::move(loops);
  }

  /// Leaves out the regions that border on a surface along a single edge: they may be facets of another surface that was not
  /// recognised, as at the corner of a coarse fillet. Planes border along chains, or cut a facet across, as the wall of a
  /// slot does.
  void leave_out_facets() {
    KeyTable surface_at;
    for (const std::uint32_t e : borders_) {
      const Edge& edge = topology_.edges[e];
      for (const std::uint32_t face : {edge.face0, edge.face1}) {
        if (face != kNone && patches_.patch_of[face] != kNone)
          surface_at[edge_key(edge.v0, edge.v1)] = patches_.patch_of[face];
      }
    }
    for (PlaneRegion& region : found_.list) {
      const bool is_facet = std::ranges::any_of(region.loops, [&](const std::vector<std::uint32_t>& loop) {
        const std::size_t n = loop.size();
        const auto surface = [&](std::size_t k) { return surface_at.find(edge_key(loop[k % n], loop[(k + 1) % n])); };
        for (std::size_t k = 0; k < n; ++k) {
          const std::uint32_t here = surface(k);
          if (here == kNone || surface(k + n - 1) == here || surface(k + 1) == here) continue;
          if (!is_on_chord(loop[k], patches_.list[here]) && !is_on_chord(loop[(k + 1) % n], patches_.list[here]))
            return true;
        }
        return false;
      });
      if (is_facet) region.loops.clear();
    }
  }

  bool is_on_chord(std::uint32_t vertex, const Patch& patch) const {
    return std::abs(patch.surface.distance(scene_.vertices[vertex])) > kOffSags * patch.sag;
  }

  double area_of(const std::vector<std::uint32_t>& loop, const PlaneRegion& region) const {
    Point3 sum(0.0);
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Point3 &p = scene_.vertices[loop[k]], &q = scene_.vertices[loop[(k + 1) % loop.size()]];
      sum += glm::cross(p - region.at, q - region.at);
    }
    return 0.5 * glm::dot(sum, region.normal);
  }

  const Scene& scene_;
  const Topology& topology_;
  const Patches& patches_;
  const std::vector<std::uint8_t>& lines_;
  std::span<const std::uint32_t> borders_;
  DisjointSets sets_;                          ///< of faces in one plane
  std::vector<Point3> normals_;                ///< per face; zero if it is no plane
  std::vector<std::uint8_t> borders_surface_;  ///< by the representative face of a set
  std::vector<std::vector<Side>> sides_;       ///< per region
  PlaneRegions found_;
};

}  // namespace

PlaneRegions plane_regions(const Scene& scene, const Topology& topology, const Patches& patches,
                           const std::vector<std::uint8_t>& lines, std::span<const std::uint32_t> borders) {
  return RegionFinder(scene, topology, patches, lines, borders).find();
}

}  // namespace ligne
