#include "scene/patches/facet_graph.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

#include "base/large_vector.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "base/parallel_each.hpp"
#include "geometry/degrees.hpp"
#include "scene/model/faces_and_edges.hpp"
#include "scene/model/planarity.hpp"
#include "scene/patches/facets/cut_strips.hpp"
#include "scene/patches/facets/flat_joints.hpp"
#include "scene/patches/facets/flat_sets.hpp"

namespace ligne {
namespace {

/// Facets or edges of a block of the graph. Most objects have fewer than kShortWorkBlock.
constexpr std::size_t kFacetBlock = 2048;

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

/// Whether a face is so narrow that rounding determines its normal. `size`: twice its area; `span`: see face_span().
bool is_narrow(double size, double span, double precision) {
  return size <= 4 * straightness_tolerance(precision, span) * span;
}

class GraphBuilder {
 public:
  GraphBuilder(const Scene& scene, const Topology& topology, const Object& object, std::span<const glm::vec3> normals)
      : scene_(scene), topology_(topology), object_(object), normals_(normals) {}

  FacetGraph run(std::uint32_t edge_begin, std::uint32_t edge_end, std::span<const std::uint32_t> joints) {
    join_faces(edge_begin, edge_end, without_inflections(scene_, topology_, edge_begin, normals_, joints));
    measure_facets();
    add_arcs(edge_begin, edge_end);
    find_cut_strips(scene_, topology_, object_, graph_);
    return std::move(graph_);
  }

 private:
  void join_faces(std::uint32_t edge_begin, std::uint32_t edge_end, std::span<const std::uint32_t> joints) {
    const std::uint32_t first = object_.face_begin, count = object_.face_end - first;
    const std::vector<std::uint32_t> order = faces_by_edges(edge_begin, edge_end);
    const std::span edges(topology_.edges.data() + edge_begin, topology_.edges.data() + edge_end);
    const FlatSets sets = flat_sets(scene_, object_, edges, joints, order);
    graph_.has_small_faces = sets.has_small_faces;
    graph_.facet_of.assign(count, kNone);
    std::uint32_t facets = 0;
    for (const std::uint32_t f : order) {
      std::uint32_t& facet = graph_.facet_of[sets.set_of[f]];
      if (facet == kNone) facet = facets++;
      graph_.facet_of[f] = facet;
    }
    graph_.faces = {facets, [&](const auto& put) {
                      for (const std::uint32_t f : order) put(graph_.facet_of[f], first + f);
                    }};
  }

  /// A face of the object, numbered from 0, behind its three lowest vertices.
  std::array<std::uint32_t, 4> key_of(std::uint32_t f) const {
    std::array<std::uint32_t, 4> key{kNone, kNone, kNone, f};
    for (std::uint32_t v : corners_of(scene_.faces, object_.face_begin + f)) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (v < key[i]) std::swap(v, key[i]);
      }
    }
    return key;
  }

  /// The faces of the object, numbered from 0, in the order of their lowest edges, and at one edge by their vertices. Facets
  /// are numbered in this order, so that the order of faces in the file does not matter. Faces that share all their edges
  /// with two others or more come last.
  std::vector<std::uint32_t> faces_by_edges(std::uint32_t edge_begin, std::uint32_t edge_end) const {
    const std::uint32_t first = object_.face_begin, count = object_.face_end - first;
    std::vector<std::uint32_t> order = large_vector<std::uint32_t>(count);
    std::vector<std::uint8_t> is_listed(count, 0);
    std::uint32_t listed = 0;
    const auto list = [&](std::uint32_t f) {
      if (!std::exchange(is_listed[f], 1)) order[listed++] = f;
    };
    for (std::uint32_t e = edge_begin; e < edge_end; ++e) {
      if (topology_.edge_flags[e] & kEdgeManyFaces) continue;
      const Edge& edge = topology_.edges[e];
      const std::uint32_t f = edge.face0 - first;
      if (edge.face1 == kNone) {
        list(f);
        continue;
      }
      const std::uint32_t g = edge.face1 - first;
      if (!is_listed[f] && !is_listed[g] && key_of(g) < key_of(f)) list(g);
      list(f);
      list(g);
    }
    const std::uint32_t rest = listed;
    for (std::uint32_t f = 0; f < count && listed < count; ++f) list(f);
    std::sort(order.begin() + rest, order.end(), [&](std::uint32_t f, std::uint32_t g) { return key_of(f) < key_of(g); });
    return order;
  }

  /// Measures the facets, and lists their corners.
  void measure_facets() {
    const std::size_t count = graph_.faces.begin.size() - 1;
    graph_.frames = UninitializedVector<FacetFrame>(count);
    graph_.area = UninitializedVector<double>(count);
    graph_.is_sliver.resize(count);
    graph_.is_plane.resize(count);
    std::vector<std::uint32_t>& begins = graph_.vertices.begin;
    begins.resize(count + 1);
    std::vector<std::vector<std::uint32_t>> corners(block_count(count, kFacetBlock));
    parallel_blocks(count, kFacetBlock, [&](std::size_t begin, std::size_t end) {
      std::vector<std::uint32_t>& of_block = corners[begin / kFacetBlock];
      of_block.reserve(3 * (end - begin));
      for (std::size_t facet = begin; facet < end; ++facet) {
        const std::size_t before = of_block.size();
        const auto faces = graph_.faces[facet];
        faces.size() == 1 && is_triangle(scene_.faces, faces[0]) ? add_triangle(facet, of_block)
                                                                 : add_facet(facet, of_block);
        begins[facet + 1] = static_cast<std::uint32_t>(of_block.size() - before);
      }
    });
    for (std::size_t i = 1; i < begins.size(); ++i) begins[i] += begins[i - 1];
    graph_.vertices.values = large_vector<std::uint32_t>(begins.back());
    parallel_for(corners.size(), [&](std::size_t block) {
      std::ranges::copy(corners[block], graph_.vertices.values.begin() + begins[block * kFacetBlock]);
    });
  }

  /// add_facet() for a facet of a single triangle.
  void add_triangle(std::size_t facet, std::vector<std::uint32_t>& of_block) {
    const std::uint32_t f = graph_.faces[facet][0];
    const auto corners = scene_.faces.contour(f, 0);
    const Point3 &a = scene_.vertices[corners[0]], &b = scene_.vertices[corners[1]], &c = scene_.vertices[corners[2]];
    const Point3 area = glm::cross(b - a, c - a);
    const double size = glm::length(area);
    graph_.frames[facet] = {size > 0 ? (a + b + c) / 3.0 : a, size > 0 ? area / size : Point3(normals_[f])};
    graph_.area[facet] = size / 2;
    const double span = std::sqrt(std::max(glm::dot(b - a, b - a), glm::dot(c - a, c - a)));
    graph_.is_sliver[facet] = is_narrow(size, span, object_.precision);
    std::array<std::uint32_t, 3> sorted{corners[0], corners[1], corners[2]};
    std::sort(sorted.begin(), sorted.end());
    of_block.insert(of_block.end(), sorted.begin(), sorted.end());
  }

  /// Measures a facet, and adds its corners to the list.
  void add_facet(std::size_t facet, std::vector<std::uint32_t>& of_block) {
    const auto before = static_cast<std::ptrdiff_t>(of_block.size());
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
      span = std::max(span, face_span(scene_, f));
      std::ranges::copy(corners_of(scene_.faces, f), std::back_inserter(of_block));
    }
    std::sort(of_block.begin() + before, of_block.end());
    of_block.erase(std::unique(of_block.begin() + before, of_block.end()), of_block.end());
    const std::span corners = std::span(of_block).subspan(static_cast<std::size_t>(before));
    const double length = glm::length(area);
    graph_.frames[facet] = {size > 0 ? middle / size : scene_.vertices[corners[0]],
                            length > 0 ? area / length : Point3(normals_[graph_.faces[facet][0]])};
    graph_.area[facet] = size / 2;
    const double tolerance = 4 * straightness_tolerance(object_.precision, span);
    graph_.is_sliver[facet] = size <= tolerance * span;
    graph_.is_plane[facet] = corners.size() > kStripCorners && !is_strip(corners, tolerance);
  }

  bool is_strip(std::span<const std::uint32_t> corners, double tolerance) const {
    if (corners.size() > kMostRulingCorners) return false;
    std::vector<Point3> points;
    points.reserve(corners.size());
    for (const std::uint32_t v : corners) points.push_back(scene_.vertices[v]);
    return lie_on_two_lines(points, tolerance);
  }

  std::array<std::uint32_t, 2> facets_at(std::uint32_t e) const {
    const Edge& edge = topology_.edges[e];
    return {graph_.facet_of[edge.face0 - object_.face_begin], graph_.facet_of[edge.face1 - object_.face_begin]};
  }

  enum class Joint : std::uint8_t { none, arc, steep };

  Joint joint_at(std::uint32_t e) const {
    if (!may_be_smooth(topology_, e)) return Joint::none;
    const auto [a, b] = facets_at(e);
    if (a == b) return Joint::none;
    if (graph_.is_sliver[a] || graph_.is_sliver[b]) return Joint::arc;
    const double least = topology_.edge_flags[e] & kEdgeSmooth ? smooth_cosine_ : cosine_;
    const double bend = glm::dot(graph_.frames[a].normal, graph_.frames[b].normal);
    return !(bend < least) ? Joint::arc : bend >= steep_cosine_ ? Joint::steep : Joint::none;
  }

  void add_arcs(std::uint32_t edge_begin, std::uint32_t edge_end) {
    std::vector<Joint> joints(edge_end - edge_begin);
    parallel_each(
        joints.size(), [&](std::size_t k) { joints[k] = joint_at(static_cast<std::uint32_t>(edge_begin + k)); },
        kFacetBlock);
    std::vector<std::uint32_t>& begins = graph_.arc_begin;
    begins.assign(graph_.size() + 2, 0);
    for (std::uint32_t k = 0; k < joints.size(); ++k) {
      if (joints[k] == Joint::none) continue;
      const auto [a, b] = facets_at(edge_begin + k);
      if (joints[k] == Joint::steep) {
        graph_.steep.push_back({a, b});
      } else {
        ++begins[a + 2], ++begins[b + 2];
      }
    }
    for (std::size_t i = 2; i < begins.size(); ++i) begins[i] += begins[i - 1];
    graph_.arcs = UninitializedVector<FacetGraph::Arc>(begins.back());
    for (std::uint32_t k = 0; k < joints.size(); ++k) {
      if (joints[k] != Joint::arc) continue;
      const auto [a, b] = facets_at(edge_begin + k);
      graph_.arcs[begins[a + 1]++] = {b, edge_begin + k};
      graph_.arcs[begins[b + 1]++] = {a, edge_begin + k};
    }
  }

  const double cosine_ = sine_cosine_degrees(kLargestBend).cosine;
  const double smooth_cosine_ = sine_cosine_degrees(kLargestSmoothBend).cosine;
  const double steep_cosine_ = sine_cosine_degrees(kSteepBend).cosine;
  const Scene& scene_;
  const Topology& topology_;
  const Object& object_;
  std::span<const glm::vec3> normals_;
  FacetGraph graph_;
};

}  // namespace

std::vector<std::uint32_t> edges_inside_planes(const Topology& topology, const Object& object, const FacetGraph& graph,
                                               std::uint32_t edge_begin, std::uint32_t edge_end,
                                               std::span<const glm::vec3> normals) {
  std::vector<std::uint32_t> found;
  if (!graph.has_small_faces) return found;
  for (std::uint32_t e = edge_begin; e < edge_end; ++e) {
    const Edge& edge = topology.edges[e];
    if (edge.face1 == kNone) continue;
    if (graph.facet_of[edge.face0 - object.face_begin] != graph.facet_of[edge.face1 - object.face_begin]) continue;
    if (glm::dot(Point3(normals[edge.face0]), Point3(normals[edge.face1])) < kFlatCosine) found.push_back(e);
  }
  return found;
}

FacetGraph facet_graph(const Scene& scene, const Topology& topology, const Object& object, EdgeRange edges,
                       std::span<const glm::vec3> normals, std::span<const std::uint32_t> joints) {
  return GraphBuilder(scene, topology, object, normals).run(edges.begin, edges.end, joints);
}

FacetGraph facet_graph(const Scene& scene, const Topology& topology, const Object& object, EdgeRange edges,
                       std::span<const glm::vec3> normals) {
  std::vector<std::uint32_t> all(topology.edges.size());
  std::iota(all.begin(), all.end(), 0u);
  return facet_graph(scene, topology, object, edges, normals, flat_joints(scene, topology, object, edges, normals, all));
}

}  // namespace ligne
