#include "visibility/watkins/skew_faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/no_index.hpp"
#include "scene/model/planarity.hpp"

namespace ligne::watkins {
namespace {

/// Edges that cutting made, each with a face: sorted, so that the triangles of one polygon are neighbours.
struct InnerEdge {
  std::uint32_t v0, v1, face;  ///< v0 < v1
  friend auto operator<=>(const InnerEdge&, const InnerEdge&) = default;
};

std::vector<InnerEdge> inner_edges(const Scene& scene) {
  std::vector<InnerEdge> edges;
  if (scene.corner_flags.empty()) return edges;
  for (std::uint32_t f = 0; f < scene.faces.size(); ++f) {
    if (scene.faces.contour_count(f) != 1) continue;
    const std::span<const std::uint32_t> corners = scene.faces.contour(f, 0);
    if (corners.size() != 3) continue;
    const std::size_t first = scene.faces.corner_index(f, 0);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = corners[k], b = corners[(k + 1) % 3];
      if (scene.corner_flags[first + k] & kCornerInner) edges.push_back({std::min(a, b), std::max(a, b), f});
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Per face: the lowest face of its polygon. An edge that coincident polygons share has two triangles of each, one
/// polygon after the other.
std::vector<std::uint32_t> polygon_of_faces(const Scene& scene) {
  const std::vector<InnerEdge> edges = inner_edges(scene);
  DisjointSets sets(scene.faces.size());
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i + 1;
    while (end < edges.size() && edges[end].v0 == edges[i].v0 && edges[end].v1 == edges[i].v1) ++end;
    for (; (end - i) % 2 == 0 && i + 1 < end; i += 2) sets.join(edges[i].face, edges[i + 1].face);
    i = end;
  }
  std::vector<std::uint32_t> polygon(scene.faces.size());
  for (std::uint32_t f = 0; f < polygon.size(); ++f) polygon[f] = sets.find(f);
  return polygon;
}

/// True if the corners of the faces are farther from a plane than the precision of their object explains.
bool is_skew(const Scene& scene, std::span<const std::uint32_t> faces, double precision) {
  std::vector<Point3> points;
  for (const std::uint32_t f : faces) {
    for (const std::uint32_t v : scene.faces.contour(f, 0)) points.push_back(scene.vertices[v]);
  }
  const SpanningPlane plane = spanning_plane(points);
  const double tolerance = planarity_tolerance(precision, plane.span);
  return std::ranges::any_of(points, [&](const Point3& p) { return std::abs(plane.distance(p)) > tolerance; });
}

/// Faces grouped by their polygon, for polygons of more than one face.
std::vector<std::vector<std::uint32_t>> skew_polygons(const Scene& scene) {
  const std::vector<std::uint32_t> polygon = polygon_of_faces(scene);
  std::vector<std::uint32_t> place(polygon.size(), kNone);
  std::vector<std::vector<std::uint32_t>> polygons;
  for (std::uint32_t f = 0; f < polygon.size(); ++f) {
    if (polygon[f] == f) continue;
    std::uint32_t& p = place[polygon[f]];
    if (p == kNone) {
      p = static_cast<std::uint32_t>(polygons.size());
      polygons.push_back({polygon[f]});
    }
    polygons[p].push_back(f);
  }
  std::vector<std::vector<std::uint32_t>> skew;
  std::size_t object = 0;
  std::ranges::sort(polygons);
  for (std::vector<std::uint32_t>& faces : polygons) {
    while (object < scene.objects.size() && faces[0] >= scene.objects[object].face_end) ++object;
    const double precision = object < scene.objects.size() ? scene.objects[object].precision : 0;
    if (is_skew(scene, faces, precision)) skew.push_back(std::move(faces));
  }
  return skew;
}

/// The sides of a face that its triangles do not share, without horizontal ones.
std::vector<RuledSide> sides_of(const ProjectedScene& scene, std::span<const std::uint32_t> triangles) {
  std::vector<std::array<std::uint32_t, 2>> ends;
  for (const std::uint32_t t : triangles) {
    const auto& v = scene.triangles[t].v;
    for (std::size_t k = 0; k < 3; ++k) ends.push_back({std::min(v[k], v[(k + 1) % 3]), std::max(v[k], v[(k + 1) % 3])});
  }
  std::ranges::sort(ends);
  std::vector<RuledSide> sides;
  for (std::size_t i = 0; i < ends.size();) {
    std::size_t end = i + 1;
    while (end < ends.size() && ends[end] == ends[i]) ++end;
    ProjectedVertex a = scene.vertices[ends[i][0]], b = scene.vertices[ends[i][1]];
    if (a.p.y > b.p.y) std::swap(a, b);
    if ((end - i) % 2 == 1 && a.p.y < b.p.y) sides.push_back({a, b});
    i = end;
  }
  return sides;
}

/// The triangles of each polygon in the projected scene, without those seen edge on.
std::vector<std::vector<std::uint32_t>> triangles_of(const ProjectedScene& scene, const std::vector<std::uint32_t>& polygon,
                                                     std::size_t count) {
  std::vector<std::vector<std::uint32_t>> triangles(count);
  for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) {
    const std::uint32_t p = polygon[scene.triangles[t].face];
    if (p != kNone && !scene.is_edge_on(scene.triangles[t])) triangles[p].push_back(t);
  }
  return triangles;
}

}  // namespace

void SkewFaces::add(std::uint32_t face, Face surface) {
  if (number_.size() <= face) number_.resize(face + 1, kNone);
  number_[face] = static_cast<std::uint32_t>(faces_.size());
  faces_.push_back(std::move(surface));
}

namespace {

/// Replaces the face numbers of the triangles and edges by those of whole faces.
void renumber(ProjectedScene& scene, const SkewFaces& faces, const std::vector<std::uint32_t>& whole) {
  const auto is_part = [&](std::uint32_t face) { return whole[face] != face || faces.has(face); };
  std::erase_if(scene.triangles, [&](const Triangle& t) { return scene.is_edge_on(t) && is_part(t.face); });
  for (Triangle& t : scene.triangles) t.face = whole[t.face];
  for (std::uint32_t f = 0; f < scene.face_is_edge_on.size(); ++f) {
    if (faces.has(f)) scene.face_is_edge_on[f] = 0;
  }
  const auto whole_of = [&](std::uint32_t face) { return face < whole.size() ? whole[face] : face; };
  std::vector<ProjectedEdge> edges;
  std::vector<std::array<double, 2>> edge_parts;
  for (std::size_t i = 0; i < scene.edges.size(); ++i) {
    ProjectedEdge edge = scene.edges[i];
    edge.face0 = whole_of(edge.face0);
    edge.face1 = whole_of(edge.face1);
    const bool is_inner = edge.face0 == edge.face1 && edge.face0 != kNone;
    if (is_inner && edge.line_class != LineClass::outline) continue;
    edges.push_back(edge);
    if (!scene.edge_parts.empty()) edge_parts.push_back(scene.edge_parts[i]);
  }
  scene.edges = std::move(edges);
  scene.edge_parts = std::move(edge_parts);
}

/// Largest depth tolerance of the facets of each polygon.
std::vector<double> tolerances_of(const std::vector<Facet>& facets, const std::vector<std::uint32_t>& polygon,
                                  std::size_t count) {
  std::vector<double> tolerances(count, 0);
  for (const Facet& f : facets) {
    const std::uint32_t p = polygon[f.face];
    if (p != kNone) tolerances[p] = std::max(tolerances[p], double(f.depth_tolerance));
  }
  return tolerances;
}

}  // namespace

std::optional<SkewScene> join_skew_faces(const ProjectedScene& scene, const std::vector<Facet>& facets) {
  const std::vector<std::vector<std::uint32_t>> polygons = skew_polygons(*scene.model);
  if (polygons.empty()) return std::nullopt;
  std::vector<std::uint32_t> polygon(scene.model->faces.size(), kNone), whole(polygon.size());
  std::iota(whole.begin(), whole.end(), 0u);
  for (std::uint32_t p = 0; p < polygons.size(); ++p) {
    for (const std::uint32_t f : polygons[p]) polygon[f] = p;
  }
  const std::vector<double> tolerances = tolerances_of(facets, polygon, polygons.size());
  const std::vector<std::vector<std::uint32_t>> triangles = triangles_of(scene, polygon, polygons.size());
  SkewScene joined{scene, {}, 0};
  for (std::uint32_t p = 0; p < polygons.size(); ++p) {
    const std::vector<RuledSide> sides = sides_of(scene, triangles[p]);
    if (sides.size() > kMostSkewSides) {
      ++joined.left_as_triangles;
      continue;
    }
    for (const std::uint32_t f : polygons[p]) whole[f] = polygons[p][0];
    SkewFaces::Face surface{ruled_parts(sides), -std::numeric_limits<double>::infinity(), tolerances[p]};
    for (const std::uint32_t t : triangles[p]) {
      for (const std::uint32_t v : scene.triangles[t].v) surface.farthest = std::max(surface.farthest, scene.vertices[v].z);
    }
    joined.faces.add(polygons[p][0], std::move(surface));
  }
  renumber(joined.scene, joined.faces, whole);
  return joined;
}

}  // namespace ligne::watkins
