#include "scene/patches/facets/cut_strips.hpp"

#include <algorithm>
#include <array>
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
/// Such a ratio for a cone, whose strips differ by the rounding of coordinates alone: other slanting facets are often
/// similar.
constexpr double kEvenCone = 1.003;
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
  /// The line of an arc, whose middle is `at`.
  struct Line {
    Point3 at{0, 0, 0}, along{0, 0, 0};
    Point3 off(const Point3& p) const { return glm::cross(along, p - at); }
  };

  /// The two lines, parallel or not, that are taken for the rulings at which a facet has arcs.
  struct Rulings {
    std::array<Line, 2> lines;
    std::optional<Point3> tip{};  ///< their common point, where widths are those of a cone's strips
    double tolerance = 0;         ///< of points on them, model units
    bool are_found = false, are_parallel = false;
    bool has_ends = false;  ///< other arcs lie between the lines
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
  /// has arcs at parallel rulings alone, unless the strip and those beside it divide a cylinder or a cone evenly: no other
  /// plane has neighbours of its own width on both sides, at one angle.
  bool take_rulings(std::uint32_t facet) {
    const auto arcs = graph_.arcs_of(facet);
    if (arcs.size() < 2) return false;
    longest_first_.assign(arcs.begin(), arcs.end());
    std::ranges::stable_sort(longest_first_, std::ranges::greater{},
                             [&](const FacetGraph::Arc& arc) { return length(arc); });
    Rulings rulings = rulings_along(longest_first_.front());
    const std::optional<Row> longest = measure_row(facet, rulings);
    is_even_ = longest && longest->is_even();
    if (longest && !is_even_ && !rulings.are_parallel) {
      rulings.tip = common_point(rulings.lines);
      is_even_ = measure_row(facet, rulings)->is_even(kEvenCone);
    }
    if (is_even_) return true;
    if (arcs.size() > kMostRulingCorners) return false;
    if (graph_.is_plane[facet])
      return longest && rulings.are_parallel && (!rulings.has_ends || has_short_ends(rulings)) && longest->is_row(false);
    return std::ranges::any_of(longest_first_, [&](const FacetGraph::Arc& arc) {
      const Rulings along = rulings_along(arc);
      if (!along.are_parallel) return false;
      const std::optional<Row> row = measure_row(facet, along);
      return row && row->is_row(along.has_ends);
    });
  }

  /// The rulings of which one has the line of an arc. The other one is that of the longest parallel arc beside it, or of the
  /// longest arc.
  Rulings rulings_along(const FacetGraph::Arc& first) const {
    Rulings found;
    found.lines[0] = line_of(first);
    found.tolerance = tolerance_of(first);
    for (const FacetGraph::Arc& arc : longest_first_) {
      const Line line = line_of(arc);
      if (is_on(arc, found.lines[0], found.tolerance)) continue;
      const bool is_parallel =
          glm::length(found.lines[0].off(end(arc, false)) - found.lines[0].off(end(arc, true))) <= tolerance_of(arc);
      if (!found.are_found || (is_parallel && !found.are_parallel)) {
        found.lines[1] = is_parallel ? Line{line.at, found.lines[0].along} : line;
        found.are_found = true;
        found.are_parallel = is_parallel;
      }
    }
    found.has_ends = std::ranges::any_of(longest_first_, [&](const FacetGraph::Arc& arc) {
      return std::ranges::none_of(found.lines, [&](const Line& line) { return is_on(arc, line, found.tolerance); });
    });
    return found;
  }

  static Point3 common_point(const std::array<Line, 2>& lines) {
    const Point3 across = glm::cross(lines[0].along, lines[1].along);
    return lines[0].at + lines[0].along * (glm::dot(lines[1].off(lines[0].at), across) / glm::dot(across, across));
  }

  /// Whether the arcs of a facet that lie between its rulings are short, as where slivers lie at its ends.
  bool has_short_ends(const Rulings& rulings) const {
    const double most = kShortPiece * length(longest_first_.front());
    return std::ranges::all_of(longest_first_, [&](const FacetGraph::Arc& arc) {
      const auto is_on_it = [&](const Line& line) { return is_on(arc, line, rulings.tolerance); };
      return length(arc) <= most || std::ranges::any_of(rulings.lines, is_on_it);
    });
  }

  Line line_of(const FacetGraph::Arc& arc) const {
    return {(end(arc, false) + end(arc, true)) * 0.5, (end(arc, true) - end(arc, false)) / length(arc)};
  }

  bool is_on(const FacetGraph::Arc& arc, const Line& line, double tolerance) const {
    const Point3 from = line.off(end(arc, false));
    return glm::length(from) <= tolerance && glm::length(from - line.off(end(arc, true))) <= tolerance_of(arc);
  }

  /// A facet and those beyond its rulings.
  struct Row {
    double least_width = 1e300, most_width = 0;  ///< of the others, by that of the facet
    double least_bend = 1, most_bend = 0;        ///< sines of the bends at the rulings

    bool is_even(double even = kEven) const {
      return most_bend <= even * least_bend && most_width <= even && even * least_width >= 1;
    }
    /// Planes beside fillets are wider than these.
    bool is_row(bool has_ends) const {
      return kAlikeWidths * least_width >= 1 && (!has_ends || most_bend <= kAlikeBends * least_bend);
    }
  };

  /// Largest distance of the vertices of a facet from a ruling. With a tip the distances are by those from the tip, so that
  /// strips of a cone have one width wherever they are cut.
  double width_from(std::uint32_t facet, const Line& line, const Rulings& rulings) const {
    double width = 0;
    for (const std::uint32_t v : graph_.vertices[facet]) {
      const Point3& p = scene_.vertices[v];
      const double size = rulings.tip ? glm::distance(p, *rulings.tip) : 1;
      if (size > 2 * rulings.tolerance) width = std::max(width, glm::length(line.off(p)) / size);
    }
    return width;
  }

  /// Measures the row of a facet; sets corners_. Returns nothing if the facet reaches beyond its rulings.
  std::optional<Row> measure_row(std::uint32_t facet, const Rulings& rulings) {
    if (!rulings.are_found) return std::nullopt;
    for (std::size_t k = 0; k < 2; ++k) {
      const Line &line = rulings.lines[k], &other = rulings.lines[1 - k];
      // Towards the other line, in the plane of the facet.
      const Point3 inward = line.off(other.at);
      const double size = glm::length(inward);
      const auto is_inside = [&](const FacetGraph::Arc& arc) {
        return std::min(glm::dot(line.off(end(arc, false)), inward), glm::dot(line.off(end(arc, true)), inward)) >=
               -rulings.tolerance * size;
      };
      if (!std::ranges::all_of(longest_first_, is_inside)) return std::nullopt;
    }
    Row row;
    corners_.clear();
    for (const Line& line : rulings.lines) {
      const double width = width_from(facet, line, rulings);
      for (const FacetGraph::Arc& arc : longest_first_) {
        if (!is_on(arc, line, rulings.tolerance)) continue;
        corners_.insert(corners_.end(), {topology_.edges[arc.edge].v0, topology_.edges[arc.edge].v1});
        if (length(arc) < kShortPiece * length(longest_first_.front())) continue;
        const double part = width_from(arc.facet, line, rulings) / width;
        row.least_width = std::min(row.least_width, part);
        row.most_width = std::max(row.most_width, part);
        const double bend = glm::length(glm::cross(graph_.frames[facet].normal, graph_.frames[arc.facet].normal));
        row.least_bend = std::min(row.least_bend, bend);
        row.most_bend = std::max(row.most_bend, bend);
      }
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
