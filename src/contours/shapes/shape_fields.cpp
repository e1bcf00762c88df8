#include "contours/shapes/shape_fields.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "scene/model/bounds.hpp"

namespace ligne {
namespace {

// Adjustable.
/// Curvature is smoothed over this fraction of the object's size, but over at least kEvenedEdges median edge lengths.
constexpr double kEvenedPart = 1.0 / 100, kEvenedEdges = 1.0;
/// Normals are smoothed first, over this fraction of that length.
constexpr double kNormalPart = 0.5;
/// Least sine of the angle between the view vector and the normal. At smaller angles the radial direction is too
/// uncertain.
constexpr double kLeastSine = 0.3;

/// The properties of an object that all its nodes share.
struct ObjectShape {
  double size = 0;    ///< diagonal of its bounding box
  double length = 0;  ///< length over which its curvature is smoothed
  int outward = 0;    ///< see ShapeFields
};

/// The sign of the volume of a closed and consistently wound body; 0 for other objects.
int outward_of(const Scene& scene, const Topology& topology, const Object& object) {
  const auto [edge_begin, edge_end] = edges_of(topology, object);
  for (std::uint32_t e = edge_begin; e < edge_end; ++e) {
    if (topology.edges[e].face1 == kNone || (topology.edge_flags[e] & (kEdgeManyFaces | kEdgeUnlikeWound))) return 0;
  }
  double volume = 0;
  const auto begin = std::ranges::lower_bound(topology.triangles, object.face_begin, {}, &Triangle::face);
  const Point3 origin = scene.vertices[object.vertex_begin];
  for (auto t = begin; t != topology.triangles.end() && t->face < object.face_end; ++t) {
    volume += glm::dot(scene.vertices[t->v[0]] - origin,
                       glm::cross(scene.vertices[t->v[1]] - origin, scene.vertices[t->v[2]] - origin));
  }
  return volume > 0 ? 1 : volume < 0 ? -1 : 0;
}

ObjectShape shape_of(const Scene& scene, const Topology& topology, const Object& object) {
  ObjectShape shape;
  if (object.vertex_begin == object.vertex_end) return shape;
  shape.size = object_size(scene, object);
  std::vector<double> edges;
  const auto [edge_begin, edge_end] = edges_of(topology, object);
  for (std::uint32_t e = edge_begin; e < edge_end; ++e) {
    edges.push_back(glm::length(scene.vertices[topology.edges[e].v1] - scene.vertices[topology.edges[e].v0]));
  }
  double median = 0;
  if (!edges.empty()) {
    const auto middle = edges.begin() + static_cast<std::ptrdiff_t>(edges.size() / 2);
    std::nth_element(edges.begin(), middle, edges.end());
    median = *middle;
  }
  shape.length = std::max(kEvenedPart * shape.size, kEvenedEdges * median);
  shape.outward = outward_of(scene, topology, object);
  return shape;
}

std::vector<std::uint32_t> objects_of_nodes(const Scene& scene, const FormMesh& mesh) {
  std::vector<std::uint32_t> objects;
  objects.reserve(mesh.vertex.size());
  for (const std::uint32_t v : mesh.vertex) objects.push_back(static_cast<std::uint32_t>(object_of_vertex(scene, v)));
  return objects;
}

Point3 direction(const TangentFrame& frame, double angle) { return frame.x * std::cos(angle) + frame.y * std::sin(angle); }

}  // namespace

Point3 ShapeFields::slope(std::uint32_t triangle, const std::array<double, 3>& values) const {
  const Point3 area = mesh.area_vector(triangle);
  const double square = glm::dot(area, area);
  if (!(square > 0)) return {0, 0, 0};
  Point3 sum{0, 0, 0};
  for (int k = 0; k < 3; ++k) {
    sum += values[static_cast<std::size_t>(k)] * (mesh.point(triangle, (k + 2) % 3) - mesh.point(triangle, (k + 1) % 3));
  }
  return glm::cross(area, sum) * (size[mesh.triangles[triangle].node[0]] / square);
}

std::vector<Point3> ShapeFields::slopes(const std::vector<double>& values) const {
  std::vector<Point3> sums(values.size(), Point3{0, 0, 0});
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& node = mesh.triangles[t].node;
    const Point3 part =
        slope(t, {values[node[0]], values[node[1]], values[node[2]]}) * (glm::length(mesh.area_vector(t)) / 6);
    for (const std::uint32_t n : node) sums[n] += part;
  }
  for (std::size_t n = 0; n < sums.size(); ++n) {
    sums[n] = mesh.areas[n] > 0 ? sums[n] / mesh.areas[n] : Point3{0, 0, 0};
    sums[n] -= normals[n] * glm::dot(normals[n], sums[n]);
  }
  return sums;
}

ShapeFields shape_fields(const Scene& scene, const Topology& topology, const RegionBorders& borders) {
  ShapeFields fields;
  fields.mesh = form_mesh(scene, topology, borders.crease_degrees, borders.creases);
  const FormMesh& mesh = fields.mesh;
  std::vector<ObjectShape> shapes(scene.objects.size());
  parallel_for(shapes.size(), [&](std::size_t o) { shapes[o] = shape_of(scene, topology, scene.objects[o]); });
  const std::vector<std::uint32_t> objects = objects_of_nodes(scene, mesh);
  for (const std::uint32_t o : objects) {
    fields.size.push_back(shapes[o].size);
    fields.outward.push_back(shapes[o].outward);
  }
  fields.frames = tangent_frames(mesh);
  std::vector<FormLink> links = form_links(mesh, fields.frames);
  // Each object is smoothed over its own length.
  for (FormLink& link : links) link.weight *= shapes[objects[link.i]].length * shapes[objects[link.i]].length;
  fields.normals = evened_normals(mesh, links, kNormalPart);
  const std::vector<SecondForm> forms = second_forms(mesh, fields.frames, fields.normals);
  std::vector<Complex> mean(forms.size()), difference(forms.size());
  for (std::size_t n = 0; n < forms.size(); ++n) {
    const auto [e, f, g] = forms[n];
    mean[n] = fields.size[n] * (e + g) / 2;
    difference[n] = fields.size[n] * Complex{(e - g) / 2, f};
  }
  // Smoothed twice: one pass leaves a peak where a single node stands out.
  for (int round = 0; round < 2; ++round) {
    mean = evened(mesh.areas, mean, links, 1, 0);
    difference = evened(mesh.areas, difference, links, 1, 2);
  }
  fields.difference = std::move(difference);
  for (const Complex& value : mean) fields.mean.push_back(value.real());
  return fields;
}

ExtremumField extremum_field(const ShapeFields& fields, int sign) {
  const std::size_t n = fields.mean.size();
  std::vector<double> larger(n);
  ExtremumField field;
  field.way.resize(n);
  field.curvature.resize(n);
  field.value.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double mean = sign * fields.mean[i];
    const Complex difference = double(sign) * fields.difference[i];
    larger[i] = mean + std::abs(difference);
    field.way[i] = direction(fields.frames[i], std::arg(difference) / 2);
    field.curvature[i] = mean > 0 ? larger[i] : 0;
  }
  const std::vector<Point3> slopes = fields.slopes(larger);
  for (std::size_t i = 0; i < n; ++i) field.value[i] = glm::dot(slopes[i], field.way[i]);
  return field;
}

RadialField radial_field(const ShapeFields& fields, const Camera& camera) {
  const std::size_t n = fields.mean.size();
  RadialField field;
  field.value.assign(n, 0);
  field.growth.assign(n, 0);
  std::vector<Point3> radial(n, Point3{0, 0, 0});
  for (std::size_t i = 0; i < n; ++i) {
    const Point3 eye = unit(to_eye(camera, fields.mesh.points[i])), &normal = fields.normals[i];
    const double facing = glm::dot(normal, eye);
    const Point3 over = eye - normal * facing;
    const double angle = std::atan2(glm::dot(over, fields.frames[i].y), glm::dot(over, fields.frames[i].x));
    field.value[i] = fields.mean[i] + (std::conj(fields.difference[i]) * std::polar(1.0, 2 * angle)).real();
    const int side = fields.outward[i] != 0 ? fields.outward[i] : facing < 0 ? -1 : 1;
    if (side * facing > 0 && glm::length(over) >= kLeastSine) radial[i] = double(side) * unit(over);
  }
  const std::vector<Point3> slopes = fields.slopes(field.value);
  for (std::size_t i = 0; i < n; ++i) field.growth[i] = glm::dot(slopes[i], radial[i]);
  return field;
}

}  // namespace ligne
