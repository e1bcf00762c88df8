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
/// Largest ratio between the sines of the bends at its rulings, where it also goes on at its ends, as into a chamfer.
constexpr double kAlikeBends = 1.4;
/// Largest distance of its rulings from parallel lines, in their length: files print coordinates with six digits.
constexpr double kParallel = 1e-4;

class CutStripFinder {
 public:
  CutStripFinder(const Scene& scene, const Topology& topology, const Object& object, FacetGraph& graph)
      : scene_(scene), topology_(topology), object_(object), graph_(graph) {}

  void run() {
    graph_.is_cut.assign(graph_.size(), 0);
    std::vector<std::uint32_t> strips;
    IndexLists rulings;  // the corners on the rulings of each of them
    for (std::uint32_t f = 0; f < graph_.size(); ++f) {
      const std::size_t count = graph_.vertices[f].size();
      if (count <= kStripCorners || count > kMostCutCorners || !take_rulings(f)) continue;
      if (!graph_.is_plane[f] && !has_chords(f)) continue;
      // Where no surface is found, other facets of so few corners may still be free forms.
      graph_.is_cut[f] = graph_.is_plane[f];
      graph_.is_plane[f] = 0;
      strips.push_back(f);
      rulings.values.insert(rulings.values.end(), corners_.begin(), corners_.end());
      rulings.begin.push_back(static_cast<std::uint32_t>(rulings.values.size()));
    }
    if (strips.empty()) return;
    IndexLists vertices;
    for (std::uint32_t f = 0, next = 0; f < graph_.size(); ++f) {
      const auto of_facet = next < strips.size() && strips[next] == f ? rulings[next++] : graph_.vertices[f];
      vertices.values.insert(vertices.values.end(), of_facet.begin(), of_facet.end());
      vertices.begin.push_back(static_cast<std::uint32_t>(vertices.values.size()));
    }
    graph_.vertices = std::move(vertices);
  }

 private:
  /// The rulings at which a facet has arcs: those on the line of one of them, and those on a second line.
  struct Rulings {
    Point3 at, along;        ///< the first line
    Point3 across{0, 0, 0};  ///< of the second line, as cross(along, point - at); 0: there is none
    double tolerance = 0;
    bool has_ends = false;  ///< other arcs lie between the lines
    Point3 off(const Point3& p) const { return glm::cross(along, p - at); }
  };

  const Point3& end(const FacetGraph::Arc& arc, bool second) const {
    const Edge& edge = topology_.edges[arc.edge];
    return scene_.vertices[second ? edge.v1 : edge.v0];
  }

  double length(const FacetGraph::Arc& arc) const { return glm::distance(end(arc, false), end(arc, true)); }

  /// Sets corners_ to the ends of the rulings of a facet, each once. Returns false if it is no strip. A plane has arcs at
  /// its rulings alone.
  bool take_rulings(std::uint32_t facet) {
    const auto arcs = graph_.arcs_of(facet);
    if (arcs.size() < 2 || arcs.size() > kMostRulingCorners) return false;
    longest_first_.assign(arcs.begin(), arcs.end());
    std::ranges::stable_sort(longest_first_, std::ranges::greater{},
                             [&](const FacetGraph::Arc& arc) { return length(arc); });
    if (graph_.is_plane[facet]) longest_first_.resize(1);
    return std::ranges::any_of(longest_first_, [&](const FacetGraph::Arc& arc) {
      const Rulings rulings = rulings_along(arcs, arc);
      if (rulings.across == Point3(0.0) || (rulings.has_ends && graph_.is_plane[facet])) return false;
      return is_in_row(facet, rulings);
    });
  }

  /// The rulings of the direction of one of the arcs.
  Rulings rulings_along(std::span<const FacetGraph::Arc> arcs, const FacetGraph::Arc& first) const {
    Rulings found{end(first, false), (end(first, true) - end(first, false)) / length(first)};
    found.tolerance = std::max(4 * straightness_tolerance(object_.precision, length(first)), kParallel * length(first));
    for (const FacetGraph::Arc& arc : arcs) {
      const Point3 from = found.off(end(arc, false)), to = found.off(end(arc, true));
      if (glm::length(from - to) > found.tolerance) {
        found.has_ends = true;
      } else if (glm::length(from) > found.tolerance) {
        if (found.across != Point3(0.0) && glm::length(from - found.across) > found.tolerance) return {};
        if (found.across == Point3(0.0)) found.across = from;
      }
    }
    return found;
  }

  /// Whether a facet is in one row with those beyond its rulings; sets corners_.
  bool is_in_row(std::uint32_t facet, const Rulings& rulings) {
    const double width = glm::length(rulings.across);
    double least = 1, most = 0;  // sines of the bends
    corners_.clear();
    for (const FacetGraph::Arc& arc : graph_.arcs_of(facet)) {
      const Point3 line = rulings.off(end(arc, false));
      if (glm::length(line - rulings.off(end(arc, true))) > rulings.tolerance) {
        const auto is_between = [&](const Point3& p) {
          const double place = glm::dot(rulings.off(p), rulings.across) / width;
          return place > -rulings.tolerance && place < width + rulings.tolerance;
        };
        if (!is_between(end(arc, false)) || !is_between(end(arc, true))) return false;
        continue;
      }
      // Planes beside fillets are wider than these.
      double depth = 0;
      for (const std::uint32_t v : graph_.vertices[arc.facet])
        depth = std::max(depth, glm::length(rulings.off(scene_.vertices[v]) - line));
      if (kAlikeWidths * depth < width) return false;
      const double bend = glm::length(glm::cross(graph_.frames[facet].normal, graph_.frames[arc.facet].normal));
      least = std::min(least, bend);
      most = std::max(most, bend);
      corners_.insert(corners_.end(), {topology_.edges[arc.edge].v0, topology_.edges[arc.edge].v1});
    }
    if (rulings.has_ends && most > kAlikeBends * least) return false;
    std::sort(corners_.begin(), corners_.end());
    corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
    return true;
  }

  /// Whether the other vertices of a facet lie on chords between its rulings, whose ends are corners_.
  bool has_chords(std::uint32_t facet) const {
    const auto is_on_chord = [&](std::uint32_t v) {
      const Point3& p = scene_.vertices[v];
      for (std::size_t i = 0; i < corners_.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
          const Point3 &from = scene_.vertices[corners_[i]], way = scene_.vertices[corners_[k]] - from;
          const double size = glm::length(way), place = glm::dot(p - from, way) / size;
          const double tolerance = 4 * straightness_tolerance(object_.precision, size);
          if (place > 0 && place < size && glm::length(glm::cross(p - from, way)) <= tolerance * size) return true;
        }
      }
      return false;
    };
    return std::ranges::all_of(graph_.vertices[facet],
                               [&](std::uint32_t v) { return std::ranges::binary_search(corners_, v) || is_on_chord(v); });
  }

  const Scene& scene_;
  const Topology& topology_;
  const Object& object_;
  FacetGraph& graph_;
  std::vector<FacetGraph::Arc> longest_first_;  ///< of take_rulings()
  std::vector<std::uint32_t> corners_;          ///< result of take_rulings()
};

}  // namespace

void find_cut_strips(const Scene& scene, const Topology& topology, const Object& object, FacetGraph& graph) {
  CutStripFinder(scene, topology, object, graph).run();
}

}  // namespace ligne
