#include "report/scene_facts.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <set>

#include "base/no_index.hpp"

namespace ligne {
namespace {

/// Index of the object that owns the vertex: objects own ascending ranges of vertices.
std::size_t owner(const std::vector<Object>& objects, std::uint32_t vertex) {
  const auto after = std::upper_bound(objects.begin(), objects.end(), vertex,
                                      [](std::uint32_t v, const Object& object) { return v < object.vertex_end; });
  return static_cast<std::size_t>(after - objects.begin());
}

}  // namespace

SceneFacts scene_facts(const Scene& scene, const Topology& topology) {
  SceneFacts facts;
  facts.vertices = scene.vertices.size();
  facts.faces = scene.faces.size();
  facts.triangles = topology.triangles.size();
  facts.edges = topology.edges.size();
  if (!scene.faces.all_triangles()) {
    for (std::size_t f = 0; f < scene.faces.size(); ++f) facts.faces_with_holes += scene.faces.contour_count(f) > 1;
  }
  if (!scene.vertices.empty()) facts.bounds = {scene.vertices[0], scene.vertices[0]};
  for (const Point3& vertex : scene.vertices) {
    facts.bounds = {glm::min(facts.bounds[0], vertex), glm::max(facts.bounds[1], vertex)};
  }
  for (const Object& object : scene.objects) {
    facts.precision = std::max(facts.precision, object.precision);
    ObjectFacts& entry = facts.objects.emplace_back();
    entry.name = object.name;
    entry.vertices = object.vertex_end - object.vertex_begin;
    entry.faces = object.face_end - object.face_begin;
  }
  for (const Material& material : scene.materials)
    facts.materials.push_back({material.name, material.color, material.opacity, 0});
  for (std::size_t i = 0; i < scene.objects.size() && !scene.materials.empty(); ++i) {
    std::set<std::size_t> used;
    for (std::uint32_t face = scene.objects[i].face_begin; face < scene.objects[i].face_end; ++face) {
      const std::size_t material = face < scene.face_material.size() ? scene.face_material[face] : 0;
      if (material >= facts.materials.size()) continue;
      ++facts.materials[material].faces;
      used.insert(material);
    }
    facts.objects[i].materials.assign(used.begin(), used.end());
  }
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const Edge& edge = topology.edges[e];
    const std::uint16_t flags = topology.edge_flags[e];
    const std::size_t object = owner(scene.objects, edge.v0);
    if (object >= facts.objects.size()) continue;
    ObjectFacts& entry = facts.objects[object];
    entry.border_edges += edge.face1 == kNone;
    entry.many_face_edges += (flags & kEdgeManyFaces) != 0;
    entry.unlike_wound_edges += (flags & kEdgeUnlikeWound) != 0;
  }
  return facts;
}

ViewFacts view_facts(const Scene& scene, const ProjectedScene& projected) {
  ViewFacts facts;
  std::uint32_t last = kNone;
  for (const ProjectedEdge& edge : projected.edges) {
    if (edge.source != last) ++facts.edges[static_cast<std::size_t>(edge.line_class)];
    last = edge.source;
  }
  const Camera& camera = projected.view.camera;
  for (std::size_t v = 0; v < scene.vertices.size(); ++v) {
    const double depth = glm::dot(camera.forward, scene.vertices[v] - camera.eye);
    facts.nearest = v == 0 ? depth : std::min(facts.nearest, depth);
    facts.farthest = v == 0 ? depth : std::max(facts.farthest, depth);
  }
  return facts;
}

}  // namespace ligne
