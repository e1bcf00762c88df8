#include "scene/patches/parts/mesh_part.hpp"

#include <atomic>
#include <cstring>

#include "base/parallel.hpp"
#include "base/parallel_each.hpp"
#include "base/uninitialized_vector.hpp"

namespace ligne {
namespace {

/// The elements marked with 1, ascending; they are numbered from `first`.
std::vector<std::uint32_t> numbers_of(const std::vector<std::uint8_t>& marks, std::uint32_t first) {
  std::vector<std::uint32_t> numbers;
  // Few are marked: memchr passes many of the others at a time.
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const void* next = std::memchr(marks.data() + i, 1, marks.size() - i);
    if (!next) break;
    i = static_cast<std::size_t>(static_cast<const std::uint8_t*>(next) - marks.data());
    numbers.push_back(first + static_cast<std::uint32_t>(i));
  }
  return numbers;
}

/// The numbers of elements in a part, by their numbers in the whole less `first`. Others have any number.
class Numbers {
 public:
  Numbers(std::span<const std::uint32_t> elements, std::uint32_t first, std::uint32_t end)
      : first_(first), numbers_(end - first) {
    for (std::uint32_t i = 0; i < elements.size(); ++i) numbers_[elements[i] - first] = i;
  }
  std::uint32_t operator[](std::uint32_t element) const { return numbers_[element - first_]; }

 private:
  std::uint32_t first_;
  UninitializedVector<std::uint32_t> numbers_;
};

/// Several threads may mark the same element.
void mark(std::uint8_t& element) { std::atomic_ref(element).store(1, std::memory_order_relaxed); }

}  // namespace

void FaceSet::add_rings(const FaceWalk& walk, int rings) {
  std::size_t begin = 0;
  for (int ring = 0; ring < rings; ++ring) {
    for (const std::size_t end = faces.size(); begin < end; ++begin) {
      walk.for_neighbours(faces[begin], [&](std::uint32_t f) { add(f); });
    }
  }
}

MeshPart part_of(const FaceWalk& walk, const FaceSet& set) {
  const TriangleObject& whole = walk.whole();
  const Object& object = whole.object;
  const std::uint32_t first_face = object.face_begin;
  const auto holds = [&](std::uint32_t face) { return face != kNone && set.holds[face - first_face] != 0; };
  MeshPart part;
  part.faces = numbers_of(set.holds, 0);
  std::vector<std::uint8_t> has_vertex(object.vertex_end - object.vertex_begin, 0), has_edge(whole.edge_count(), 0);
  parallel_each(part.faces.size(), [&](std::size_t i) {
    for (const std::uint32_t v : whole.scene.faces.contour(first_face + part.faces[i], 0))
      mark(has_vertex[v - object.vertex_begin]);
    walk.for_edges(part.faces[i], [&](std::uint32_t k) { mark(has_edge[k]); });
  });
  const std::vector<std::uint32_t> vertices = numbers_of(has_vertex, object.vertex_begin);
  part.edges = numbers_of(has_edge, whole.edges.begin);
  const Numbers number_of_vertex(vertices, object.vertex_begin, object.vertex_end);
  const Numbers number_of_face(part.faces, 0, whole.face_count());

  part.scene.vertices.reserve(vertices.size());
  for (const std::uint32_t v : vertices) part.scene.vertices.push_back(whole.scene.vertices[v]);
  const std::span<std::uint32_t> corners = part.scene.faces.append_triangles(part.faces.size());
  part.normals.resize(part.faces.size());
  parallel_each(part.faces.size(), [&](std::size_t i) {
    const std::uint32_t f = first_face + part.faces[i];
    const auto contour = whole.scene.faces.contour(f, 0);
    for (std::size_t k = 0; k < 3; ++k) corners[3 * i + k] = number_of_vertex[contour[k]];
    part.normals[i] = whole.angles.normals[f];
  });
  part.topology.edges.resize(part.edges.size());
  part.topology.edge_flags.resize(part.edges.size());
  parallel_each(part.edges.size(), [&](std::size_t i) {
    Edge edge = whole.topology.edges[part.edges[i]];
    if (!holds(edge.face0)) std::swap(edge.face0, edge.face1);
    edge.v0 = number_of_vertex[edge.v0];
    edge.v1 = number_of_vertex[edge.v1];
    edge.face0 = holds(edge.face0) ? number_of_face[edge.face0 - first_face] : kNone;
    edge.face1 = holds(edge.face1) ? number_of_face[edge.face1 - first_face] : kNone;
    part.topology.edges[i] = edge;
    part.topology.edge_flags[i] = whole.topology.edge_flags[part.edges[i]];
    if (edge.face1 == kNone) part.topology.edge_flags[i] |= kEdgeBorder;
  });
  index_edges(part.topology, vertices.size());
  Object own = object;
  own.vertex_begin = own.face_begin = 0;
  own.vertex_end = static_cast<std::uint32_t>(vertices.size());
  own.face_end = static_cast<std::uint32_t>(part.faces.size());
  part.scene.objects.push_back(std::move(own));
  return part;
}

}  // namespace ligne
