#include "scene/patches/parts/large_freeform.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/indices_where.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "scene/patches/borders/patch_outlines.hpp"
#include "scene/patches/facet_graph.hpp"
#include "scene/patches/facets/flat_joints.hpp"
#include "scene/patches/freeform.hpp"
#include "scene/patches/search/patch_finder.hpp"

namespace ligne {
namespace {

// Adjustable.
/// Least number of triangles of a large object. The parts round the samples of a smaller one would be most of it.
constexpr std::uint32_t kFewestFaces = 150'000;
/// Number of samples, twice as many as PatchFinder::run() takes for the same number of successes: an object that seems free
/// here seems so there.
constexpr std::size_t kSamples = 128;
/// Number of faces round a sample: more than a surface is fitted to before it grows.
constexpr std::size_t kFacesAtSample = 400;
/// Largest part of the edges that may lie inside planes, or in pairs of triangles that may be planes.
constexpr std::size_t kFlatShare = 64;
/// With so many times as many joints an object is probably no free form.
constexpr std::size_t kManyJoints = 4;
/// Fewest faces of a plane without a large one, and least longest side of a large face, in mean lengths of edges.
constexpr std::size_t kFewestOfPlane = 16;
constexpr double kLargeSide = 4;
/// Rings of faces round those in planes: they contain kFewestFreeform facets. Rings round planes that may end free forms:
/// they contain what freeform_borders() looks at.
constexpr int kRingsRoundFlat = 2, kRingsRoundPlanes = 6;

/// One of kSamples edges of an object, spread evenly.
std::size_t sampled_edge(const TriangleObject& whole, std::size_t sample) {
  return (2 * sample + 1) * whole.edge_count() / (2 * kSamples);
}

/// A face at each of the sampled edges: the one whose third corner is the lower, so that the order of faces does not
/// matter.
std::vector<std::uint32_t> sampled_faces(const TriangleObject& whole) {
  std::vector<std::uint32_t> faces;
  const auto sum = [&](std::uint32_t face) {
    const auto contour = whole.scene.faces.contour(face, 0);
    return std::accumulate(contour.begin(), contour.end(), std::uint64_t{0});
  };
  for (std::size_t i = 0; i < kSamples; ++i) {
    const Edge& edge = whole.edge(sampled_edge(whole, i));
    const bool is_second = edge.face1 != kNone && sum(edge.face1) < sum(edge.face0);
    faces.push_back((is_second ? edge.face1 : edge.face0) - whole.object.face_begin);
  }
  return faces;
}

/// The graph of a part. `joints`: those of the whole object.
FacetGraph graph_of(const MeshPart& part, const TriangleObject& whole, std::span<const std::uint32_t> joints) {
  std::vector<std::uint32_t> own;
  auto joint = joints.begin();
  const auto count = static_cast<std::uint32_t>(part.topology.edges.size());
  for (std::uint32_t e = 0; e < count; ++e) {
    while (joint != joints.end() && whole.edges.begin + *joint < part.edges[e]) ++joint;
    if (joint == joints.end()) break;
    const bool is_joint = whole.edges.begin + *joint == part.edges[e];
    if (is_joint && part.topology.edges[e].face1 != kNone) own.push_back(e);
  }
  return facet_graph(part.scene, part.topology, part.scene.objects[0], {0, count}, part.normals, own);
}

/// Whether hardly any surface is found near samples, and few faces lie in planes.
bool seems_freeform(const FaceWalk& walk, std::span<const std::uint32_t> joints) {
  const TriangleObject& whole = walk.whole();
  const std::vector<std::uint32_t> samples = sampled_faces(whole);
  FaceSet near_samples(whole);
  constexpr std::uint8_t kNotReached = 255;
  static_assert(kSamples < kNotReached);
  std::vector<std::uint8_t> reached_by(whole.face_count(), kNotReached);
  std::vector<std::uint32_t> near;
  for (std::size_t sample = 0; sample < samples.size(); ++sample) {
    const auto i = static_cast<std::uint8_t>(sample);
    near.assign(1, samples[i]);
    reached_by[samples[i]] = i;
    for (std::size_t k = 0; k < near.size() && near.size() < kFacesAtSample; ++k) {
      walk.for_neighbours(near[k], [&](std::uint32_t f) {
        if (std::exchange(reached_by[f], i) != i) near.push_back(f);
      });
    }
    for (const std::uint32_t f : near) near_samples.add(f);
  }
  const MeshPart part = part_of(walk, near_samples);
  const FacetGraph graph = graph_of(part, whole, joints);
  // The limit for all edges, with some room: there are 1.5 for each face. Two triangles are seldom a plane.
  std::size_t in_planes = 0;
  for (std::uint32_t facet = 0; facet < graph.size(); ++facet) {
    if (const std::size_t count = graph.faces[facet].size(); count > 2) in_planes += count - 1;
  }
  if (kFlatShare * in_planes > 2 * part.faces.size()) return false;
  std::vector<std::uint32_t> facets;
  for (const std::uint32_t f : samples) {
    const auto at = std::ranges::lower_bound(part.faces, f);
    facets.push_back(graph.facet_of[static_cast<std::size_t>(at - part.faces.begin())]);
  }
  return PatchFinder(part.scene, part.topology, part.scene.objects[0], graph).seems_freeform(facets, whole.face_count());
}

/// Finds the joints of sets of faces that may be planes: sets of many faces, or with a large one. A few small triangles lie
/// in one plane by chance wherever a free form bends by little.
class PlaneJoints {
 public:
  PlaneJoints(const TriangleObject& whole, std::span<const std::uint32_t> joints)
      : whole_(whole), joints_(joints), joints_at_(whole.face_count(), 0), large_(large_side()) {
    for (const std::uint32_t k : joints) {
      for (const std::uint32_t f : faces_at(k)) ++joints_at_[f];
    }
  }

  std::vector<std::uint32_t> find() const {
    std::vector<std::uint32_t> found = indices_where(joints_.size(), [&](std::size_t i) {
      prefetch_faces_of(whole_.scene, whole_.topology, joints_, whole_.edges.begin, i);
      const auto [f, g] = faces_at(joints_[i]);
      return joints_at_[f] > 1 || joints_at_[g] > 1 || is_large(f) || is_large(g);
    });
    for (std::uint32_t& joint : found) joint = joints_[joint];
    std::vector<std::uint32_t> faces;
    faces.reserve(2 * found.size());
    for (const std::uint32_t k : found) {
      for (const std::uint32_t f : faces_at(k)) faces.push_back(f);
    }
    std::ranges::sort(faces);
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    const auto number_of = [&](std::uint32_t face) {
      return static_cast<std::size_t>(std::ranges::lower_bound(faces, face) - faces.begin());
    };
    DisjointSets sets(faces.size());
    std::vector<std::size_t> numbers;  // by joint found: that of its first face
    numbers.reserve(found.size());
    for (const std::uint32_t k : found) {
      const auto [f, g] = faces_at(k);
      sets.join(numbers.emplace_back(number_of(f)), number_of(g));
    }
    std::vector<std::size_t> sizes(faces.size(), 0);
    for (std::size_t i = 0; i < faces.size(); ++i) sizes[sets.find(i)] += is_large(faces[i]) ? kFewestOfPlane : 1;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (sizes[sets.find(numbers[i])] >= kFewestOfPlane) found[kept++] = found[i];
    }
    found.resize(kept);
    return found;
  }

 private:
  /// The faces at an edge, numbered from the first one of the object.
  std::array<std::uint32_t, 2> faces_at(std::uint32_t k) const {
    const Edge& edge = whole_.edge(k);
    return {edge.face0 - whole_.object.face_begin, edge.face1 - whole_.object.face_begin};
  }

  double squared_length(std::uint32_t v, std::uint32_t w) const {
    const Point3 along = whole_.scene.vertices[w] - whole_.scene.vertices[v];
    return glm::dot(along, along);
  }

  /// Square of the least longest side of a large face.
  double large_side() const {
    double sum = 0;
    for (std::size_t i = 0; i < kSamples; ++i) {
      const Edge& edge = whole_.edge(sampled_edge(whole_, i));
      sum += std::sqrt(squared_length(edge.v0, edge.v1));
    }
    const double side = kLargeSide * sum / kSamples;
    return side * side;
  }

  bool is_large(std::uint32_t face) const {
    const auto v = whole_.scene.faces.contour(whole_.object.face_begin + face, 0);
    return squared_length(v[0], v[1]) > large_ || squared_length(v[1], v[2]) > large_ || squared_length(v[2], v[0]) > large_;
  }

  const TriangleObject& whole_;
  std::span<const std::uint32_t> joints_;
  std::vector<std::uint8_t> joints_at_;  ///< per face of the object: number of its joints
  double large_;                         ///< see large_side()
};

/// The findings of a part of a free form.
class PartFindings {
 public:
  PartFindings(const MeshPart& part, const TriangleObject& whole, std::span<const std::uint32_t> joints)
      : part_(part), graph_(graph_of(part, whole, joints)), patch_of_(graph_.size(), kNone), freeform_(find_freeform()) {}

  /// The faces of the facets that are planes and have several faces, as numbers of the object. Single triangles are none.
  std::vector<std::uint32_t> faces_of_planes() const {
    std::vector<std::uint32_t> found;
    for (std::uint32_t facet = 0; facet < graph_.size(); ++facet) {
      if (freeform_[facet]) continue;
      for (const std::uint32_t f : graph_.faces[facet]) found.push_back(part_.faces[f]);
    }
    return found;
  }

  /// Appends the edges inside planes.
  void add_plane_edges(std::vector<std::uint32_t>& edges) const {
    const auto count = static_cast<std::uint32_t>(part_.topology.edges.size());
    for (const std::uint32_t e :
         edges_inside_planes(part_.topology, part_.scene.objects[0], graph_, 0, count, part_.normals))
      edges.push_back(part_.edges[e]);
  }

  /// The borders of planes; other facets count as free.
  std::vector<FreeformBorder> borders(const std::vector<std::uint8_t>& is_freeform_face) {
    for (std::uint32_t facet = 0; facet < graph_.size(); ++facet) {
      freeform_[facet] = is_freeform_face[part_.faces[graph_.faces[facet][0]]];
    }
    std::vector<FreeformBorder> found =
        freeform_borders(part_.scene, part_.topology, graph_, {{}, patch_of_, freeform_}, {});
    for (FreeformBorder& border : found) border.edge = part_.edges[border.edge];
    return found;
  }

 private:
  std::vector<std::uint8_t> find_freeform() const {
    const EdgeRows rows(part_.scene, part_.topology, part_.normals);
    return freeform_facets(part_.scene, part_.topology, graph_, {{}, patch_of_, {}}, rows);
  }

  const MeshPart& part_;
  FacetGraph graph_;
  std::vector<std::uint32_t> patch_of_;  ///< per facet: kNone
  std::vector<std::uint8_t> freeform_;   ///< per facet
};

/// The planes in a free form, and their borders. None if too many edges lie inside planes.
std::optional<LargeFreeform> planes_of_freeform(const FaceWalk& walk, std::span<const std::uint32_t> joints) {
  const TriangleObject& whole = walk.whole();
  const std::vector<std::uint32_t> in_planes = PlaneJoints(whole, joints).find();
  if (in_planes.size() > whole.edge_count() / kFlatShare) return std::nullopt;
  LargeFreeform found;
  found.is_freeform.assign(whole.face_count(), 1);
  FaceSet planes(whole);
  {
    FaceSet flat(whole);
    for (const std::uint32_t k : in_planes) {
      const Edge& edge = whole.edge(k);
      for (const std::uint32_t f : {edge.face0, edge.face1}) flat.add(f - whole.object.face_begin);
    }
    flat.add_rings(walk, kRingsRoundFlat);
    const MeshPart part = part_of(walk, flat);
    const PartFindings findings(part, whole, joints);
    findings.add_plane_edges(found.plane_edges);
    for (const std::uint32_t f : findings.faces_of_planes()) planes.add(f);
  }
  if (planes.faces.empty()) return found;
  // Facets at the border of that part may seem to be planes.
  const std::vector<std::uint8_t> may_be_plane = planes.holds;
  planes.add_rings(walk, kRingsRoundPlanes);
  const MeshPart part = part_of(walk, planes);
  PartFindings findings(part, whole, joints);
  for (const std::uint32_t f : findings.faces_of_planes()) {
    if (may_be_plane[f]) found.is_freeform[f] = 0;
  }
  found.borders = findings.borders(found.is_freeform);
  return found;
}

}  // namespace

std::optional<LargeFreeform> find_large_freeform(const TriangleObject& whole, std::vector<std::uint32_t>& joints) {
  joints = flat_joints(whole.scene, whole.topology, whole.object, whole.edges, whole.angles.normals, whole.angles.flat);
  if (whole.face_count() < kFewestFaces || !whole.scene.faces.all_triangles()) return std::nullopt;
  const FaceWalk walk(whole);
  // Both take about as long, and one thread for the most part. Nearly all objects of this size that have few joints are
  // free.
  bool is_free = false;
  std::optional<LargeFreeform> found;
  const bool has_many_joints = joints.size() > kManyJoints * (whole.edge_count() / kFlatShare);
  if (has_many_joints && !(is_free = seems_freeform(walk, joints))) return std::nullopt;
  parallel_tasks(2, [&](std::size_t task) {
    if (task == 0) {
      found = planes_of_freeform(walk, joints);
    } else if (!is_free) {
      is_free = seems_freeform(walk, joints);
    }
  });
  if (!is_free) return std::nullopt;
  return found;
}

}  // namespace ligne
