#include "scene/patches/facet_graph.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/disjoint_sets.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "geometry/degrees.hpp"
#include "scene/model/planarity.hpp"

namespace ligne {
namespace {

/// Least cosine between the normals of faces that may lie in one plane (2.6 degrees). Beyond it they do not, whatever
/// the precision.
constexpr double kFlatCosine = 0.999;
/// Largest number of corners of a facet that may be curved; and the same if all corners lie on two rulings.
constexpr std::size_t kStripCorners = 4, kMostRulingCorners = 16;
/// Largest number of corners of a strip that was cut at its ends.
constexpr std::size_t kMostCutCorners = 64;
/// Largest ratio of its width to that of a neighbour.
constexpr double kAlikeWidths = 2;
/// Largest distance of its rulings from parallel lines, in their length: files print coordinates with six digits.
constexpr double kParallel = 1e-4;

bool is_triangle(const Scene& scene, std::uint32_t f) {
  return scene.faces.contour_count(f) == 1 && scene.faces.contour(f, 0).size() == 3;
}

/// The normal of a face, with twice its area as length.
Point3 double_area(const Scene& scene, std::uint32_t f) {
  Point3 sum(0, 0, 0);
  for (std::size_t c = 0; c < scene.faces.contour_count(f); ++c) {
    const auto contour = scene.faces.contour(f, c);
    const Point3& a = scene.vertices[contour[0]];
    for (std::size_t k = 2; k < contour.size(); ++k) {
      sum += glm::cross(scene.vertices[contour[k - 1]] - a, scene.vertices[contour[k]] - a);
    }
  }
  return sum;
}

template <class Visit>
void for_corners(const Scene& scene, std::uint32_t f, Visit visit) {
  for (std::size_t c = 0; c < scene.faces.contour_count(f); ++c) {
    for (const std::uint32_t v : scene.faces.contour(f, c)) visit(v);
  }
}

/// Largest distance of a corner from the first one.
double span_of(const Scene& scene, std::uint32_t f) {
  const auto contour = scene.faces.contour(f, 0);
  double most = 0;
  for (const std::uint32_t v : contour) most = std::max(most, glm::distance(scene.vertices[v], scene.vertices[contour[0]]));
  return most;
}

/// Whether the corners of a face lie in the plane of another one through a common vertex.
bool lies_in_plane(const Scene& scene, std::uint32_t f, std::uint32_t other, const Point3& at, double tolerance) {
  const Point3 area = double_area(scene, other);
  const double size = glm::length(area);
  if (!(size > 0)) return false;
  bool all = true;
  for_corners(scene, f,
              [&](std::uint32_t v) { all = all && std::abs(glm::dot(scene.vertices[v] - at, area)) <= tolerance * size; });
  return all;
}

/// Whether points lie on two lines, with two or more on each: the rulings of a strip.
bool lie_on_two_lines(std::span<const Point3> points, double tolerance) {
  const auto is_off = [&](const Point3& a, const Point3& b, const Point3& p) {
    const Point3 d = b - a;
    return !(glm::length(glm::cross(d, p - a)) <= tolerance * glm::length(d));
  };
  // One of the lines runs through the first point and one of the others.
  for (std::size_t k = 1; k < points.size(); ++k) {
    std::vector<Point3> rest;
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (i != k && is_off(points[0], points[k], points[i])) rest.push_back(points[i]);
    }
    if (rest.size() < 2) continue;
    const auto is_beside = [&](const Point3& p) { return is_off(rest[0], rest[1], p); };
    if (std::none_of(rest.begin() + 2, rest.end(), is_beside)) return true;
  }
  return false;
}

class GraphBuilder {
 public:
  GraphBuilder(const Scene& scene, const Topology& topology, const Object& object, std::span<const glm::vec3> normals)
      : scene_(scene), topology_(topology), object_(object), normals_(normals) {}

  FacetGraph run(std::uint32_t edge_begin, std::uint32_t edge_end) {
    join_faces(edge_begin, edge_end);
    reserve_facets(graph_.faces.begin.size() - 1);
    for (std::size_t i = 0; i + 1 < graph_.faces.begin.size(); ++i) {
      const auto faces = graph_.faces[i];
      faces.size() == 1 && is_triangle(scene_, faces[0]) ? add_triangle(faces[0]) : add_facet(i);
    }
    add_arcs(edge_begin, edge_end);
    find_cut_strips();
    return std::move(graph_);
  }

 private:
  bool may_be_smooth(std::uint32_t e) const {
    constexpr std::uint16_t kNotSmooth = kEdgeManyFaces | kEdgeUnlikeWound | kEdgeSharp | kEdgeCrossing;
    return topology_.edges[e].face1 != kNone && !(topology_.edge_flags[e] & kNotSmooth);
  }

  bool is_flat(const Edge& edge) const {
    const double cosine = glm::dot(Point3(normals_[edge.face0]), Point3(normals_[edge.face1]));
    if (cosine < kFlatCosine) return false;
    if (cosine > flat_) return true;
    if (is_triangle(scene_, edge.face0) && is_triangle(scene_, edge.face1)) return are_flat_triangles(edge);
    const double span = std::max(span_of(scene_, edge.face0), span_of(scene_, edge.face1));
    const double tolerance = planarity_tolerance(object_.precision, span);
    const Point3& at = scene_.vertices[edge.v0];
    return lies_in_plane(scene_, edge.face1, edge.face0, at, tolerance) ||
           lies_in_plane(scene_, edge.face0, edge.face1, at, tolerance);
  }

  /// The corner of a triangle that is no end of an edge of it.
  const Point3& corner_beside(std::uint32_t triangle, const Edge& edge) const {
    const auto corners = scene_.faces.contour(triangle, 0);
    return scene_.vertices[*std::ranges::find_if(corners, [&](std::uint32_t v) { return v != edge.v0 && v != edge.v1; })];
  }

  /// is_flat() for two triangles: the third corner of one of them lies in the plane of the other.
  bool are_flat_triangles(const Edge& edge) const {
    const Point3& at = scene_.vertices[edge.v0];
    const Point3 along = scene_.vertices[edge.v1] - at;
    const Point3 first = corner_beside(edge.face0, edge) - at, second = corner_beside(edge.face1, edge) - at;
    const Point3 first_area = glm::cross(along, first), second_area = glm::cross(along, second);
    const double size = std::max(glm::dot(first_area, first_area), glm::dot(second_area, second_area));
    const auto square = [](const Point3& p) { return glm::dot(p, p); };
    const double span =
        std::max({square(along), square(first), square(second), square(first - along), square(second - along)});
    const double tolerance = planarity_tolerance(object_.precision, std::sqrt(span));
    return size > 0 && std::abs(glm::dot(first_area, second)) <= tolerance * std::sqrt(size);
  }

  void join_faces(std::uint32_t edge_begin, std::uint32_t edge_end) {
    const std::uint32_t first = object_.face_begin, count = object_.face_end - first;
    DisjointSets sets(count);
    for (std::uint32_t e = edge_begin; e < edge_end; ++e) {
      const Edge& edge = topology_.edges[e];
      if (may_be_smooth(e) && is_flat(edge)) sets.join(edge.face0 - first, edge.face1 - first);
    }
    const std::vector<std::uint32_t> order = faces_by_vertices();
    graph_.facet_of.resize(count);
    std::vector<std::uint32_t> facet_of_set(count, kNone), sizes;
    for (const std::uint32_t f : order) {
      std::uint32_t& facet = facet_of_set[sets.find(f)];
      if (facet == kNone) {
        facet = static_cast<std::uint32_t>(sizes.size());
        sizes.push_back(0);
      }
      graph_.facet_of[f] = facet;
      ++sizes[facet];
    }
    for (const std::uint32_t size : sizes) graph_.faces.begin.push_back(graph_.faces.begin.back() + size);
    graph_.faces.values.resize(count);
    std::vector<std::uint32_t> next(graph_.faces.begin.begin(), graph_.faces.begin.end() - 1);
    for (const std::uint32_t f : order) graph_.faces.values[next[graph_.facet_of[f]]++] = first + f;
  }

  /// The faces of the object, numbered from 0, sorted by their three lowest vertices. Facets are numbered in this
  /// order, so that the order of faces in the file does not matter.
  std::vector<std::uint32_t> faces_by_vertices() const {
    const std::uint32_t first = object_.face_begin, count = object_.face_end - first;
    std::vector<std::array<std::uint32_t, 4>> keys(count);
    for (std::uint32_t f = 0; f < count; ++f) {
      std::array<std::uint32_t, 4>& key = keys[f] = {kNone, kNone, kNone, f};
      for_corners(scene_, first + f, [&](std::uint32_t v) {
        for (std::size_t i = 0; i < 3; ++i) {
          if (v < key[i]) std::swap(v, key[i]);
        }
      });
    }
    parallel_sort(keys.begin(), keys.end());
    std::vector<std::uint32_t> order;
    order.reserve(count);
    for (const auto& key : keys) order.push_back(key[3]);
    return order;
  }

  void reserve_facets(std::size_t count) {
    graph_.frames.reserve(count);
    graph_.area.reserve(count);
    graph_.is_sliver.reserve(count);
    graph_.is_plane.reserve(count);
    graph_.vertices.begin.reserve(count + 1);
    graph_.vertices.values.reserve(3 * count);
  }

  /// add_facet() for a facet of a single triangle.
  void add_triangle(std::uint32_t f) {
    const auto corners = scene_.faces.contour(f, 0);
    const Point3 &a = scene_.vertices[corners[0]], &b = scene_.vertices[corners[1]], &c = scene_.vertices[corners[2]];
    const Point3 area = glm::cross(b - a, c - a);
    const double size = glm::length(area);
    graph_.frames.push_back({size > 0 ? (a + b + c) / 3.0 : a, size > 0 ? area / size : Point3(normals_[f])});
    graph_.area.push_back(size / 2);
    const double span = std::sqrt(std::max(glm::dot(b - a, b - a), glm::dot(c - a, c - a)));
    graph_.is_sliver.push_back(size <= 4 * straightness_tolerance(object_.precision, span) * span);
    graph_.is_plane.push_back(0);
    std::array<std::uint32_t, 3> sorted{corners[0], corners[1], corners[2]};
    std::sort(sorted.begin(), sorted.end());
    graph_.vertices.values.insert(graph_.vertices.values.end(), sorted.begin(), sorted.end());
    graph_.vertices.begin.push_back(static_cast<std::uint32_t>(graph_.vertices.values.size()));
  }

  void add_facet(std::size_t facet) {
    corners_.clear();
    Point3 area(0, 0, 0), middle(0, 0, 0);
    double size = 0, span = 0;
    for (const std::uint32_t f : graph_.faces[facet]) {
      const Point3 part = double_area(scene_, f);
      const double weight = glm::length(part);
      Point3 sum(0, 0, 0);
      for (const std::uint32_t v : scene_.faces.contour(f, 0)) sum += scene_.vertices[v];
      area += part;
      middle += weight / static_cast<double>(scene_.faces.contour(f, 0).size()) * sum;
      size += weight;
      span = std::max(span, span_of(scene_, f));
      for_corners(scene_, f, [&](std::uint32_t v) { corners_.push_back(v); });
    }
    std::sort(corners_.begin(), corners_.end());
    corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
    const double length = glm::length(area);
    graph_.frames.push_back({size > 0 ? middle / size : scene_.vertices[corners_[0]],
                             length > 0 ? area / length : Point3(normals_[graph_.faces[facet][0]])});
    graph_.area.push_back(size / 2);
    const double tolerance = 4 * straightness_tolerance(object_.precision, span);
    graph_.is_sliver.push_back(size <= tolerance * span);
    graph_.is_plane.push_back(corners_.size() > kStripCorners && !is_strip(tolerance));
    graph_.vertices.values.insert(graph_.vertices.values.end(), corners_.begin(), corners_.end());
    graph_.vertices.begin.push_back(static_cast<std::uint32_t>(graph_.vertices.values.size()));
  }

  bool is_strip(double tolerance) const {
    if (corners_.size() > kMostRulingCorners) return false;
    std::vector<Point3> points;
    points.reserve(corners_.size());
    for (const std::uint32_t v : corners_) points.push_back(scene_.vertices[v]);
    return lie_on_two_lines(points, tolerance);
  }

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

  /// Makes strips of the planes that are cut strips.
  void find_cut_strips() {
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

  void add_arcs(std::uint32_t edge_begin, std::uint32_t edge_end) {
    const double cosine = sine_cosine_degrees(kLargestBend).cosine;
    const double smooth_cosine = sine_cosine_degrees(kLargestSmoothBend).cosine;
    const double steep_cosine = sine_cosine_degrees(kSteepBend).cosine;
    struct Pair {
      std::uint32_t a, b, edge;
    };
    std::vector<Pair> pairs;
    graph_.arc_begin.assign(graph_.size() + 1, 0);
    for (std::uint32_t e = edge_begin; e < edge_end; ++e) {
      if (!may_be_smooth(e)) continue;
      const std::uint32_t a = graph_.facet_of[topology_.edges[e].face0 - object_.face_begin];
      const std::uint32_t b = graph_.facet_of[topology_.edges[e].face1 - object_.face_begin];
      if (a == b) continue;
      const bool by_chance = graph_.is_sliver[a] || graph_.is_sliver[b];
      const double least = topology_.edge_flags[e] & kEdgeSmooth ? smooth_cosine : cosine;
      const double bend = glm::dot(graph_.frames[a].normal, graph_.frames[b].normal);
      if (!by_chance && bend < least) {
        if (bend >= steep_cosine) graph_.steep.push_back({a, b});
        continue;
      }
      ++graph_.arc_begin[a + 1], ++graph_.arc_begin[b + 1];
      pairs.push_back({a, b, e});
    }
    for (std::size_t i = 0; i < graph_.size(); ++i) graph_.arc_begin[i + 1] += graph_.arc_begin[i];
    graph_.arcs.resize(2 * pairs.size());
    std::vector<std::uint32_t> next(graph_.arc_begin.begin(), graph_.arc_begin.end() - 1);
    for (const Pair& pair : pairs) {
      graph_.arcs[next[pair.a]++] = {pair.b, pair.edge};
      graph_.arcs[next[pair.b]++] = {pair.a, pair.edge};
    }
  }

  const double flat_ = sine_cosine_degrees(kFlatBend).cosine;
  const Scene& scene_;
  const Topology& topology_;
  const Object& object_;
  std::span<const glm::vec3> normals_;
  FacetGraph graph_;
  std::vector<std::uint32_t> corners_;  ///< corners of the facet that add_facet() adds
};

}  // namespace

FacetGraph facet_graph(const Scene& scene, const Topology& topology, const Object& object, std::uint32_t edge_begin,
                       std::uint32_t edge_end, std::span<const glm::vec3> normals) {
  return GraphBuilder(scene, topology, object, normals).run(edge_begin, edge_end);
}

}  // namespace ligne
