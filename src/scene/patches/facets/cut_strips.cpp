#include "scene/patches/facets/cut_strips.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <optional>
#include <vector>

#include "scene/model/planarity.hpp"

namespace ligne {
namespace {

/// Largest number of corners of a strip that was cut at its ends.
constexpr std::size_t kMostCutCorners = 256;
/// Largest ratio of its width to that of a neighbour.
constexpr double kAlikeWidths = 2;
/// Largest ratio between the sines of the bends at its rulings, where it also goes on at its ends, as into a chamfer.
constexpr double kAlikeBends = 1.4;
/// Largest ratio between the bends at the rulings, and between the widths, of strips that divide a cylinder evenly.
constexpr double kEven = 1.02;
/// Least length of a piece of a ruling that tells what lies beyond it, by that of the longest: slivers lie at the ends.
constexpr double kShortPiece = 1.0 / 16;
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
      if (!is_even_ && !graph_.is_plane[f] && !has_chords(f)) continue;
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

  /// Largest distance of the end of an arc from a line through its beginning, if they are parallel.
  double tolerance_of(const FacetGraph::Arc& arc) const {
    return std::max(4 * straightness_tolerance(object_.precision, length(arc)), kParallel * length(arc));
  }

  double length(const FacetGraph::Arc& arc) const { return glm::distance(end(arc, false), end(arc, true)); }

  /// Sets corners_ to the ends of the rulings of a facet, each once, and is_even_. Returns false if it is no strip. A plane
  /// has arcs at its rulings alone, unless the strip and those beside it divide a cylinder evenly: no other plane has
  /// neighbours of its own width on both sides, at one angle.
  bool take_rulings(std::uint32_t facet) {
    const auto arcs = graph_.arcs_of(facet);
    if (arcs.size() < 2) return false;
    longest_first_.assign(arcs.begin(), arcs.end());
    std::ranges::stable_sort(longest_first_, std::ranges::greater{},
                             [&](const FacetGraph::Arc& arc) { return length(arc); });
    const std::optional<Row> longest = measure_row(facet, rulings_along(longest_first_.front()));
    is_even_ = longest && longest->is_even();
    if (is_even_) return true;
    if (arcs.size() > kMostRulingCorners) return false;
    if (graph_.is_plane[facet]) return longest && !longest->has_ends && longest->is_row();
    return std::ranges::any_of(longest_first_, [&](const FacetGraph::Arc& arc) {
      const std::optional<Row> row = measure_row(facet, rulings_along(arc));
      return row && row->is_row();
    });
  }

  /// The rulings of the direction of one of the arcs: the line of the longest parallel one beside it is the second.
  Rulings rulings_along(const FacetGraph::Arc& first) const {
    Rulings found{end(first, false), (end(first, true) - end(first, false)) / length(first)};
    found.tolerance = tolerance_of(first);
    for (const FacetGraph::Arc& arc : longest_first_) {
      if (is_ruling(arc, found)) continue;
      if (found.across == Point3(0.0) && is_parallel(arc, found)) {
        found.across = found.off(end(arc, false));
      } else {
        found.has_ends = true;
      }
    }
    return found;
  }

  bool is_parallel(const FacetGraph::Arc& arc, const Rulings& rulings) const {
    return glm::length(rulings.off(end(arc, false)) - rulings.off(end(arc, true))) <= tolerance_of(arc);
  }

  /// Whether an arc lies on one of the lines of the rulings.
  bool is_ruling(const FacetGraph::Arc& arc, const Rulings& rulings) const {
    const Point3 from = rulings.off(end(arc, false));
    return is_parallel(arc, rulings) &&
           (glm::length(from) <= rulings.tolerance || glm::length(from - rulings.across) <= rulings.tolerance);
  }

  /// A facet and those beyond its rulings.
  struct Row {
    double width = 0;            ///< of the facet, model units
    double least_depth = 1e300;  ///< of the others, from the rulings
    double most_depth = 0;
    double least_bend = 1, most_bend = 0;  ///< sines of the bends at the rulings
    bool has_ends = false;

    bool is_even() const {
      return most_bend <= kEven * least_bend && most_depth <= kEven * width && width <= kEven * least_depth;
    }
    /// Planes beside fillets are wider than these.
    bool is_row() const {
      return kAlikeWidths * least_depth >= width && (!has_ends || most_bend <= kAlikeBends * least_bend);
    }
  };

  /// Measures the row of a facet; sets corners_. Returns nothing if the facet reaches beyond its rulings.
  std::optional<Row> measure_row(std::uint32_t facet, const Rulings& rulings) {
    if (rulings.across == Point3(0.0)) return std::nullopt;
    Row row;
    row.width = glm::length(rulings.across);
    row.has_ends = rulings.has_ends;
    corners_.clear();
    for (const FacetGraph::Arc& arc : graph_.arcs_of(facet)) {
      const Point3 line = rulings.off(end(arc, false));
      if (!is_ruling(arc, rulings)) {
        const auto is_between = [&](const Point3& p) {
          const double place = glm::dot(rulings.off(p), rulings.across) / row.width;
          return place > -rulings.tolerance && place < row.width + rulings.tolerance;
        };
        if (!is_between(end(arc, false)) || !is_between(end(arc, true))) return std::nullopt;
        continue;
      }
      corners_.insert(corners_.end(), {topology_.edges[arc.edge].v0, topology_.edges[arc.edge].v1});
      if (length(arc) < kShortPiece * length(longest_first_.front())) continue;
      double depth = 0;
      for (const std::uint32_t v : graph_.vertices[arc.facet])
        depth = std::max(depth, glm::length(rulings.off(scene_.vertices[v]) - line));
      row.least_depth = std::min(row.least_depth, depth);
      row.most_depth = std::max(row.most_depth, depth);
      const double bend = glm::length(glm::cross(graph_.frames[facet].normal, graph_.frames[arc.facet].normal));
      row.least_bend = std::min(row.least_bend, bend);
      row.most_bend = std::max(row.most_bend, bend);
    }
    std::sort(corners_.begin(), corners_.end());
    corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
    return row;
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
  bool is_even_ = false;                        ///< also
};

}  // namespace

void find_cut_strips(const Scene& scene, const Topology& topology, const Object& object, FacetGraph& graph) {
  CutStripFinder(scene, topology, object, graph).run();
}

}  // namespace ligne
