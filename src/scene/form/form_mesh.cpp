#include "scene/form/form_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

#include "base/disjoint_sets.hpp"
#include "base/parallel.hpp"
#include "scene/creases/crease_lines.hpp"

namespace ligne {
namespace {

/// A side of a triangle, by the scene vertices at its ends.
struct Side {
  std::uint32_t low, high, triangle, corner;
};

std::vector<Side> sides_of(const std::vector<Triangle>& triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangles[t].v[k], b = triangles[t].v[(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), t, k});
    }
  }
  parallel_sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.triangle, a.corner) < std::tie(b.low, b.high, b.triangle, b.corner);
  });
  return sides;
}

/// Whether the windings of two triangles disagree: both traverse their common side in the same direction.
bool unlike_wound(const std::vector<Triangle>& triangles, const Side& a, const Side& b) {
  return triangles[a.triangle].v[a.corner] == triangles[b.triangle].v[b.corner];
}

/// Limit for smoothing normals across an edge, in crease angles, even if the edge is not a crease. Adjustable.
constexpr double kSharp = 2;

void join_neighbours(const Scene& scene, const Topology& topology, double crease_degrees,
                     const std::vector<std::uint8_t>* creases, FormMesh& mesh) {
  const std::vector<Triangle>& triangles = topology.triangles;
  const double degrees = std::min(180.0, creases ? kSharp * crease_degrees : crease_degrees);
  const double cosine = std::cos(degrees * std::numbers::pi / 180);
  std::size_t edge = 0;  // advances in the order of the sides
  const auto is_crease = [&](const Side& side) {
    const auto before = [&](const Edge& e) { return e.v0 != side.low ? e.v0 < side.low : e.v1 < side.high; };
    while (edge < topology.edges.size() && before(topology.edges[edge])) ++edge;
    const bool found =
        edge < topology.edges.size() && topology.edges[edge].v0 == side.low && topology.edges[edge].v1 == side.high;
    return found && (*creases)[edge] == kCreaseLine;
  };
  std::vector<Point3> normals(scene.faces.size());
  parallel_for(normals.size(), [&](std::size_t f) { normals[f] = face_normal(scene, static_cast<std::uint32_t>(f)); });
  const std::vector<Side> sides = sides_of(triangles);
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high) ++end;
    if (end - i == 2 && !(creases && is_crease(sides[i]))) {
      const Side &a = sides[i], &b = sides[i + 1];
      const std::uint32_t faces[] = {triangles[a.triangle].face, triangles[b.triangle].face};
      const double turn = glm::dot(normals[faces[0]], normals[faces[1]]);
      if (faces[0] == faces[1] || (unlike_wound(triangles, a, b) ? -turn : turn) >= cosine) {
        mesh.triangles[a.triangle].across[a.corner] = b.triangle;
        mesh.triangles[b.triangle].across[b.corner] = a.triangle;
      }
    }
    i = end;
  }
}

/// Makes the windings of neighbours agree as far as possible. `node` holds vertices of the scene.
void wind_alike(FormMesh& mesh) {
  std::vector<char> seen(mesh.triangles.size(), 0);
  std::vector<std::uint32_t> open;
  for (std::uint32_t first = 0; first < mesh.triangles.size(); ++first) {
    if (seen[first]) continue;
    seen[first] = 1;
    open.assign(1, first);
    while (!open.empty()) {
      const std::uint32_t t = open.back();
      open.pop_back();
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t next = mesh.triangles[t].across[k];
        if (next == kNone || seen[next]) continue;
        seen[next] = 1;
        open.push_back(next);
        const auto [from, to] = std::pair(mesh.triangles[t].node[k], mesh.triangles[t].node[(k + 1) % 3]);
        FormTriangle& other = mesh.triangles[next];
        for (std::size_t m = 0; m < 3; ++m) {
          if (other.node[m] != from || other.node[(m + 1) % 3] != to) continue;
          std::swap(other.node[1], other.node[2]);
          std::swap(other.across[0], other.across[2]);
          break;
        }
      }
    }
  }
}

/// Replaces the scene vertices in `node` by nodes.
void make_nodes(const Scene& scene, FormMesh& mesh) {
  DisjointSets corners(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const FormTriangle& triangle = mesh.triangles[t];
    for (std::uint32_t k = 0; k < 3; ++k) {
      if (triangle.across[k] == kNone || triangle.across[k] < t) continue;
      const FormTriangle& other = mesh.triangles[triangle.across[k]];
      for (std::uint32_t m = 0; m < 3; ++m) {
        if (other.node[m] != triangle.node[(k + 1) % 3] || other.node[(m + 1) % 3] != triangle.node[k]) continue;
        corners.join(3 * t + (k + 1) % 3, 3 * triangle.across[k] + m);
        corners.join(3 * t + k, 3 * triangle.across[k] + (m + 1) % 3);
      }
    }
  }
  std::vector<std::uint32_t> number(3 * mesh.triangles.size());
  for (std::uint32_t c = 0; c < number.size(); ++c) {
    const std::uint32_t first = corners.find(c);
    std::uint32_t& node = mesh.triangles[c / 3].node[c % 3];
    if (first == c) {
      number[c] = static_cast<std::uint32_t>(mesh.points.size());
      mesh.vertex.push_back(node);
      mesh.points.push_back(scene.vertices[node]);
    } else {
      number[c] = number[first];
    }
    node = number[c];
  }
}

/// Computes the normals of nodes. Triangle normals are weighted by the angle at the node, so that the cutting of faces
/// does not matter.
void find_normals(FormMesh& mesh) {
  mesh.normals.assign(mesh.points.size(), {0, 0, 0});
  mesh.areas.assign(mesh.points.size(), 0);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const Point3 area = mesh.area_vector(t);
    const double size = glm::length(area);
    if (!(size > 0)) continue;
    for (int k = 0; k < 3; ++k) {
      const Point3 a = mesh.point(t, (k + 1) % 3) - mesh.point(t, k), b = mesh.point(t, (k + 2) % 3) - mesh.point(t, k);
      mesh.normals[mesh.triangles[t].node[k]] += area * (std::atan2(size, glm::dot(a, b)) / size);
      mesh.areas[mesh.triangles[t].node[k]] += size / 6;
    }
  }
  for (Point3& normal : mesh.normals) {
    const double length = glm::length(normal);
    normal = length > 0 ? normal / length : Point3{0, 0, 0};
  }
}

}  // namespace

Point3 FormMesh::area_vector(std::uint32_t triangle) const {
  return glm::cross(point(triangle, 1) - point(triangle, 0), point(triangle, 2) - point(triangle, 0));
}

FormMesh form_mesh(const Scene& scene, const Topology& topology, double crease_degrees,
                   const std::vector<std::uint8_t>* creases) {
  FormMesh mesh;
  mesh.first.assign(scene.faces.size() + 1, 0);
  for (const Triangle& triangle : topology.triangles) {
    mesh.triangles.push_back({triangle.v, {kNone, kNone, kNone}, triangle.face});
    ++mesh.first[triangle.face + 1];
  }
  for (std::size_t f = 0; f + 1 < mesh.first.size(); ++f) mesh.first[f + 1] += mesh.first[f];
  join_neighbours(scene, topology, crease_degrees, creases, mesh);
  wind_alike(mesh);
  make_nodes(scene, mesh);
  find_normals(mesh);
  return mesh;
}

Point3 unit(const Point3& v) {
  const double length = glm::length(v);
  return length > 0 ? v / length : Point3{0, 0, 0};
}

int corner_at(const FormMesh& mesh, std::uint32_t next, std::uint32_t node) {
  for (int k = 0; k < 3; ++k) {
    if (mesh.vertex[mesh.triangles[next].node[k]] == mesh.vertex[node]) return k;
  }
  return -1;
}

}  // namespace ligne
