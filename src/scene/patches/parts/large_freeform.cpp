#include "scene/patches/parts/large_freeform.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/no_index.hpp"
#include "scene/patches/borders/patch_outlines.hpp"
#include "scene/patches/facet_graph.hpp"
#include "scene/patches/freeform.hpp"
#include "scene/patches/patch_finder.hpp"

namespace ligne {
namespace {

// Adjustable.
/// Least number of triangles of a large object. The parts round the samples of a smaller one would be most of it.
constexpr std::uint32_t kFewestFaces = 150'000;
/// Number of samples, twice as many as PatchFinder::run() takes for the same number of successes: an object that seems free
/// here seems so there.
constexpr std::uint32_t kSamples = 128;
/// Number of faces round a sample: more than a surface is fitted to before it grows.
constexpr std::size_t kFacesAtSample = 400;
/// Largest part of the edges that may lie inside planes.
constexpr std::size_t kFlatShare = 64;
/// Rings of faces round those in planes: they contain kFewestFreeform facets. Rings round planes that may end free forms:
/// they contain what freeform_borders() looks at.
constexpr int kRingsRoundFlat = 2, kRingsRoundPlanes = 6;

/// A face at each of some edges, spread evenly: the one whose third corner is the lower, so that the order of faces does not
/// matter.
std::vector<std::uint32_t> sampled_faces(const TriangleObject& whole) {
  std::vector<std::uint32_t> faces;
  const auto sum = [&](std::uint32_t face) {
    const auto contour = whole.scene.faces.contour(face, 0);
    return std::accumulate(contour.begin(), contour.end(), std::uint64_t{0});
  };
  for (std::uint64_t i = 0; i < kSamples; ++i) {
    const Edge& edge = whole.edge((2 * i + 1) * whole.edge_count() / (2 * kSamples));
    const bool is_second = edge.face1 != kNone && sum(edge.face1) < sum(edge.face0);
    faces.push_back((is_second ? edge.face1 : edge.face0) - whole.object.face_begin);
  }
  return faces;
}

FacetGraph graph_of(const MeshPart& part) {
  const auto count = static_cast<std::uint32_t>(part.topology.edges.size());
  return facet_graph(part.scene, part.topology, part.scene.objects[0], 0, count, part.normals);
}

/// Whether hardly any surface is found near samples, and few faces lie in planes.
bool seems_free(const FaceWalk& walk) {
  const TriangleObject& whole = walk.whole();
  const std::vector<std::uint32_t> samples = sampled_faces(whole);
  FaceSet near_samples(whole);
  std::vector<std::uint32_t> reached_by(whole.face_count(), kNone), near;
  for (std::uint32_t i = 0; i < samples.size(); ++i) {
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
  const FacetGraph graph = graph_of(part);
  // The limit for all edges, with some room: there are 1.5 for each face.
  if (kFlatShare * (part.faces.size() - graph.size()) > 2 * part.faces.size()) return false;
  std::vector<std::uint32_t> facets;
  for (const std::uint32_t f : samples) {
    const auto at = std::ranges::lower_bound(part.faces, f);
    facets.push_back(graph.facet_of[static_cast<std::size_t>(at - part.faces.begin())]);
  }
  return PatchFinder(part.scene, part.topology, part.scene.objects[0], graph).seems_free(facets, whole.face_count());
}

/// The findings of a part of a free form.
class PartFindings {
 public:
  explicit PartFindings(const MeshPart& part)
      : part_(part), graph_(graph_of(part)), patch_of_(graph_.size(), kNone), freeform_(find_freeform()) {}

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
    return freeform_facets(part_.scene, part_.topology, graph_, patch_of_, rows);
  }

  const MeshPart& part_;
  FacetGraph graph_;
  std::vector<std::uint32_t> patch_of_;  ///< per facet: kNone
  std::vector<std::uint8_t> freeform_;   ///< per facet
};

}  // namespace

std::optional<LargeFreeform> find_large_freeform(const TriangleObject& whole) {
  if (whole.face_count() < kFewestFaces || !whole.scene.faces.all_triangles()) return std::nullopt;
  const FaceWalk walk(whole);
  if (!seems_free(walk)) return std::nullopt;
  const std::vector<std::uint32_t> joints =
      flat_joints(whole.scene, whole.topology, whole.object, whole.edges.begin, whole.edges.end, whole.normals);
  if (joints.size() > whole.edge_count() / kFlatShare) return std::nullopt;
  LargeFreeform found;
  found.is_freeform.assign(whole.face_count(), 1);
  FaceSet planes(whole);
  {
    FaceSet flat(whole);
    for (const std::uint32_t k : joints) {
      for (const std::uint32_t f : {whole.edge(k).face0, whole.edge(k).face1}) flat.add(f - whole.object.face_begin);
    }
    flat.add_rings(walk, kRingsRoundFlat);
    const MeshPart part = part_of(walk, flat);
    const PartFindings findings(part);
    findings.add_plane_edges(found.plane_edges);
    for (const std::uint32_t f : findings.faces_of_planes()) planes.add(f);
  }
  if (planes.faces.empty()) return found;
  // Facets at the border of that part may seem to be planes.
  const std::vector<std::uint8_t> may_be_plane = planes.holds;
  planes.add_rings(walk, kRingsRoundPlanes);
  const MeshPart part = part_of(walk, planes);
  PartFindings findings(part);
  for (const std::uint32_t f : findings.faces_of_planes()) {
    if (may_be_plane[f]) found.is_freeform[f] = 0;
  }
  found.borders = findings.borders(found.is_freeform);
  return found;
}

}  // namespace ligne
