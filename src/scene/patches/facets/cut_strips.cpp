#include "scene/patches/facets/cut_strips.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <vector>

#include "scene/model/planarity.hpp"

namespace ligne {
namespace {

/// Largest number of corners of a strip that was cut at its ends.
constexpr std::size_t kMostCutCorners = 64;
/// Largest ratio of its width to that of a neighbour.
constexpr double kAlikeWidths = 2;
/// Largest distance of its rulings from parallel lines, in their length: files print coordinates with six digits.
constexpr double kParallel = 1e-4;

class CutStripFinder {
 public:
  CutStripFinder(const Scene& scene, const Topology& topology, const Object& object, FacetGraph& graph)
      : scene_(scene), topology_(topology), object_(object), graph_(graph) {}

  void run() {
    graph_.is_cut.assign(graph_.size(), 0);
    IndexLists cut;  // the corners on the rulings of each
    for (std::uint32_t f = 0; f < graph_.size(); ++f) {
      if (!graph_.is_plane[f] || graph_.vertices[f].size() > kMostCutCorners || !take_rulings(f)) continue;
      graph_.is_plane[f] = 0;
      graph_.is_cut[f] = 1;
      cut.values.insert(cut.values.end(), corners_.begin(), corners_.end());
      cut.begin.push_back(static_cast<std::uint32_t>(cut.values.size()));
    }
    if (cut.values.empty()) return;
    IndexLists vertices;
    for (std::uint32_t f = 0, next = 0; f < graph_.size(); ++f) {
      const auto of_facet = graph_.is_cut[f] ? cut[next++] : graph_.vertices[f];
      vertices.values.insert(vertices.values.end(), of_facet.begin(), of_facet.end());
      vertices.begin.push_back(static_cast<std::uint32_t>(vertices.values.size()));
    }
    graph_.vertices = std::move(vertices);
  }

 private:
  /// Sets corners_ to the ends of the edges at which a plane has arcs, each once. Returns false if these do not lie on two
  /// parallel lines, at most kMostRulingCorners in all.
  bool take_rulings(std::uint32_t facet) {
    const auto arcs = graph_.arcs_of(facet);
    corners_.clear();
    if (arcs.size() < 2 || arcs.size() > kMostRulingCorners) return false;
    const auto end = [&](const FacetGraph::Arc& arc, bool second) -> const Point3& {
      const Edge& edge = topology_.edges[arc.edge];
      return scene_.vertices[second ? edge.v1 : edge.v0];
    };
    const auto length = [&](const FacetGraph::Arc& arc) { return glm::distance(end(arc, false), end(arc, true)); };
    const auto& longest = *std::ranges::max_element(arcs, {}, length);
    const Point3 at = end(longest, false), along = (end(longest, true) - at) / length(longest);
    const auto off = [&](const Point3& p) { return glm::cross(along, p - at); };
    const double tolerance =
        std::max(4 * straightness_tolerance(object_.precision, length(longest)), kParallel * length(longest));
    Point3 other(0.0);  // the second line, as its distance from the first one
    for (const FacetGraph::Arc& arc : arcs) {
      const Point3 from = off(end(arc, false)), to = off(end(arc, true));
      if (glm::length(from - to) > tolerance) return false;
      if (glm::length(from) <= tolerance) continue;
      if (other != Point3(0.0) && glm::length(from - other) > tolerance) return false;
      if (other == Point3(0.0)) other = from;
    }
    if (other == Point3(0.0)) return false;
    for (const FacetGraph::Arc& arc : arcs) {
      // Planes beside fillets are wider than these.
      const Point3 line = off(end(arc, false));
      double depth = 0;
      for (const std::uint32_t v : graph_.vertices[arc.facet]) {
        depth = std::max(depth, glm::length(off(scene_.vertices[v]) - line));
      }
      if (kAlikeWidths * depth < glm::length(other)) return false;
      corners_.insert(corners_.end(), {topology_.edges[arc.edge].v0, topology_.edges[arc.edge].v1});
    }
    std::sort(corners_.begin(), corners_.end());
    corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
    return true;
  }

  const Scene& scene_;
  const Topology& topology_;
  const Object& object_;
  FacetGraph& graph_;
  std::vector<std::uint32_t> corners_;  ///< result of take_rulings()
};

}  // namespace

void find_cut_strips(const Scene& scene, const Topology& topology, const Object& object, FacetGraph& graph) {
  CutStripFinder(scene, topology, object, graph).run();
}

}  // namespace ligne
